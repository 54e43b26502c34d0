//! Conjugates in closed form: the energy T(p) that belongs to a term K(v) which is not quadratic.

use super::at_rest;
use super::mass::is_velocity;
use super::quadratic;
use super::quadratic::reduced;
use crate::analyze;
use crate::diff;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// A term with its conjugate.
pub(super) struct Conjugate {
    pub(super) term: Id,
    pub(super) energy: Id,
    pub(super) rule: &'static str,
}

/// The terms of a Lagrangian: sums that read velocities are taken apart.
pub(super) fn terms(graph: &mut Graph, root: Id) -> Vec<Id> {
    analyze::terms_where(graph, root, |reads| reads.v)
}

/// The conjugate of what L is in some velocities alone: one term that is not linear in them, and others that are.
pub(super) fn of(graph: &mut Graph, lagrangian: Id, velocities: &[u32]) -> Option<Conjugate> {
    let mut moving = terms(graph, lagrangian);
    moving.retain(|term| graph.reads(*term).v);
    let (linear, curved): (Vec<Id>, Vec<Id>) =
        moving.into_iter().partition(|term| analyze::is_polynomial_in(graph, &[*term], 1, is_velocity));
    let [term] = curved[..] else { return None };
    let symbols: Vec<Symbol> = velocities.iter().copied().map(Symbol::Velocity).collect();
    let linear = graph.sum(&linear);
    let shift = diff::jacobian(graph, &[linear], &symbols).concat();
    let y = reduced(graph, velocities, &shift);
    let (scale, core) = apart(graph, term)?;
    let (energy, rule) = RULES.iter().find_map(|rule| rule(graph, (scale, core), (&symbols, &y)))?;
    Some(Conjugate { term, energy, rule })
}

/// A term as a factor that reads no velocity and one that does.
fn apart(graph: &mut Graph, term: Id) -> Option<(Id, Id)> {
    let (number, rest) = graph.coefficient(term);
    let (core, scale): (Vec<Id>, Vec<Id>) = match graph.node(rest) {
        Node::Product(factors) => factors.iter().partition(|factor| graph.reads(**factor).v),
        _ => (vec![rest], vec![]),
    };
    let [core] = core[..] else { return None };
    let scale = graph.product(&scale);
    Some((graph.scale(number, scale), core))
}

