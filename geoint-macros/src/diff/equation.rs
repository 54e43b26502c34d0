//! Implicit steps as equations in the increment, with Newton's matrix.
//!
//! x₁ = x₀ + h J ḡ(x₀, x₁) for a mean gradient ḡ. If T is quadratic its mean gradient is that of the mean momentum, dq is
//! a linear function of dp, and the equation is one in dp alone.

use super::{Forward, Gradient, MissingSlope, discrete_gradient, gradient};
use crate::analyze::Structure;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};

/// residual(increment) = 0.
#[derive(Debug)]
pub(crate) struct Equation {
    /// What is solved for: momentum increments, or position and momentum increments.
    pub(crate) unknowns: Vec<Symbol>,
    pub(crate) residual: Vec<Id>,
    /// ∂residualᵢ/∂unknownⱼ, a row an equation.
    pub(crate) jacobian: Vec<Vec<Id>>,
    /// An explicit approximation of the unknowns.
    pub(crate) guess: Vec<Id>,
    /// The increments of q and p in terms of the unknowns.
    pub(crate) dq: Vec<Id>,
    pub(crate) dp: Vec<Id>,
}

/// y' = f(y, t), or q'' = f(q, t), with the derivative of f.
#[derive(Debug)]
pub(crate) struct Field {
    pub(crate) unknowns: Vec<Symbol>,
    pub(crate) f: Vec<Id>,
    pub(crate) jacobian: Vec<Vec<Id>>,
    /// 1 or 2.
    pub(crate) derivative: u32,
    /// q', for equations of second order.
    pub(crate) velocity: Vec<Id>,
    /// −∂V/∂q, for equations of second order.
    pub(crate) force: Vec<Id>,
}

fn symbols(of: fn(u32) -> Symbol, degrees: u32) -> Vec<Symbol> {
    (0..degrees).map(of).collect()
}

fn nodes(graph: &mut Graph, symbols: &[Symbol]) -> Vec<Id> {
    symbols.iter().map(|symbol| graph.symbol(*symbol)).collect()
}

/// t + h/2.
fn middle_time(graph: &mut Graph) -> Id {
    let (t, h) = (graph.symbol(Symbol::T), graph.symbol(Symbol::H));
    let half = graph.scale(Number::HALF, h);
    graph.add(t, half)
}

/// Every node of `roots` with symbols replaced.
fn substitute(graph: &mut Graph, roots: &[Id], replace: impl Fn(&mut Graph, Symbol) -> Option<Id>) -> Vec<Id> {
    let mut substitution = Substitution::new(replace);
    roots.iter().map(|root| substitution.apply(graph, *root)).collect()
}

/// ḡ = ∇H((x₀ + x₁)/2, t + h/2).
pub(crate) fn midpoint(graph: &mut Graph, gradient: &Gradient, structure: &Structure, degrees: u32) -> Equation {
    let mean = |graph: &mut Graph, roots: &[Id]| substitute(graph, roots, mean_point);
    let mean = Gradient { q: mean(graph, &gradient.q), p: mean(graph, &gradient.p) };
    equation(graph, gradient, &mean, structure, degrees)
}

fn mean_point(graph: &mut Graph, symbol: Symbol) -> Option<Id> {
    let increment = match symbol {
        Symbol::Q(i) => Symbol::Dq(i),
        Symbol::P(i) => Symbol::Dp(i),
        Symbol::T => return Some(middle_time(graph)),
        _ => return None,
    };
    let (start, increment) = (graph.symbol(symbol), graph.symbol(increment));
    let half = graph.scale(Number::HALF, increment);
    Some(graph.add(start, half))
}

/// ḡ is the tree discrete gradient of H at time t + h/2.
pub(crate) fn tree(
    graph: &mut Graph,
    gradient: &Gradient,
    structure: &Structure,
    degrees: u32,
) -> Result<Equation, MissingSlope> {
    let discrete = discrete_gradient(graph, structure.energy, degrees)?;
    let at_middle = |graph: &mut Graph, roots: &[Id]| {
        substitute(graph, roots, |graph, symbol| (symbol == Symbol::T).then(|| middle_time(graph)))
    };
    let mean = Gradient { q: at_middle(graph, &discrete.q), p: at_middle(graph, &discrete.p) };
    Ok(equation(graph, gradient, &mean, structure, degrees))
}

