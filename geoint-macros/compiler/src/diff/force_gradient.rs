//! The kick of force-gradient methods: the flow of U = hV − g F·M⁻¹F with the force F = −∂V/∂q.
//!
//! ∂F/∂q is symmetric, so ∇(F·M⁻¹F) is twice the derivative of F along M⁻¹F. One forward derivative gives it, without a reverse sweep over F·M⁻¹F.

use super::forward::along;
use crate::ir::{Graph, Id, Number, Symbol};

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
    let twice = graph.scale(Number::integer(2), g);
    let direction: Vec<Id> = acceleration.iter().map(|change| graph.mul(twice, *change)).collect();
    let change = along(graph, force, |symbol| match symbol {
        Symbol::Position(i) => Some(direction[i as usize]),
        _ => None,
    });
    let (mut impulse, mut squares) = (vec![], vec![]);
    for (i, force) in force.iter().enumerate() {
        let plain = graph.mul(h, *force);
        impulse.push(graph.add(plain, change[i]));
        squares.push(graph.mul(*force, acceleration[i]));
    }
    let square = graph.sum(&squares);
    let (plain, correction) = (graph.mul(h, potential), graph.mul(g, square));
    GradientImpulse { impulse, energy: graph.sub(plain, correction) }
}
