//! yᵀM⁻¹y by M = LDLᵀ, without M⁻¹.

use super::invariant::simplified;
use crate::analyze::vanishes;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};

/// A square, or a form of two, and what divides it.
pub(super) type Square = (Id, Id);

/// Why there is no such sum.
pub(super) enum NoForm {
    /// M is singular at every state: this combination of y is zero if y is Mv.
    Singular(Id),
    /// What is left of M has this entry, but none on its diagonal.
    NoPivot(Id),
}

/// yᵀM⁻¹y for a symmetric M, as a sum of squares; of two rows it is one form where either pivot might vanish at a state at which M is regular.
///
/// Zeros stay zeros, so that the pattern of M does: coordinates that couple to the fewest others come first.
pub(super) fn inverse_form(graph: &mut Graph, mass: &[Vec<Id>], y: &[Id]) -> Result<Vec<Square>, NoForm> {
    let (mut mass, mut y): (Vec<Vec<Id>>, Vec<Id>) = (mass.to_vec(), y.to_vec());
    let mut left: Vec<usize> = (0..y.len()).collect();
    let mut squares: Vec<(usize, Square)> = vec![];
    while !left.is_empty() {
        let k = match pivot(graph, &mass, &y, &left)? {
            Pivot::One(k) => k,
            Pivot::Two(pair, determinant) => {
                squares.push((pair[0], of_two(graph, &mass, &y, (pair, determinant))));
                break;
            }
        };
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
        squares.push((k, (square, d)));
    }
    squares.sort_by_key(|(k, _)| *k);
    Ok(squares.into_iter().map(|(_, square)| square).collect())
}

/// The sum; squares over equal pivots are one, as |p|²/m is written.
pub(super) fn sum(graph: &mut Graph, squares: &[Square]) -> Id {
    let mut terms: Vec<(Id, Vec<Id>)> = vec![];
    for (square, d) in squares {
        match terms.iter_mut().find(|(other, _)| other == d) {
            Some((_, sum)) => sum.push(*square),
            None => terms.push((*d, vec![*square])),
        }
    }
    let mut divided = vec![];
    for (d, sum) in terms {
        let sum = graph.sum(&sum);
        divided.push(graph.div(sum, d));
    }
    graph.sum(&divided)
}

/// What is eliminated next.
enum Pivot {
    One(usize),
    /// Both of two rows, with their determinant.
    Two([usize; 2], Id),
}

/// The next pivot: the one whose coordinate couples to the fewest others, of those that are not zero everywhere; of two rows one that vanishes at
/// no state, or both at once. (Larger matrices that move have no H, and there what is left of them is long.)
fn pivot(graph: &mut Graph, mass: &[Vec<Id>], y: &[Id], left: &[usize]) -> Result<Pivot, NoForm> {
    let couples = |graph: &Graph, i: usize| left.iter().filter(|j| !graph.is_zero(mass[i][**j])).count();
    let mut order = left.to_vec();
    order.sort_by_key(|i| couples(graph, *i));
    if let ([i, j], 2) = (&order[..], mass.len())
        && !graph.is_zero(mass[*i][*j])
    {
        let (i, j) = (*i, *j);
        if let Some(k) = order.iter().find(|i| vanishes_nowhere(graph, mass[**i][**i])) {
            return Ok(Pivot::One(*k));
        }
        let product = graph.mul(mass[i][i], mass[j][j]);
        let square = graph.pow(mass[i][j], Ratio::integer(2));
        let determinant = graph.sub(product, square);
        let determinant = simplified(graph, determinant);
        // It vanishes where M is singular, and nowhere else.
        if !vanishes(graph, determinant) {
            return Ok(Pivot::Two([i, j], determinant));
        }
    }
    if let Some(k) = order.iter().find(|i| !vanishes(graph, mass[**i][**i])) {
        return Ok(Pivot::One(*k));
    }
    let mut entries = left.iter().flat_map(|i| left.iter().map(|j| mass[*i][*j]));
    Err(entries.find(|entry| !vanishes(graph, *entry)).map_or(NoForm::Singular(y[left[0]]), NoForm::NoPivot))
}

/// Whether a node is seen to be no zero at any state: of parameters alone, positive, or negative.
fn vanishes_nowhere(graph: &mut Graph, id: Id) -> bool {
    if !graph.reads(id).moves() {
        return !vanishes(graph, id);
    }
    let opposite = graph.neg(id);
    graph.is_positive(id) || graph.is_positive(opposite)
}

/// The form of two coordinates with the mass matrix [a b; b c]: (c y₁² − 2b y₁y₂ + a y₂²)/(ac − b²).
fn of_two(graph: &mut Graph, mass: &[Vec<Id>], y: &[Id], ([i, j], determinant): ([usize; 2], Id)) -> Square {
    let both = graph.mul(y[i], y[j]);
    let [first, second] = [y[i], y[j]].map(|y| graph.pow(y, Ratio::integer(2)));
    let [first, both, second] =
        [(mass[j][j], first), (mass[i][j], both), (mass[i][i], second)].map(|(entry, y)| graph.mul(entry, y));
    let twice = graph.scale(Number::ONE.add(Number::ONE).neg(), both);
    (graph.sum(&[first, twice, second]), determinant)
}

/// p − a for the velocities of a part.
pub(super) fn reduced(graph: &mut Graph, velocities: &[u32], shift: &[Id]) -> Vec<Id> {
    let mut momentum = |(i, a): (&u32, &Id)| {
        let p = graph.symbol(Symbol::Momentum(*i));
        graph.sub(p, *a)
    };
    velocities.iter().zip(shift).map(&mut momentum).collect()
}
