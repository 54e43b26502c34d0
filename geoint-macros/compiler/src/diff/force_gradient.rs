//! The kick of force-gradient methods: the flow of U = hV − g F·M⁻¹F with the force F = −∂V/∂q.
//!
//! ∂F/∂q is symmetric, so ∇(F·M⁻¹F) is twice the derivative of F along M⁻¹F. One forward derivative gives it, without a reverse sweep over F·M⁻¹F.

use super::forward::along;
use crate::ir::{Graph, Id, Symbol};

/// A kick with a force gradient.
#[derive(Clone, Debug)]
pub(crate) struct GradientImpulse {
    /// −∂U/∂q.
    pub(crate) impulse: Vec<Id>,
    /// U.
    pub(crate) energy: Id,
}

/// Builds the kick of V from the force and from the velocity ∂T/∂p of a quadratic T.
pub(crate) fn gradient_kick(graph: &mut Graph, potential: Id, force: &[Id], velocity: &[Id]) -> GradientImpulse {
    let [h, g] = [Symbol::StepLength, Symbol::GradientWeight].map(|symbol| graph.symbol(symbol));
    let acceleration = along(graph, velocity, |symbol| match symbol {
        Symbol::Momentum(i) => Some(force[i as usize]),
        _ => None,
    });
    let direction: Vec<Id> = acceleration.iter().map(|change| graph.build(2 * g * *change)).collect();
    let change = along(graph, force, |symbol| match symbol {
        Symbol::Position(i) => Some(direction[i as usize]),
        _ => None,
    });
    let (mut impulse, mut squares) = (vec![], vec![]);
    for (i, force) in force.iter().enumerate() {
        impulse.push(graph.build(h * *force + change[i]));
        squares.push(graph.mul(*force, acceleration[i]));
    }
    let square = graph.sum(&squares);
    GradientImpulse { impulse, energy: graph.build(h * potential - g * square) }
}
