//! Values of sums in floating point, compared with their rounding errors. They prove nothing. They select the answer for identities without a
//! proof.

mod sized;

use super::OpenBoundaries;
use super::residues::pseudorandom;
use crate::ir::{Graph, Id, Ratio, Symbol};
pub(super) use sized::State;
use sized::{Evaluation, Sized};

/// A direction in the space of positions: rates by symbol.
pub(crate) type Direction = Vec<(Symbol, Ratio)>;

/// The result of an evaluation in floating point.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shown {
    /// The sum is zero to rounding at all visited states.
    Zero,
    /// The sum has this value at this state.
    Differs(State, f64),
    /// The sum is not defined at any visited state.
    Nowhere,
}

/// The number of states at which a sum has to vanish.
const STATES: usize = 20;

/// The number of states for quick answers.
const FEW: usize = 4;

/// The number of draws. A draw is skipped where the sum is not defined.
const DRAWS: u64 = 200;

/// The distance of two states on a line. It is not a fraction of a period.
const STEP: Ratio = Ratio { numerator: 5, denominator: 8 };

/// Compares Σ terms with its rounding error at pseudorandom states.
pub(super) fn shown(graph: &Graph, terms: &[Id], symbols: &[Symbol], open: &OpenBoundaries) -> Shown {
    shown_at(graph, terms, open, (0..DRAWS).map(|draw| drawn(draw, symbols)), STATES)
}

/// Returns whether a few states show that a node is not zero.
pub(super) fn differs(graph: &Graph, root: Id) -> bool {
    let symbols = graph.symbols(root);
    let states = (0..DRAWS).map(|draw| drawn(draw, &symbols));
    matches!(shown_at(graph, &[root], &OpenBoundaries::default(), states, FEW), Shown::Differs(..))
}

/// Returns whether a node differs from zero at all drawn states at which it is defined.
pub(super) fn differs_everywhere(graph: &Graph, root: Id) -> bool {
    let (symbols, mut evaluation) = (graph.symbols(root), Evaluation::new(graph, &[root]));
    let mut sums = (0..DRAWS).map(|draw| evaluation.sum(&[root], &drawn(draw, &symbols))).filter(|sum| sum.is_finite());
    sums.next().is_some_and(Sized::differs) && sums.all(Sized::differs)
}

/// Compares Σ terms with its rounding error, until it differs from zero or `enough` states have been visited.
pub(super) fn shown_at(
    graph: &Graph,
    terms: &[Id],
    open: &OpenBoundaries,
    states: impl Iterator<Item = State>,
    enough: usize,
) -> Shown {
    let mut evaluation = Evaluation::new(graph, terms);
    let mut visited = 0;
    for state in states {
        let sum = evaluation.sum(terms, &state);
        if !sum.is_finite() || evaluation.is_on_any(open) {
            continue;
        }
        if sum.differs() {
            return Shown::Differs(state, sum.value);
        }
        visited += 1;
        if visited == enough {
            break;
        }
    }
    if visited == 0 { Shown::Nowhere } else { Shown::Zero }
}

/// Retains the directions along which no evaluation shows that a node changes. The derivatives along these directions are worth a proof.
pub(crate) fn retain_likely_constant(graph: &Graph, root: Id, directions: &mut Vec<Direction>) {
    let symbols = graph.symbols(root);
    let mut evaluation = Evaluation::new(graph, &[root]);
    for draw in 0..FEW as u64 {
        let state = drawn(draw, &symbols);
        let here = evaluation.sum(&[root], &state);
        directions.retain(|direction| {
            let mut moved = state.clone();
            for (symbol, value) in &mut moved {
                let rate = direction.iter().find(|(other, _)| other == symbol).and_then(|(_, rate)| rate.mul(STEP));
                *value = rate.and_then(|rate| value.add(rate)).unwrap_or(*value);
            }
            let there = evaluation.sum(&[root], &moved);
            let change = Sized { value: there.value - here.value, size: there.size + here.size };
            !(change.is_finite() && change.differs())
        });
    }
}

/// Returns whether an evaluation shows that a matrix is regular: all pivots of its elimination exceed the rounding errors of its entries.
pub(crate) fn is_regular(graph: &Graph, matrix: &[Vec<Id>]) -> bool {
    let entries = matrix.concat();
    let symbols = super::symbols(graph, &entries);
    let mut evaluation = Evaluation::new(graph, &entries);
    (0..FEW as u64).any(|draw| {
        let values = evaluation.at(&drawn(draw, &symbols));
        let size = entries.iter().map(|id| values[*id].size).fold(0.0, f64::max);
        let rows = matrix.iter().map(|row| row.iter().map(|id| values[*id].value).collect()).collect();
        smallest_pivot(rows).is_some_and(|value| Sized { value, size }.differs())
    })
}

/// The smallest pivot of an elimination with complete pivoting; `None` if one is not finite.
fn smallest_pivot(mut rows: Vec<Vec<f64>>) -> Option<f64> {
    let mut smallest = f64::INFINITY;
    while !rows.is_empty() {
        let places = (0..rows.len()).flat_map(|i| (0..rows.len()).map(move |j| (i, j)));
        let (i, j) = places.max_by(|(i, j), (k, l)| rows[*i][*j].abs().total_cmp(&rows[*k][*l].abs()))?;
        let mut pivot = rows.swap_remove(i);
        let value = pivot.swap_remove(j);
        if !value.is_finite() {
            return None;
        }
        for row in &mut rows {
            let factor = row.swap_remove(j) / value;
            row.iter_mut().zip(&pivot).for_each(|(entry, other)| *entry -= factor * other);
        }
        smallest = value.abs().min(smallest);
    }
    Some(smallest)
}

/// A pseudorandom state with multiples of 1/8 up to 2. Every fourth draw is positive, every fourth negative, the others have both signs.
fn drawn(draw: u64, symbols: &[Symbol]) -> State {
    let coordinate = |(symbol, i): (&Symbol, u64)| {
        let noise = pseudorandom(draw * 1_000 + i);
        let is_negative = draw % 4 == 1 || draw % 4 > 1 && noise & 64 != 0;
        let sign = if is_negative { -1 } else { 1 };
        (*symbol, Ratio::new(sign * (i128::from(noise % 16) + 1), 8).unwrap_or(Ratio::ONE))
    };
    symbols.iter().zip(0..).map(coordinate).collect()
}