/// dq − h ḡ_p = 0, dp + h ḡ_q = 0.
fn equation(
    graph: &mut Graph,
    gradient: &Gradient,
    mean: &Gradient,
    structure: &Structure,
    degrees: u32,
) -> Equation {
    let h = graph.symbol(Symbol::H);
    let (dq, dp) = (symbols(Symbol::Dq, degrees), symbols(Symbol::Dp, degrees));
    let scaled = |graph: &mut Graph, factor: Id, ids: &[Id]| -> Vec<Id> {
        ids.iter().map(|id| graph.mul(factor, *id)).collect()
    };
    let minus_h = graph.neg(h);
    let drift = scaled(graph, h, &mean.p);
    let kick = scaled(graph, minus_h, &mean.q);
    let reduced = structure.quadratic_parts().is_some();
    let (unknowns, increments, targets) = if reduced {
        // The mean gradient of a quadratic T reads dp only, so that it gives dq.
        let kick = substitute(graph, &kick, |_, symbol| match symbol {
            Symbol::Dq(i) => Some(drift[i as usize]),
            _ => None,
        });
        let momenta = nodes(graph, &dp);
        (dp, [drift, momenta], kick)
    } else {
        let increments = [nodes(graph, &dq), nodes(graph, &dp)];
        ([dq, dp].concat(), increments, [drift, kick].concat())
    };
    let residual: Vec<Id> = unknowns
        .iter()
        .zip(&targets)
        .map(|(unknown, target)| {
            let unknown = graph.symbol(*unknown);
            graph.sub(unknown, *target)
        })
        .collect();
    let jacobian = jacobian(graph, &residual, &unknowns);
    let guess = guess(graph, gradient, reduced);
    let [dq, dp] = increments;
    Equation { unknowns, residual, jacobian, guess, dq, dp }
}

fn jacobian(graph: &mut Graph, roots: &[Id], unknowns: &[Symbol]) -> Vec<Vec<Id>> {
    let mut columns: Vec<Forward> = unknowns.iter().map(|symbol| Forward::new(*symbol)).collect();
    roots.iter().map(|root| columns.iter_mut().map(|column| column.of(graph, *root)).collect()).collect()
}

/// The explicit midpoint rule x₀ + h J∇H(x₀ + (h/2) J∇H(x₀)): two more orders than the increment itself, for one gradient
/// (that of q, if T is quadratic) more.
fn guess(graph: &mut Graph, gradient: &Gradient, reduced: bool) -> Vec<Id> {
    let h = graph.symbol(Symbol::H);
    let half = graph.scale(Number::HALF, h);
    let forward = |graph: &mut Graph, symbol: Symbol| {
        let (slope, sign) = match symbol {
            Symbol::Q(i) => (gradient.p[i as usize], Number::ONE),
            Symbol::P(i) => (gradient.q[i as usize], Number::MINUS_ONE),
            Symbol::T => return Some(middle_time(graph)),
            _ => return None,
        };
        let increment = graph.mul(half, slope);
        let increment = graph.scale(sign, increment);
        let start = graph.symbol(symbol);
        Some(graph.add(start, increment))
    };
    let mut roots = vec![];
    if !reduced {
        roots.extend(gradient.p.iter().map(|slope| graph.mul(h, *slope)));
    }
    for slope in &gradient.q {
        let kick = graph.mul(h, *slope);
        roots.push(graph.neg(kick));
    }
    substitute(graph, &roots, forward)
}

/// The vector field with its derivative; of second order in q if T is quadratic.
pub(crate) fn field(graph: &mut Graph, gradient: &Gradient, structure: &Structure, degrees: u32) -> Field {
    let force: Vec<Id> = gradient.q.iter().map(|slope| graph.neg(*slope)).collect();
    let second_order = structure.quadratic_parts().map(|parts| parts.kinetic);
    let (unknowns, f) = match second_order {
        Some(kinetic) => {
            // q'' = T'(−V'(q)) without the constant part of T'.
            let acceleration = substitute(graph, &gradient.p, |_, symbol| match symbol {
                Symbol::P(i) => Some(force[i as usize]),
                _ => None,
            });
            let at_rest = gradient_at_rest(graph, kinetic, degrees);
            let f = acceleration.iter().zip(at_rest).map(|(a, rest)| graph.sub(*a, rest)).collect();
            (symbols(Symbol::Q, degrees), f)
        }
        None => {
            let unknowns = [symbols(Symbol::Q, degrees), symbols(Symbol::P, degrees)].concat();
            (unknowns, [gradient.p.clone(), force.clone()].concat())
        }
    };
    let jacobian = jacobian(graph, &f, &unknowns);
    let derivative = if second_order.is_some() { 2 } else { 1 };
    Field { unknowns, f, jacobian, derivative, velocity: gradient.p.clone(), force }
}

/// ∂T/∂p at p = 0.
fn gradient_at_rest(graph: &mut Graph, kinetic: Id, degrees: u32) -> Vec<Id> {
    let slopes = gradient(graph, kinetic, degrees).p;
    substitute(graph, &slopes, |graph, symbol| matches!(symbol, Symbol::P(_)).then(|| graph.zero()))
}
