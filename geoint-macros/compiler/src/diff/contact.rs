//! The equations of implicit steps of contact systems, d = Φ(d) for the increment d of x = (q, p, s).
//!
//! Φ is the field of hH. The factor h thus meets the constants of every term, and is prepared with them.

use super::equations::{self, contact_force};
use super::field::{Field, symmetrise};
use super::forward::jacobian;
use super::gradient::{Gradient, discrete_gradient, gradient};
use super::slope::{Slopes, coordinate_in_middle};
use crate::ir::formula::call;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Symbol};

/// The equation of a step from x.
pub(crate) struct Equation {
    /// Φ and its derivative.
    pub(crate) field: Field,
    /// The increment of x that follows from a solution d. It is NaN at run time if the step has no solution.
    pub(crate) end: Vec<Id>,
}

/// The midpoint rule in the symplectisation. With derivatives at x + d/2 and p before the step,
///
/// Φ = h (∂H/∂p, −∂H/∂q − p ∂H/∂s, (p + dp/2)·∂H/∂p − H),
///
/// and the step adds dp/(1 + h/2 ∂H/∂s) to p. If h/2 ∂H/∂s is outside of ±1, the factor of the contact form would not be positive, and there is no
/// solution.
pub(crate) fn midpoint(graph: &mut Graph, energy: Id, degrees: u32) -> Equation {
    let n = degrees as usize;
    let action = times_h(graph, energy);
    let gradient = gradient(graph, action, degrees);
    let mut at_middle = Substitution::new(coordinate_in_middle);
    let mut moved = |nodes: &[Id]| nodes.iter().map(|node| at_middle.apply(graph, *node)).collect::<Vec<Id>>();
    let (q, p, s) = (moved(&gradient.q), moved(&gradient.p), moved(&[gradient.s])[0]);
    let value = moved(&[action])[0];
    let before = equations::momenta(graph, &gradient);
    let mean: Vec<Id> = before.iter().map(|p| at_middle.apply(graph, *p)).collect();

    let unknowns = unknowns(degrees);
    let mut hessian = jacobian(graph, &[&q[..], &p, &[s]].concat(), &unknowns);
    symmetrise(&mut hessian);
    let (by_q, by_p, by_s) = (&hessian[..n], &hessian[n..2 * n], &hessian[2 * n]);
    let slopes = Gradient { q, p, v: vec![], s };
    let f = equations::contact(graph, value, &slopes, &before, &mean).concat();
    let mut derivative = by_p.to_vec();
    for (row, p) in by_q.iter().zip(&before) {
        derivative.push(row.iter().zip(by_s).map(|(by_q, by_s)| contact_force(graph, *by_q, *p, *by_s)).collect());
    }
    // In the derivative of p̄·∂H/∂p − H by dp, the terms ½ ∂H/∂p cancel.
    let own = slopes.q.iter().map(Some).chain(slopes.p.iter().map(|_| None)).chain([Some(&slopes.s)]);
    let action_row = own.enumerate().map(|(j, own)| {
        let column: Vec<Id> = by_p.iter().map(|row| row[j]).collect();
        let power = graph.dot(&mean, &column);
        let own = match own {
            Some(own) => graph.scale(Number::HALF, *own),
            None => graph.zero(),
        };
        graph.sub(power, own)
    });
    derivative.push(action_row.collect());

    let mut end: Vec<Id> = unknowns.iter().map(|d| graph.symbol(*d)).collect();
    if !graph.is_zero(s) {
        let half = graph.scale(Number::HALF, s);
        let (less, more) = (graph.build(1 - half), graph.build(1 + half));
        let factor = graph.build(less * call(Function::RecipPositive, [less * more]));
        for dp in &mut end[n..2 * n] {
            *dp = graph.mul(*dp, factor);
        }
    }
    Equation { field: Field { unknowns, f, jacobian: derivative }, end }
}

/// The step with the discrete gradient g between x and x + d in place of ∇H, the mean momentum p̄, and H at x:
///
/// Φ = h (g_p, −g_q − p̄ g_s, p̄·g_p − H φ₁(−h g_s)).
pub(crate) fn discrete(graph: &mut Graph, energy: Id, degrees: u32) -> Equation {
    let action = times_h(graph, energy);
    let slopes = discrete_gradient(graph, action, degrees);
    let mut ends = Slopes::default();
    let mut mean = |i| {
        let p = graph.symbol(Symbol::Momentum(i));
        ends.mean(graph, p)
    };
    let mean: Vec<Id> = (0..degrees).map(&mut mean).collect();
    let value = if graph.is_zero(slopes.s) { action } else { graph.build(action * call(Function::Phi1, [-slopes.s])) };
    let f = equations::contact(graph, value, &slopes, &mean, &mean).concat();
    let field = Field::new(graph, unknowns(degrees), f);
    let end = field.unknowns.iter().map(|d| graph.symbol(*d)).collect();
    Equation { field, end }
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
