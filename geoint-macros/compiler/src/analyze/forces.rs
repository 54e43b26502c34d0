//! Forces that no energy gives: F(q, v, t), and friction −∂R/∂v by a function R that is no quadratic form.

use super::{identity, liouville};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Reads, Symbol};

/// What is added to p' = −∂H/∂q, or to ∂L/∂q.
#[derive(Debug)]
pub(crate) struct Forces {
    /// F, if one is applied.
    pub(crate) applied: Option<Vec<Id>>,
    /// ∂R/∂v, if it is no damping Cv.
    pub(crate) friction: Option<Vec<Id>>,
    /// What all of them read.
    pub(crate) reads: Reads,
    /// −V if F = −∇V(q): it should be a term of the energy.
    pub(crate) potential: Option<Id>,
}

impl Forces {
    /// Nothing if both are zero.
    pub(crate) fn of(graph: &mut Graph, applied: Option<Vec<Id>>, friction: Option<Vec<Id>>) -> Option<Forces> {
        let some = |graph: &Graph, forces: &Vec<Id>| forces.iter().any(|force| !graph.is_zero(*force));
        let applied = applied.filter(|forces| some(graph, forces));
        let friction = friction.filter(|forces| some(graph, forces));
        applied.as_ref().or(friction.as_ref())?;
        let all = applied.iter().chain(&friction).flatten();
        let reads = all.fold(Reads::default(), |read, force| read.or(graph.reads(*force)));
        let potential = applied.as_ref().and_then(|applied| potential(graph, applied));
        Some(Forces { applied, friction, reads, potential })
    }

    /// Each of the two that there is, in the order of coordinates.
    pub(super) fn all(&self) -> impl Iterator<Item = &Vec<Id>> {
        self.applied.iter().chain(&self.friction)
    }

    /// The forces at velocities, in the order of coordinates. Friction that would feed the motion is not a number.
    pub(crate) fn at(
        &self,
        graph: &mut Graph,
        velocities: &[Id],
        mut place: impl FnMut(&mut Graph, Id) -> Id,
    ) -> Vec<Id> {
        let mut there = |graph: &mut Graph, force: Id| {
            let force = place(graph, force);
            let moving = |_: &mut Graph, symbol| match symbol {
                Symbol::Velocity(i) => Some(velocities[i as usize]),
                _ => None,
            };
            Substitution::new(moving).apply(graph, force)
        };
        let mut at = |graph: &mut Graph, forces: &Option<Vec<Id>>| -> Option<Vec<Id>> {
            forces.as_ref().map(|forces| forces.iter().map(|force| there(graph, *force)).collect())
        };
        let (applied, friction) = (at(graph, &self.applied), at(graph, &self.friction));
        let taken = friction.as_ref().map(|friction| {
            let terms: Vec<Id> = friction.iter().zip(velocities).map(|(slope, v)| graph.mul(*slope, *v)).collect();
            graph.sum(&terms)
        });
        (0..velocities.len())
            .map(|i| {
                let mut terms: Vec<Id> = applied.iter().map(|applied| applied[i]).collect();
                if let (Some(friction), Some(taken)) = (&friction, taken) {
                    let drag = match graph.is_positive(taken) || graph.is_zero(friction[i]) {
                        true => friction[i],
                        false => graph.call(Function::Provided, &[friction[i], taken]),
                    };
                    terms.push(graph.neg(drag));
                }
                graph.sum(&terms)
            })
            .collect()
    }
}

/// −V of F = −∇V(q), if F reads positions alone and V is elementary.
fn potential(graph: &mut Graph, applied: &[Id]) -> Option<Id> {
    let mut read = applied.iter().flat_map(|force| graph.symbols(*force));
    if read.any(|symbol| !matches!(symbol, Symbol::Position(_) | Symbol::Parameter(_))) {
        return None;
    }
    let positions: Vec<Symbol> = (0..applied.len() as u32).map(Symbol::Position).collect();
    let found = liouville::antiderivative(graph, &positions, applied, liouville::Logarithm::OfMagnitude).ok();
    found.map(|(potential, _)| potential).filter(|potential| !identity(graph, *potential).is_zero())
}
