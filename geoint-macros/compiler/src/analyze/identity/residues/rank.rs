//! Functional dependence of integrals, by the rank of their gradients.

use super::evaluate::{Halt, Plan, SquareRoots};
use super::{Bound, Element, Span, visit_combinations, visit_points};
use crate::ir::{Graph, Id};

/// The integrals that are functions of earlier ones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Dependent {
    /// Indices of integrals whose gradients are combinations of earlier gradients at every state. Proven, with this bound.
    pub(crate) integrals: Vec<usize>,
    pub(crate) bound: Bound,
}

/// Returns the dependent integrals, given their gradients; `None` if the rank cannot be decided. An integral that is not listed is independent,
/// unless a relation between functions is unknown here.
pub(in super::super) fn dependent(graph: &Graph, gradients: &[Vec<Id>]) -> Option<Dependent> {
    let all: Vec<Id> = gradients.concat();
    let plan = Plan::new(graph, &all)?;
    // A dependent gradient depends on the others at all points, for all signs.
    let mut is_independent = vec![false; gradients.len()];
    let bound = visit_points(&plan, &all, SquareRoots::BothSigns, &mut |point| {
        visit_combinations(point, &mut |evaluation| {
            let values = gradients.iter().map(|row| row.iter().map(|id| evaluation.number(*id)).collect());
            let values: Vec<Vec<Element>> = values.collect::<Result<_, Halt>>()?;
            let mut span = Span::new(evaluation.prime);
            for (is_independent, row) in is_independent.iter_mut().zip(values) {
                *is_independent |= span.add(row);
            }
            Ok(())
        })
    })?;
    let integrals = (0..gradients.len()).filter(|i| !is_independent[*i]).collect();
    Some(Dependent { integrals, bound })
}