/// From A and f(v), with velocities and the momenta p less those of linear terms, to the energy of A·f(v) and what the rule is called.
type Rule = fn(&mut Graph, (Id, Id), (&[Symbol], &[Id])) -> Option<(Id, &'static str)>;

/// All rules.
const RULES: [Rule; 3] = [root, power, elementary];

/// A√S with S = S₀ + vᵀCv: −A√(S₀(1 − pᵀC⁻¹p/A²)); −AS₀√((1 − pᵀC⁻¹p/A²)/S₀) where S₀ may be negative.
fn root(graph: &mut Graph, (scale, core): (Id, Id), (symbols, y): (&[Symbol], &[Id])) -> Option<(Id, &'static str)> {
    let Node::Power(base, exponent) = *graph.node(core) else { return None };
    if exponent != Ratio::HALF || !analyze::is_polynomial_in(graph, &[base], 2, is_velocity) {
        return None;
    }
    let slopes = diff::jacobian(graph, &[base], symbols).concat();
    if !slopes.iter().all(|slope| {
        let rest = at_rest(graph, *slope, |_| true);
        graph.is_zero(rest)
    }) {
        return None;
    }
    let constant = at_rest(graph, base, |_| true);
    if graph.is_zero(constant) {
        return None;
    }
    let twice = diff::jacobian(graph, &slopes, symbols);
    let matrix: Vec<Vec<Id>> = twice
        .iter()
        .map(|row| {
            row.iter()
                .map(|entry| {
                    let entry = at_rest(graph, *entry, |_| true);
                    graph.scale(Number::HALF, entry)
                })
                .collect()
        })
        .collect();
    let squares = quadratic::inverse_form(graph, &matrix, y).ok()?;
    let form = quadratic::sum(graph, &squares);
    let square = graph.pow(scale, Ratio::integer(2));
    let ratio = graph.div(form, square);
    let one = graph.integer(1);
    let rest = graph.sub(one, ratio);
    if graph.is_positive(constant) {
        let inside = graph.mul(constant, rest);
        let root = graph.sqrt(inside);
        let energy = graph.mul(scale, root);
        return Some((graph.neg(energy), "A√(S + v·Cv) has the energy −A√(S(1 − p·C⁻¹p/A²))"));
    }
    let inside = graph.div(rest, constant);
    let root = graph.sqrt(inside);
    let energy = graph.product(&[scale, constant, root]);
    Some((graph.neg(energy), "A√(S + v·Cv) has the energy −AS√((1 − p·C⁻¹p/A²)/S)"))
}

/// A|cv|ⁿ: (n − 1) A |p/(nAc)|^(n/(n − 1)).
fn power(graph: &mut Graph, (scale, core): (Id, Id), (symbols, y): (&[Symbol], &[Id])) -> Option<(Id, &'static str)> {
    let ([symbol], [y]) = (symbols, y) else { return None };
    let (base, exponent) = match *graph.node(core) {
        Node::Power(base, exponent) if exponent.is_integer() && exponent.numerator % 2 == 0 => (base, exponent),
        Node::Power(base, exponent) => (inside_abs(graph, base)?, exponent),
        Node::Call(Function::Powf, ref args) => match graph.as_number(args[1])? {
            Number::Exact(exponent) => (inside_abs(graph, args[0])?, exponent),
            Number::Root(..) | Number::Float(_) => return None,
        },
        _ => return None,
    };
    let (slope, at_zero) = affine(graph, base, *symbol)?;
    if exponent <= Ratio::ONE || !graph.is_zero(at_zero) {
        return None;
    }
    let less = exponent.add(Ratio::ONE.neg())?;
    let conjugate = exponent.mul(less.recip()?)?;
    let factor = graph.mul(scale, slope);
    let factor = graph.scale(Number::Exact(exponent), factor);
    let ratio = graph.div(*y, factor);
    let magnitude = graph.call(Function::Abs, &[ratio]);
    let exponent = graph.number(Number::Exact(conjugate));
    let power = graph.call(Function::Powf, &[magnitude, exponent]);
    let energy = graph.mul(scale, power);
    Some((graph.scale(Number::Exact(less), energy), "A|v|ⁿ has the energy (n − 1) A |p/(nA)|^(n/(n − 1))"))
}

fn inside_abs(graph: &Graph, id: Id) -> Option<Id> {
    match graph.node(id) {
        Node::Call(Function::Abs, args) => Some(args[0]),
        _ => None,
    }
}

/// c and d of c·v + d.
fn affine(graph: &mut Graph, id: Id, symbol: Symbol) -> Option<(Id, Id)> {
    if !analyze::is_polynomial_in(graph, &[id], 1, is_velocity) {
        return None;
    }
    let slope = diff::jacobian(graph, &[id], &[symbol])[0][0];
    Some((at_rest(graph, slope, |_| true), at_rest(graph, id, |_| true)))
}

/// A f(cv + d) for an f of the table: with y = p/c it is what the table says, less y·d.
fn elementary(
    graph: &mut Graph,
    (scale, core): (Id, Id),
    (symbols, y): (&[Symbol], &[Id]),
) -> Option<(Id, &'static str)> {
    let ([symbol], [p]) = (symbols, y) else { return None };
    let Node::Call(function, ref args) = *graph.node(core) else { return None };
    let (_, conjugate, rule) = ELEMENTARY.iter().find(|(of, ..)| *of == function)?;
    let (slope, at_zero) = affine(graph, args.clone()[0], *symbol)?;
    let y = graph.div(*p, slope);
    let energy = conjugate(graph, scale, y);
    let shift = graph.mul(y, at_zero);
    Some((graph.sub(energy, shift), rule))
}

/// The energy of A f(v) as a function of A and p.
type OfFunction = (Function, fn(&mut Graph, Id, Id) -> Id, &'static str);

const ELEMENTARY: [OfFunction; 3] = [
    (
        Function::Exp,
        |graph, scale, y| {
            let ratio = graph.div(y, scale);
            let ln = graph.call(Function::Ln, &[ratio]);
            let product = graph.mul(y, ln);
            graph.sub(product, y)
        },
        "A eᵛ has the energy p ln(p/A) − p",
    ),
    (
        Function::Ln,
        |graph, scale, y| {
            let ratio = graph.div(scale, y);
            let ln = graph.call(Function::Ln, &[ratio]);
            let product = graph.mul(scale, ln);
            graph.sub(scale, product)
        },
        "A ln v has the energy A − A ln(A/p)",
    ),
    (
        Function::Cosh,
        |graph, scale, y| {
            let ratio = graph.div(y, scale);
            let asinh = graph.call(Function::Asinh, &[ratio]);
            let product = graph.mul(y, asinh);
            let square = graph.pow(ratio, Ratio::integer(2));
            let one = graph.integer(1);
            let sum = graph.add(one, square);
            let root = graph.sqrt(sum);
            let root = graph.mul(scale, root);
            graph.sub(product, root)
        },
        "A cosh v has the energy p asinh(p/A) − A√(1 + (p/A)²)",
    ),
];
