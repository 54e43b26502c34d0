//! What implicit methods solve: the equation of a discrete gradient, and the field that collocation follows.
//!
//! If T is quadratic both are reduced to half of the unknowns. The mean gradient of T is then that of the mean momentum, so
//! that dq is a linear function of dp, and the differential equation is one of second order in q.

use super::forward::jacobian;
use super::{Gradient, MissingSlope, discrete_gradient};
use crate::analyze::Structure;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};

/// residual(increment) = 0.
#[derive(Debug)]
pub(crate) struct Equation {
    /// What is solved for: momentum increments, or position and momentum increments.
    pub(crate) unknowns: Vec<Symbol>,
    /// Position increments in terms of momentum increments, if those alone are solved for. What follows reads both.
    pub(crate) drift: Option<Vec<Id>>,
    pub(crate) residual: Vec<Id>,
    /// ∂residualᵢ/∂unknownⱼ, a row an equation.
    pub(crate) jacobian: Vec<Vec<Id>>,
    /// An explicit approximation of the unknowns.
    pub(crate) guess: Vec<Id>,
}

/// y' = f(y, t) for y = (q, p); or q'' = M⁻¹f(q, t) with the force f = −∂V/∂q.
#[derive(Debug)]
pub(crate) struct Field {
    pub(crate) unknowns: Vec<Symbol>,
    pub(crate) f: Vec<Id>,
    /// ∂f/∂y, times M⁻¹ for equations of second order.
    pub(crate) jacobian: Vec<Vec<Id>>,
    /// For equations of second order.
    pub(crate) second_order: Option<SecondOrder>,
}

/// What T adds to an equation of second order, as functions of the momenta.
#[derive(Debug)]
pub(crate) struct SecondOrder {
    /// ∂T/∂p.
    pub(crate) velocity: Vec<Id>,
    /// M⁻¹p.
    pub(crate) acceleration: Vec<Id>,
}

fn symbols(of: fn(u32) -> Symbol, degrees: u32) -> Vec<Symbol> {
    (0..degrees).map(of).collect()
}

fn nodes(graph: &mut Graph, symbols: &[Symbol]) -> Vec<Id> {
    symbols.iter().map(|symbol| graph.symbol(*symbol)).collect()
}

fn scaled(graph: &mut Graph, factor: Id, ids: &[Id]) -> Vec<Id> {
    ids.iter().map(|id| graph.mul(factor, *id)).collect()
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

/// x₁ = x₀ + h J ∇̄H(x₀, x₁) for the tree discrete gradient of H at time t + h/2:
/// dq − h ∇̄_pH = 0, dp + h ∇̄_qH = 0.
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
    let h = graph.symbol(Symbol::H);
    let minus_h = graph.neg(h);
    let slopes = [at_middle(graph, &discrete.q), at_middle(graph, &discrete.p)];
    let (kick, drift) = (scaled(graph, minus_h, &slopes[0]), scaled(graph, h, &slopes[1]));
    let (dq, dp) = (symbols(Symbol::Dq, degrees), symbols(Symbol::Dp, degrees));
    let guess = guess(graph, gradient, structure);
    let (q, p) = (nodes(graph, &dq), nodes(graph, &dp));
    if structure.quadratic_parts().is_none() {
        let unknowns = [dq, dp].concat();
        let residual = difference(graph, &[&q[..], &p].concat(), &[drift, kick].concat());
        let jacobian = jacobian(graph, &residual, &unknowns);
        return Ok(Equation { unknowns, drift: None, residual, jacobian, guess });
    }
    // ∂residual/∂dp = 1 − (∂kick/∂dq)·(∂dq/∂dp): the chain rule by hand keeps ∂dq/∂dp, a constant, out of every term.
    let inner = jacobian(graph, &kick, &dq);
    let outer = jacobian(graph, &drift, &dp);
    let residual = difference(graph, &p, &kick);
    let mut jacobian = product(graph, &inner, &outer);
    for (i, row) in jacobian.iter_mut().enumerate() {
        for (k, entry) in row.iter_mut().enumerate() {
            let unit = graph.integer(i64::from(i == k));
            *entry = graph.sub(unit, *entry);
        }
    }
    Ok(Equation { unknowns: dp, drift: Some(drift), residual, jacobian, guess })
}

fn difference(graph: &mut Graph, a: &[Id], b: &[Id]) -> Vec<Id> {
    a.iter().zip(b).map(|(a, b)| graph.sub(*a, *b)).collect()
}

/// The explicit midpoint rule h J∇H(x₀ + (h/2) J∇H(x₀)): one more order than h J∇H(x₀), for one more gradient.
fn guess(graph: &mut Graph, gradient: &Gradient, structure: &Structure) -> Vec<Id> {
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
    let minus_h = graph.neg(h);
    let kick = scaled(graph, minus_h, &gradient.q);
    let roots = match structure.quadratic_parts() {
        Some(_) => kick,
        None => [scaled(graph, h, &gradient.p), kick].concat(),
    };
    substitute(graph, &roots, forward)
}

/// The vector field, or the force if T is quadratic, with its derivative.
pub(crate) fn field(graph: &mut Graph, gradient: &Gradient, structure: &Structure, degrees: u32) -> Field {
    let force: Vec<Id> = gradient.q.iter().map(|slope| graph.neg(*slope)).collect();
    let (q, p) = (symbols(Symbol::Q, degrees), symbols(Symbol::P, degrees));
    if structure.quadratic_parts().is_none() {
        let (unknowns, f) = ([q, p].concat(), [gradient.p.clone(), force].concat());
        let mut jacobian = jacobian(graph, &f, &unknowns);
        // J∇²H, and ∇²H is symmetric: of two equal derivatives, which may be written differently, one is computed.
        let n = degrees as usize;
        for i in 0..n {
            for j in 0..n {
                jacobian[i][j] = graph.neg(jacobian[n + j][n + i]);
                if i < j {
                    jacobian[i][n + j] = jacobian[j][n + i];
                    jacobian[n + i][j] = jacobian[n + j][i];
                }
            }
        }
        return Field { unknowns, f, jacobian, second_order: None };
    }
    let inverse_mass = jacobian(graph, &gradient.p, &p);
    let slope = jacobian(graph, &force, &q);
    let momenta = nodes(graph, &p);
    let acceleration = product(graph, &inverse_mass, &momenta.iter().map(|p| vec![*p]).collect::<Vec<_>>()).concat();
    let jacobian = product(graph, &slope, &inverse_mass);
    let second_order = Some(SecondOrder { velocity: gradient.p.clone(), acceleration });
    Field { unknowns: q, f: force, jacobian, second_order }
}

/// The product of two matrices.
fn product(graph: &mut Graph, a: &[Vec<Id>], b: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let mut entry = |row: &[Id], column: usize| {
        let mut parts = vec![];
        for (x, y) in row.iter().zip(b) {
            if !graph.is_zero(*x) && !graph.is_zero(y[column]) {
                parts.push(graph.mul(*x, y[column]));
            }
        }
        graph.sum(&parts)
    };
    a.iter().map(|row| (0..b[0].len()).map(|column| entry(row, column)).collect()).collect()
}
