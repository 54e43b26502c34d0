//! The form yᵀM⁻¹y, computed from M = LDLᵀ without M⁻¹.

use super::idle_coordinates::without_idle_coordinates;
use crate::analyze::vanishes;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};

/// One summand of yᵀM⁻¹y: a square, or a form of two coordinates, over its pivot or determinant.
pub(super) struct Quotient {
    numerator: Id,
    divisor: Id,
}

/// The reason why yᵀM⁻¹y has no formula.
pub(super) enum NoForm {
    /// M is singular at every state: this combination of y is zero for every y = Mv.
    Singular(Id),
    /// The rest of M contains this entry, but its diagonal is zero.
    NoPivot(Id),
}

/// Returns yᵀM⁻¹y for a symmetric M as a sum of squares. Two rows give one form if each pivot might vanish at a state at which M is regular.
///
/// Coordinates that couple to the fewest others are eliminated first, so zeros of M stay zeros.
pub(super) fn inverse_form(graph: &mut Graph, mass: &[Vec<Id>], y: &[Id]) -> Result<Vec<Quotient>, NoForm> {
    let (mut mass, mut y): (Vec<Vec<Id>>, Vec<Id>) = (mass.to_vec(), y.to_vec());
    let mut left: Vec<usize> = (0..y.len()).collect();
    let mut squares: Vec<(usize, Quotient)> = vec![];
    while !left.is_empty() {
        let k = match pivot(graph, &mass, &y, &left)? {
            Pivot::One(k) => k,
            Pivot::Two { i, j, determinant } => {
                let numerator = adjugate_form(graph, &mass, &y, i, j);
                squares.push((i, Quotient { numerator, divisor: determinant }));
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
        squares.push((k, Quotient { numerator: square, divisor: d }));
    }
    squares.sort_by_key(|(k, _)| *k);
    Ok(squares.into_iter().map(|(_, square)| square).collect())
}

/// Returns the sum of quotients. Squares over equal pivots share one division, as in |p|²/m.
pub(super) fn sum(graph: &mut Graph, quotients: &[Quotient]) -> Id {
    let mut groups: Vec<(Id, Vec<Id>)> = vec![];
    for Quotient { numerator, divisor } in quotients {
        match groups.iter_mut().find(|(other, _)| other == divisor) {
            Some((_, numerators)) => numerators.push(*numerator),
            None => groups.push((*divisor, vec![*numerator])),
        }
    }
    let mut terms = vec![];
    for (divisor, numerators) in groups {
        let numerator = graph.sum(&numerators);
        terms.push(graph.div(numerator, divisor));
    }
    graph.sum(&terms)
}

/// The coordinates to eliminate next.
enum Pivot {
    One(usize),
    /// The last two coordinates together.
    Two {
        i: usize,
        j: usize,
        determinant: Id,
    },
}

/// Chooses the coordinate that couples to the fewest others and has a pivot that does not vanish everywhere. A matrix of two rows needs a pivot that
/// vanishes at no state; without such a pivot, both rows are eliminated together. Larger matrices that move have no H, because their minors are long.
fn pivot(graph: &mut Graph, mass: &[Vec<Id>], y: &[Id], left: &[usize]) -> Result<Pivot, NoForm> {
    let couples = |graph: &Graph, i: usize| left.iter().filter(|j| !graph.is_zero(mass[i][**j])).count();
    let mut order = left.to_vec();
    order.sort_by_key(|i| couples(graph, *i));
    if let (&[i, j], 2) = (&order[..], mass.len())
        && !graph.is_zero(mass[i][j])
    {
        if let Some(k) = order.iter().find(|i| vanishes_nowhere(graph, mass[**i][**i])) {
            return Ok(Pivot::One(*k));
        }
        let product = graph.mul(mass[i][i], mass[j][j]);
        let square = graph.pow(mass[i][j], Ratio::integer(2));
        let determinant = graph.sub(product, square);
        let determinant = without_idle_coordinates(graph, determinant);
        // The determinant vanishes exactly where M is singular.
        if !vanishes(graph, determinant) {
            return Ok(Pivot::Two { i, j, determinant });
        }
    }
    if let Some(k) = order.iter().find(|i| !vanishes(graph, mass[**i][**i])) {
        return Ok(Pivot::One(*k));
    }
    let mut entries = left.iter().flat_map(|i| left.iter().map(|j| mass[*i][*j]));
    Err(entries.find(|entry| !vanishes(graph, *entry)).map_or(NoForm::Singular(y[left[0]]), NoForm::NoPivot))
}

/// Returns whether a node is proven to have no zero at any state: it reads parameters only, or its form implies its sign.
fn vanishes_nowhere(graph: &mut Graph, id: Id) -> bool {
    if !graph.reads(id).moves() {
        return !vanishes(graph, id);
    }
    let opposite = graph.neg(id);
    graph.is_positive(id) || graph.is_positive(opposite)
}

/// Returns c yᵢ² − 2b yᵢyⱼ + a yⱼ² for the mass matrix [a b; b c] of two coordinates.
fn adjugate_form(graph: &mut Graph, mass: &[Vec<Id>], y: &[Id], i: usize, j: usize) -> Id {
    let both = graph.mul(y[i], y[j]);
    let [first, second] = [y[i], y[j]].map(|y| graph.pow(y, Ratio::integer(2)));
    let [first, both, second] =
        [(mass[j][j], first), (mass[i][j], both), (mass[i][i], second)].map(|(entry, y)| graph.mul(entry, y));
    let twice = graph.scale(Number::integer(-2), both);
    graph.sum(&[first, twice, second])
}

/// Returns p − a for some velocities.
pub(super) fn reduced(graph: &mut Graph, velocities: &[u32], shift: &[Id]) -> Vec<Id> {
    let mut momentum = |(i, a): (&u32, &Id)| {
        let p = graph.symbol(Symbol::Momentum(*i));
        graph.sub(p, *a)
    };
    velocities.iter().zip(shift).map(&mut momentum).collect()
}
