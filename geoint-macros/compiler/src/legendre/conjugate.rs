//! Conjugates in closed form: the energy T(p) of a kinetic term K(v) that is not quadratic.

use super::{at_rest, is_velocity, quadratic};
use crate::analyze;
use crate::diff;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// A term with its conjugate.
pub(super) struct Conjugate {
    pub(super) term: Id,
    pub(super) energy: Id,
    pub(super) rule: &'static str,
}

/// A term scale·core that is not quadratic in velocities. The scale reads no velocity.
struct Curved<'a> {
    term: Id,
    scale: Id,
    core: Id,
    velocities: &'a [Symbol],
    /// p less the coefficients of the linear terms.
    momenta: &'a [Id],
}

/// Returns the terms of a Lagrangian. Sums with a factor are expanded if they read velocities.
pub(super) fn terms(graph: &mut Graph, root: Id) -> Vec<Id> {
    analyze::terms_where(graph, root, |reads| reads.v)
}

/// Returns the conjugate of a Lagrangian that consists of one curved term and linear terms in `velocities`.
pub(super) fn of(graph: &mut Graph, lagrangian: Id, velocities: &[u32]) -> Option<Conjugate> {
    let mut moving = terms(graph, lagrangian);
    moving.retain(|term| graph.reads(*term).v);
    let (linear, curved): (Vec<Id>, Vec<Id>) =
        moving.into_iter().partition(|term| analyze::is_polynomial_in(graph, &[*term], 1, is_velocity));
    let [term] = curved[..] else { return None };
    let symbols: Vec<Symbol> = velocities.iter().copied().map(Symbol::Velocity).collect();
    let linear = graph.sum(&linear);
    let shift = diff::jacobian(graph, &[linear], &symbols).concat();
    let momenta = quadratic::reduced(graph, velocities, &shift);
    let (number, rest) = graph.coefficient(term);
    let (core, scale): (Vec<Id>, Vec<Id>) = match graph.node(rest) {
        Node::Product(factors) => factors.iter().partition(|factor| graph.reads(**factor).v),
        _ => (vec![rest], vec![]),
    };
    let [core] = core[..] else { return None };
    let scale = graph.product(&scale);
    let scale = graph.scale(number, scale);
    let curved = Curved { term, scale, core, velocities: &symbols, momenta: &momenta };
    root(graph, &curved).or_else(|| power(graph, &curved)).or_else(|| elementary(graph, &curved))
}

/// A√S with S = S₀ + vᵀCv has the energy −A√(S₀(1 − pᵀC⁻¹p/A²)), or −AS₀√((1 − pᵀC⁻¹p/A²)/S₀) where S₀ may be negative.
fn root(graph: &mut Graph, curved: &Curved<'_>) -> Option<Conjugate> {
    let Curved { term, scale, core, velocities, momenta } = *curved;
    let Node::Power(base, exponent) = *graph.node(core) else { return None };
    if exponent != Ratio::HALF || !analyze::is_polynomial_in(graph, &[base], 2, is_velocity) {
        return None;
    }
    let slopes = diff::jacobian(graph, &[base], velocities).concat();
    let mut vanishes_at_rest = |slope: &Id| {
        let rest = at_rest(graph, *slope);
        graph.is_zero(rest)
    };
    if !slopes.iter().all(&mut vanishes_at_rest) {
        return None;
    }
    let constant = at_rest(graph, base);
    if graph.is_zero(constant) {
        return None;
    }
    let mut matrix = diff::jacobian(graph, &slopes, velocities);
    for entry in matrix.iter_mut().flatten() {
        let twice = at_rest(graph, *entry);
        *entry = graph.scale(Number::HALF, twice);
    }
    let squares = quadratic::inverse_form(graph, &matrix, momenta).ok()?;
    let form = quadratic::sum(graph, &squares);
    let square = graph.pow(scale, Ratio::integer(2));
    let ratio = graph.div(form, square);
    let one = graph.integer(1);
    let rest = graph.sub(one, ratio);
    let (energy, rule) = if graph.is_positive(constant) {
        let inside = graph.mul(constant, rest);
        let root = graph.sqrt(inside);
        (graph.mul(scale, root), "A√(S + v·Cv) has the energy −A√(S(1 − p·C⁻¹p/A²))")
    } else {
        let inside = graph.div(rest, constant);
        let root = graph.sqrt(inside);
        (graph.product(&[scale, constant, root]), "A√(S + v·Cv) has the energy −AS√((1 − p·C⁻¹p/A²)/S)")
    };
    Some(Conjugate { term, energy: graph.neg(energy), rule })
}

