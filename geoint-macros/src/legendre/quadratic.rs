//! yᵀM⁻¹y by M = LDLᵀ, without M⁻¹.

use crate::analyze;
use crate::ir::{Graph, Id, Ratio};

/// yᵀM⁻¹y for a symmetric M; `None` if M is singular at every state, or has no pivot on its diagonal.
///
/// Zeros stay zeros, so that the pattern of M does; where only one coordinate couples to others, it comes last. Squares over equal
/// pivots are one sum, as |p|²/m is written.
pub(super) fn inverse_form(graph: &mut Graph, mass: &[Vec<Id>], y: &[Id]) -> Option<Id> {
    let (mut mass, mut y): (Vec<Vec<Id>>, Vec<Id>) = (mass.to_vec(), y.to_vec());
    let mut left: Vec<usize> = (0..y.len()).collect();
    let mut squares: Vec<(usize, Id, Vec<Id>)> = vec![];
    while !left.is_empty() {
        let k = pivot(graph, &mass, &left)?;
        left.retain(|i| *i != k);
        let d = mass[k][k];
        let coupled: Vec<usize> = left.iter().copied().filter(|i| !graph.is_zero(mass[*i][k])).collect();
        for i in &coupled {
            let l = graph.div(mass[*i][k], d);
            for j in coupled.iter().filter(|j| *j <= i) {
                let fill = graph.mul(l, mass[*j][k]);
                let entry = graph.sub(mass[*i][*j], fill);
                (mass[*i][*j], mass[*j][*i]) = (entry, entry);
            }
            let part = graph.mul(l, y[k]);
            y[*i] = graph.sub(y[*i], part);
        }
        let square = graph.pow(y[k], Ratio::integer(2));
        match squares.iter_mut().find(|(_, other, _)| *other == d) {
            Some((_, _, sum)) => sum.push(square),
            None => squares.push((k, d, vec![square])),
        }
    }
    squares.sort_by_key(|(k, ..)| *k);
    let mut terms = vec![];
    for (_, d, sum) in squares {
        let sum = graph.sum(&sum);
        terms.push(graph.div(sum, d));
    }
    Some(graph.sum(&terms))
}

/// The next pivot: of those that are not zero everywhere the one whose coordinate couples to the fewest others.
fn pivot(graph: &mut Graph, mass: &[Vec<Id>], left: &[usize]) -> Option<usize> {
    let couples = |graph: &Graph, i: usize| left.iter().filter(|j| !graph.is_zero(mass[i][**j])).count();
    let mut order = left.to_vec();
    order.sort_by_key(|i| couples(graph, *i));
    order.into_iter().find(|i| !graph.is_zero(mass[*i][*i]) && !analyze::identity(graph, mass[*i][*i]).is_zero())
}
