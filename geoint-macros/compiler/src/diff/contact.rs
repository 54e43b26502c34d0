//! The equations of implicit steps of contact systems, d = Φ(d) for an increment of x = (q, p, s).
//!
//! The field is that of hH, so that h meets the constants of every term and is prepared with them.

use super::field::{Field, middle};
use super::forward::jacobian;
use super::gradient::{Gradient, discrete_gradient, gradient};
use super::slope::Slopes;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Symbol};

/// The equation of a step from x.
pub(crate) struct Equation {
    /// Φ and its derivative.
    pub(crate) field: Field,
    /// What a solution d adds to x. Not a number if the step has none.
    pub(crate) end: Vec<Id>,
}

/// The midpoint rule in the symplectisation. At x + d/2, with p as it is before the step,
///
/// Φ = h (∂H/∂p, −∂H/∂q − p ∂H/∂s, (p + dp/2)·∂H/∂p − H),
///
/// and dp/(1 + h/2 ∂H/∂s) is added to p. With h/2 ∂H/∂s beyond ±1 the factor of the form would not be positive.
pub(crate) fn midpoint(graph: &mut Graph, energy: Id, degrees: u32) -> Equation {
    let n = degrees as usize;
    let action = times_h(graph, energy);
    let Gradient { q, p, s, .. } = gradient(graph, action, degrees);
    let mut there = Substitution::new(middle);
    let slopes = [q, p, vec![s]].concat().into_iter().map(|slope| there.apply(graph, slope)).collect::<Vec<Id>>();
    let (along_q, along_p, along_s) = (&slopes[..n], &slopes[n..2 * n], slopes[2 * n]);
    let value = there.apply(graph, action);
    let before: Vec<Id> = (0..degrees).map(|i| graph.symbol(Symbol::Momentum(i))).collect();
    let momenta: Vec<Id> = before.iter().map(|p| there.apply(graph, *p)).collect();

    let unknowns = unknowns(degrees);
    let mut hessian = jacobian(graph, &slopes, &unknowns);
    // Of two equal derivatives, which may be written differently, one is computed.
    for i in 0..hessian.len() {
        for j in 0..i {
            hessian[j][i] = hessian[i][j];
        }
    }
    let f = field(graph, [along_q, along_p, &[along_s]], &before, &momenta, value);
    let mut derivative = hessian[n..2 * n].to_vec();
    for i in 0..n {
        derivative
            .push((0..unknowns.len()).map(|j| force(graph, hessian[i][j], before[i], hessian[2 * n][j])).collect());
    }
    // The derivatives of p at ∂H/∂p and of H at p cancel.
    let action_row = (0..unknowns.len()).map(|j| {
        let column: Vec<Id> = hessian[n..2 * n].iter().map(|row| row[j]).collect();
        let power = graph.dot(&momenta, &column);
        let own = if (n..2 * n).contains(&j) { graph.zero() } else { graph.scale(Number::HALF, slopes[j]) };
        graph.sub(power, own)
    });
    derivative.push(action_row.collect());

    let mut end: Vec<Id> = unknowns.iter().map(|d| graph.symbol(*d)).collect();
    if !graph.is_zero(along_s) {
        let one = graph.integer(1);
        let half = graph.scale(Number::HALF, along_s);
        let (less, more) = (graph.sub(one, half), graph.add(one, half));
        let product = graph.mul(less, more);
        let positive = graph.call(Function::RecipPositive, &[product]);
        let factor = graph.mul(less, positive);
        for dp in &mut end[n..2 * n] {
            *dp = graph.mul(*dp, factor);
        }
    }
    Equation { field: Field { unknowns, f, jacobian: derivative }, end }
}

/// The discrete gradient g between x and x + d in the place of ∇H, with the mean momentum:
///
/// Φ = h (g_p, −g_q − p̄ g_s, p̄·g_p − H φ₁(−h g_s)) with H at x.
pub(crate) fn discrete(graph: &mut Graph, energy: Id, degrees: u32) -> Equation {
    let action = times_h(graph, energy);
    let Gradient { q, p, s, .. } = discrete_gradient(graph, action, degrees);
    let mut ends = Slopes::default();
    let mut mean = |i| {
        let p = graph.symbol(Symbol::Momentum(i));
        ends.mean(graph, p)
    };
    let momenta: Vec<Id> = (0..degrees).map(&mut mean).collect();
    let value = if graph.is_zero(s) {
        action
    } else {
        let decay = graph.neg(s);
        let mean = graph.call(Function::Phi1, &[decay]);
        graph.mul(action, mean)
    };
    let f = field(graph, [&q, &p, &[s]], &momenta, &momenta, value);
    let unknowns = unknowns(degrees);
    let jacobian = jacobian(graph, &f, &unknowns);
    let end = unknowns.iter().map(|d| graph.symbol(*d)).collect();
    Equation { field: Field { unknowns, f, jacobian }, end }
}

fn times_h(graph: &mut Graph, energy: Id) -> Id {
    let h = graph.symbol(Symbol::StepLength);
    graph.mul(h, energy)
}

fn unknowns(degrees: u32) -> Vec<Symbol> {
    (0..degrees)
        .map(Symbol::PositionIncrement)
        .chain((0..degrees).map(Symbol::MomentumIncrement))
        .chain([Symbol::ActionIncrement])
        .collect()
}

/// (g_p, −g_q − p g_s, p̄·g_p − value).
fn field(graph: &mut Graph, [q, p, s]: [&[Id]; 3], before: &[Id], momenta: &[Id], value: Id) -> Vec<Id> {
    let mut f = p.to_vec();
    f.extend(q.iter().zip(before).map(|(slope, p)| force(graph, *slope, *p, s[0])));
    let power = graph.dot(momenta, p);
    f.push(graph.sub(power, value));
    f
}

/// −slope − p·decay.
fn force(graph: &mut Graph, slope: Id, p: Id, decay: Id) -> Id {
    let drag = graph.mul(p, decay);
    let sum = graph.add(slope, drag);
    graph.neg(sum)
}