/// A|cv|ⁿ has the energy (n − 1) A |p/(nAc)|^(n/(n − 1)).
fn power(graph: &mut Graph, curved: &Curved<'_>) -> Option<Conjugate> {
    let Curved { term, scale, core, velocities: &[velocity], momenta: &[momentum] } = *curved else { return None };
    let (base, exponent) = match *graph.node(core) {
        Node::Power(base, exponent) if exponent.is_integer() && exponent.numerator % 2 == 0 => (base, exponent),
        Node::Power(base, exponent) => (inside_abs(graph, base)?, exponent),
        Node::Call(Function::Powf, ref args) => match graph.as_number(args[1])? {
            Number::Exact(exponent) => (inside_abs(graph, args[0])?, exponent),
            Number::Root(..) | Number::Float(_) => return None,
        },
        _ => return None,
    };
    let Affine { slope, rest } = affine(graph, base, velocity)?;
    if exponent <= Ratio::ONE || !graph.is_zero(rest) {
        return None;
    }
    let less = exponent.add(Ratio::ONE.neg())?;
    let conjugate = exponent.mul(less.recip()?)?;
    let factor = graph.mul(scale, slope);
    let factor = graph.scale(Number::Exact(exponent), factor);
    let ratio = graph.div(momentum, factor);
    let magnitude = graph.call(Function::Abs, &[ratio]);
    let exponent = graph.number(Number::Exact(conjugate));
    let power = graph.call(Function::Powf, &[magnitude, exponent]);
    let energy = graph.mul(scale, power);
    let energy = graph.scale(Number::Exact(less), energy);
    Some(Conjugate { term, energy, rule: "A|v|ⁿ has the energy (n − 1) A |p/(nA)|^(n/(n − 1))" })
}

/// Returns x of |x|.
fn inside_abs(graph: &Graph, id: Id) -> Option<Id> {
    match graph.node(id) {
        Node::Call(Function::Abs, args) => Some(args[0]),
        _ => None,
    }
}

/// slope·v + rest.
struct Affine {
    slope: Id,
    rest: Id,
}

/// Splits a node that is affine in a velocity.
fn affine(graph: &mut Graph, id: Id, velocity: Symbol) -> Option<Affine> {
    if !analyze::is_polynomial_in(graph, &[id], 1, is_velocity) {
        return None;
    }
    let slope = diff::jacobian(graph, &[id], &[velocity])[0][0];
    Some(Affine { slope: at_rest(graph, slope), rest: at_rest(graph, id) })
}

/// A f(cv + d) has the energy T(p/c) − d·p/c, where T(y) is the energy of A f(v).
fn elementary(graph: &mut Graph, curved: &Curved<'_>) -> Option<Conjugate> {
    let Curved { term, scale, core, velocities: &[velocity], momenta: &[momentum] } = *curved else { return None };
    let Node::Call(function, ref args) = *graph.node(core) else { return None };
    let argument = args[0];
    let (energy_of, rule): (fn(&mut Graph, Id, Id) -> Id, _) = match function {
        Function::Exp => (energy_of_exp, "A eᵛ has the energy p ln(p/A) − p"),
        Function::Ln => (energy_of_ln, "A ln v has the energy A − A ln(A/p)"),
        Function::Cosh => (energy_of_cosh, "A cosh v has the energy p asinh(p/A) − A√(1 + (p/A)²)"),
        _ => return None,
    };
    let Affine { slope, rest } = affine(graph, argument, velocity)?;
    let y = graph.div(momentum, slope);
    let energy = energy_of(graph, scale, y);
    let shift = graph.mul(y, rest);
    Some(Conjugate { term, energy: graph.sub(energy, shift), rule })
}

fn energy_of_exp(graph: &mut Graph, scale: Id, y: Id) -> Id {
    let ratio = graph.div(y, scale);
    let ln = graph.call(Function::Ln, &[ratio]);
    let product = graph.mul(y, ln);
    graph.sub(product, y)
}

fn energy_of_ln(graph: &mut Graph, scale: Id, y: Id) -> Id {
    let ratio = graph.div(scale, y);
    let ln = graph.call(Function::Ln, &[ratio]);
    let product = graph.mul(scale, ln);
    graph.sub(scale, product)
}

fn energy_of_cosh(graph: &mut Graph, scale: Id, y: Id) -> Id {
    let ratio = graph.div(y, scale);
    let asinh = graph.call(Function::Asinh, &[ratio]);
    let product = graph.mul(y, asinh);
    let square = graph.pow(ratio, Ratio::integer(2));
    let one = graph.integer(1);
    let sum = graph.add(one, square);
    let root = graph.sqrt(sum);
    let root = graph.mul(scale, root);
    graph.sub(product, root)
}
