//! The multipliers μ of a state, with which its motion p' = f + Aᵀμ obeys the constraints: (A v + b)' = 0.

use super::Constrained;
use super::elimination::Factors;
use super::vectors::{combination, sums};
use crate::diff::forward::along;
use crate::ir::{Graph, Id, Symbol};

impl Constrained<'_> {
    /// Solves (A W Aᵀ) μ = −(A v + b)' for all rows. The rate on the right is that of the motion without multipliers.
    pub(crate) fn multipliers(&self, graph: &mut Graph) -> Vec<Id> {
        let rates = self.rates(graph);
        let force = self.free_force(graph);
        let one = graph.integer(1);
        let changes = along(graph, &rates, |symbol| match symbol {
            Symbol::Position(i) => Some(self.velocity[i as usize]),
            Symbol::Momentum(i) => Some(force[i as usize]),
            Symbol::Time => Some(one),
            _ => None,
        });
        let rhs: Vec<Id> = changes.iter().map(|change| graph.neg(*change)).collect();
        let inertia = self.inertia(graph);
        Factors::of(graph, &inertia).solve(graph, &rhs)
    }

    /// p' with these multipliers.
    pub(crate) fn bound_force(&self, graph: &mut Graph, multipliers: &[Id]) -> Vec<Id> {
        let pull = combination(graph, &self.gradients(), multipliers);
        let force = self.free_force(graph);
        sums(graph, &force, &pull)
    }

    /// p' without multipliers: f, or f − γp beside an action.
    fn free_force(&self, graph: &mut Graph) -> Vec<Id> {
        let mut force = self.force.to_vec();
        if let Some(action) = self.action {
            for (i, force) in (0..).zip(&mut force) {
                let p = graph.symbol(Symbol::Momentum(i));
                *force = graph.build(*force - action.decay * p);
            }
        }
        force
    }

    /// The multipliers as users see them: λ of p' = f − Gᵀλ + Aᵀμ for constraints of positions.
    pub(crate) fn shown(&self, graph: &mut Graph, multipliers: &[Id]) -> Vec<Id> {
        let shown = self.rows.iter().zip(multipliers);
        shown.map(|(row, multiplier)| if row.value.is_some() { graph.neg(*multiplier) } else { *multiplier }).collect()
    }
}
