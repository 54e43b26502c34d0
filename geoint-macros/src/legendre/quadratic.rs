//! yᵀM⁻¹y by M = LDLᵀ, without M⁻¹.

use super::invariant::simplified;
use crate::analyze::{self, vanishes};
use crate::ir::{Graph, Id, Ratio, Symbol};

/// A square, or a form of two, and what divides it.
pub(super) type Square = (Id, Id);

/// Why there is no such sum.
pub(super) enum NoForm {
    /// M is singular at every state: this combination of y is zero if y is Mv.
    Singular(Id),
    /// What is left of M has this entry, but none on its diagonal.
    NoPivot(Id),
}

/// yᵀM⁻¹y for a symmetric M, as a sum of squares; where every pivot might vanish at a state at which M is regular, of forms of two.
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
                left.retain(|i| !pair.contains(i));
                squares.push((pair[0], of_two(graph, (&mut mass, &mut y), &left, (pair, determinant))));
                continue;
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
    /// Two at once, with the determinant of their block.
    Two([usize; 2], Id),
}

/// The next pivot: of those that do not vanish at any state the one whose coordinate couples to the fewest others; or two of which that is
/// known; or one that is not zero everywhere.
fn pivot(graph: &mut Graph, mass: &[Vec<Id>], y: &[Id], left: &[usize]) -> Result<Pivot, NoForm> {
    let couples = |graph: &Graph, i: usize| left.iter().filter(|j| !graph.is_zero(mass[i][**j])).count();
    let mut order = left.to_vec();
    order.sort_by_key(|i| couples(graph, *i));
    if let Some(k) = order.iter().find(|i| vanishes_nowhere(graph, mass[**i][**i])) {
        return Ok(Pivot::One(*k));
    }
    let coupled = order.iter().flat_map(|i| order.iter().map(move |j| (*i, *j)));
    for (i, j) in coupled.filter(|(i, j)| i != j && !graph.is_zero(mass[*i][*j])).collect::<Vec<_>>() {
        let product = graph.mul(mass[i][i], mass[j][j]);
        let square = graph.pow(mass[i][j], Ratio::integer(2));
        let determinant = graph.sub(product, square);
        let determinant = simplified(graph, determinant);
        // Of the last two it vanishes nowhere but where M is singular.
        if vanishes_nowhere(graph, determinant) || left.len() == 2 && !vanishes(graph, determinant) {
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
    let reads = analyze::reads(graph, id);
    if !reads.state() && !reads.t {
        return !vanishes(graph, id);
    }
    let opposite = graph.neg(id);
    analyze::is_positive(graph, id) || analyze::is_positive(graph, opposite)
}

/// Eliminates two coordinates, [a b; b c] with this determinant: their form (c yᵢ² − 2b yᵢyⱼ + a yⱼ²)/(ac − b²).
fn of_two(
    graph: &mut Graph,
    (mass, y): (&mut [Vec<Id>], &mut [Id]),
    left: &[usize],
    ([i, j], determinant): ([usize; 2], Id),
) -> Square {
    let (a, b, c) = (mass[i][i], mass[i][j], mass[j][j]);
    // The block's inverse times two numbers, but for the determinant.
    let solved = |graph: &mut Graph, [x, y]: [Id; 2]| {
        let [cx, by, bx, ay] = [(c, x), (b, y), (b, x), (a, y)].map(|(entry, of)| graph.mul(entry, of));
        [graph.sub(cx, by), graph.sub(ay, bx)]
    };
    let over = |graph: &mut Graph, [x, y]: [Id; 2], [u, w]: [Id; 2]| {
        let [first, second] = [graph.mul(x, u), graph.mul(y, w)];
        let sum = graph.add(first, second);
        graph.div(sum, determinant)
    };
    let own = [y[i], y[j]];
    let inverse = solved(graph, own);
    let coupled: Vec<(usize, [Id; 2])> = left.iter().map(|k| (*k, [mass[*k][i], mass[*k][j]])).collect();
    for (k, row) in &coupled {
        let part = over(graph, *row, inverse);
        y[*k] = graph.sub(y[*k], part);
        let inverse = solved(graph, *row);
        for (l, other) in coupled.iter().filter(|(l, _)| l <= k) {
            let fill = over(graph, *other, inverse);
            let entry = graph.sub(mass[*k][*l], fill);
            (mass[*k][*l], mass[*l][*k]) = (entry, entry);
        }
    }
    let [first, second] = [graph.mul(own[0], inverse[0]), graph.mul(own[1], inverse[1])];
    (graph.add(first, second), determinant)
}

/// p − a for the velocities of a part.
pub(super) fn reduced(graph: &mut Graph, velocities: &[u32], shift: &[Id]) -> Vec<Id> {
    let mut momentum = |(i, a): (&u32, &Id)| {
        let p = graph.symbol(Symbol::P(*i));
        graph.sub(p, *a)
    };
    velocities.iter().zip(shift).map(&mut momentum).collect()
}
