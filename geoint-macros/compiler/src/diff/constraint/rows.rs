//! One constraint on velocities, A v + b = 0 with A and b as functions of q and t. A constraint g(q, t) = 0 has A = ∂g/∂q and b = ∂g/∂t.

use super::vectors::{ends, moved};
use crate::diff::forward::jacobian;
use crate::diff::gradient::discrete_gradient_with_time;
use crate::diff::slope::coordinate_in_middle;
use crate::ir::substitute::{Substitution, at_zero};
use crate::ir::{Graph, Id, Symbol};

/// One constraint.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// The user's function: g, or A v + b in terms of velocities.
    pub(crate) written: Id,
    /// g of g(q, t) = 0. Absent if only velocities are bound.
    pub(crate) value: Option<Id>,
    /// A.
    pub(crate) gradient: Vec<Id>,
    /// b.
    pub(crate) drift: Id,
}

impl Row {
    /// The row of g(q, t) = 0.
    pub(crate) fn of_positions(graph: &mut Graph, value: Id, degrees: u32) -> Row {
        let symbols: Vec<Symbol> = (0..degrees).map(Symbol::Position).chain([Symbol::Time]).collect();
        let mut gradient = jacobian(graph, &[value], &symbols).remove(0);
        let drift = gradient.pop().unwrap_or(value);
        Row { written: value, value: Some(value), gradient, drift }
    }

    /// The row of a function that is linear in velocities.
    pub(crate) fn of_velocities(graph: &mut Graph, function: Id, degrees: u32) -> Row {
        let symbols: Vec<Symbol> = (0..degrees).map(Symbol::Velocity).collect();
        let gradient = jacobian(graph, &[function], &symbols).remove(0);
        let drift = at_zero(graph, function, |symbol| matches!(symbol, Symbol::Velocity(_)));
        Row { written: function, value: None, gradient, drift }
    }

    /// A v + b.
    pub(super) fn rate(&self, graph: &mut Graph, velocity: &[Id]) -> Id {
        let along = graph.dot(&self.gradient, velocity);
        graph.add(along, self.drift)
    }

    /// Returns a number that is 0 if a step by the increments `dq` obeys the constraint: g at its end, or h times the mean of A v + b.
    pub(super) fn condition(&self, graph: &mut Graph, dq: &[Id]) -> Id {
        match self.value {
            Some(value) => {
                let (end, time) = (ends(graph, Symbol::Position, dq), graph.symbol(Symbol::StepEnd));
                moved(graph, &[value], &end, None, time)[0]
            }
            None => {
                let h = graph.symbol(Symbol::StepLength);
                let gradient = self.mean_gradient(graph);
                let drift = in_middle(graph, &[self.drift])[0];
                let along = graph.dot(&gradient, dq);
                graph.build(along + h * drift)
            }
        }
    }

    /// A between both ends of a step: divided differences of g, or A in the middle.
    pub(super) fn mean_gradient(&self, graph: &mut Graph) -> Vec<Id> {
        match self.value {
            Some(value) => discrete_gradient_with_time(graph, value, self.gradient.len() as u32).by_x,
            None => in_middle(graph, &self.gradient),
        }
    }
}

/// Nodes at the mean position of a step. The time of a step is that of its middle.
fn in_middle(graph: &mut Graph, nodes: &[Id]) -> Vec<Id> {
    let mut middle = Substitution::new(coordinate_in_middle);
    nodes.iter().map(|node| middle.apply(graph, *node)).collect()
}
