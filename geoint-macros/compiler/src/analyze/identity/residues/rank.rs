//! How many of several gradients are independent.

use super::evaluate::{Halt, Plan};
use super::{Bound, Element, Prime, visit_combinations, visit_points};
use crate::ir::{Graph, Id};

/// The rank of rows, and which of them depend on those before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Rank {
    /// Rows that are combinations of earlier ones at every state: proven, with this bound.
    pub(crate) dependent: Vec<usize>,
    pub(crate) bound: Bound,
}

/// The rank of a matrix whose entries are nodes; `None` if it cannot be decided. Rows that are said to be independent are so unless a
/// relation between functions is not known here.
pub(crate) fn rank(graph: &Graph, rows: &[Vec<Id>]) -> Option<Rank> {
    let all: Vec<Id> = rows.concat();
    let plan = Plan::new(graph, &all)?;
    // A row is dependent if it is at all points, for all signs.
    let mut independent = vec![false; rows.len()];
    let bound = visit_points(&plan, &all, false, &mut |point| {
        visit_combinations(point, &mut |evaluation| {
            let prime = evaluation.prime;
            let values = rows.iter().map(|row| row.iter().map(|id| evaluation.number(*id)).collect());
            let values: Vec<Vec<Element>> = values.collect::<Result<_, Halt>>()?;
            for row in pivots(prime, values) {
                independent[row] = true;
            }
            Ok(())
        })?;
        Ok(true)
    })?;
    let dependent = (0..rows.len()).filter(|row| !independent[*row]).collect();
    Some(Rank { dependent, bound })
}

/// Rows that are no combinations of earlier ones.
fn pivots(prime: Prime, mut rows: Vec<Vec<Element>>) -> Vec<usize> {
    let mut pivots: Vec<(usize, usize)> = vec![];
    for i in 0..rows.len() {
        for (row, column) in &pivots {
            let factor = prime.negative(rows[i][*column]);
            for k in 0..rows[i].len() {
                let product = prime.product(factor, rows[*row][k]);
                rows[i][k] = prime.sum(rows[i][k], product);
            }
        }
        let Some(column) = rows[i].iter().position(|x| !x.is_zero()) else { continue };
        let Some(scale) = prime.reciprocal(rows[i][column]) else { continue };
        rows[i].iter_mut().for_each(|x| *x = prime.product(*x, scale));
        pivots.push((i, column));
    }
    pivots.into_iter().map(|(row, _)| row).collect()
}
