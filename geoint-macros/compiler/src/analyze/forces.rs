//! Forces without an energy: an applied force F(q, v, t), and friction −∂R/∂v with a function R that is not a quadratic form.

use super::identity;
use super::liouville::{Logarithm, antiderivative};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Reads, Symbol};

/// The forces that are added to p' = −∂H/∂q, or to ∂L/∂q.
#[derive(Debug)]
pub(crate) struct Forces {
    /// F, if the user applies a force.
    pub(crate) applied: Option<Vec<Id>>,
    /// ∂R/∂v, if friction is not of the form Cv.
    pub(crate) friction: Option<Vec<Id>>,
    /// The kinds of coordinates that the forces read.
    pub(crate) reads: Reads,
    /// −V, if F = −∇V(q). The user should add V to the energy.
    pub(crate) potential: Option<Id>,
}

impl Forces {
    /// Collects the forces. `None` if all are zero.
    pub(crate) fn of(graph: &mut Graph, applied: Option<Vec<Id>>, friction: Option<Vec<Id>>) -> Option<Forces> {
        let acts = |forces: &Vec<Id>| forces.iter().any(|force| !graph.is_zero(*force));
        let (applied, friction) = (applied.filter(acts), friction.filter(acts));
        applied.as_ref().or(friction.as_ref())?;
        let all = applied.iter().chain(&friction).flatten();
        let reads = all.fold(Reads::default(), |read, force| read.or(graph.reads(*force)));
        let potential = applied.as_ref().and_then(|applied| potential(graph, applied));
        Some(Forces { applied, friction, reads, potential })
    }

    /// Returns whether a force acts on coordinate `i`.
    pub(super) fn act_on(&self, graph: &Graph, i: u32) -> bool {
        self.applied.iter().chain(&self.friction).any(|forces| !graph.is_zero(forces[i as usize]))
    }

    /// Returns the forces at given velocities, in the order of coordinates. `place` moves a force to the point of evaluation first. Friction that
    /// would accelerate the motion is NaN.
    pub(crate) fn at(
        &self,
        graph: &mut Graph,
        velocities: &[Id],
        mut place: impl FnMut(&mut Graph, Id) -> Id,
    ) -> Vec<Id> {
        let mut at = |graph: &mut Graph, forces: &Vec<Id>| -> Vec<Id> {
            let mut there = |force: &Id| {
                let force = place(graph, *force);
                let velocity = |_: &mut Graph, symbol| match symbol {
                    Symbol::Velocity(i) => Some(velocities[i as usize]),
                    _ => None,
                };
                Substitution::new(velocity).apply(graph, force)
            };
            forces.iter().map(&mut there).collect()
        };
        let applied = self.applied.as_ref().map(|forces| at(graph, forces));
        let friction = self.friction.as_ref().map(|forces| at(graph, forces));
        let power = friction.as_ref().map(|friction| graph.dot(friction, velocities));
        let mut total = |i: usize| {
            let mut terms: Vec<Id> = applied.iter().map(|applied| applied[i]).collect();
            if let (Some(friction), Some(power)) = (&friction, power) {
                let drag = match graph.is_positive(power) || graph.is_zero(friction[i]) {
                    true => friction[i],
                    false => graph.call(Function::Provided, &[friction[i], power]),
                };
                terms.push(graph.neg(drag));
            }
            graph.sum(&terms)
        };
        (0..velocities.len()).map(&mut total).collect()
    }
}

/// Returns −V of F = −∇V(q), if F reads positions and parameters only and V is elementary.
fn potential(graph: &mut Graph, applied: &[Id]) -> Option<Id> {
    let of_positions = |symbol| matches!(symbol, Symbol::Position(_) | Symbol::Parameter(_));
    if applied.iter().any(|force| graph.reads_any(*force, |symbol| !of_positions(symbol))) {
        return None;
    }
    let positions: Vec<Symbol> = (0..applied.len() as u32).map(Symbol::Position).collect();
    let (potential, _) = antiderivative(graph, &positions, applied, Logarithm::OfMagnitude).ok()?;
    (!identity(graph, potential).is_zero()).then_some(potential)
}
