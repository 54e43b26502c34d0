//! Does a sum vanish in floating point, as far as rounding lets one see? Nothing is proven by that: it tells what to say of what was
//! not proven.

mod sized;

use super::OpenBoundaries;
use crate::ir::{Graph, Id, Ratio, Symbol};
pub(super) use sized::State;
use sized::{Evaluation, Sized};

/// How positions change together.
pub(crate) type Direction = Vec<(Symbol, Ratio)>;

/// What floating point shows.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shown {
    /// It is zero to rounding at so many states.
    Zero,
    /// It is not, at this one.
    Differs(State, f64),
    /// No state was met at which it is defined.
    Nowhere,
}

/// States at which a sum has to vanish, and how often one is drawn.
const STATES: u32 = 20;
const DRAWS: u64 = 200;

/// How many states are looked at for what most of them show.
const FEW: u64 = 4;

/// How far apart two states are on a line: no part of a period.
const STEP: Ratio = Ratio { numerator: 5, denominator: 8 };

/// The value of Σ terms at states that look random, against the size of the terms.
pub(super) fn shown(graph: &Graph, terms: &[Id], symbols: &[Symbol], open: &OpenBoundaries) -> Shown {
    shown_at(graph, terms, (symbols, STATES), open)
}

/// Whether a few states show that a node is not zero.
pub(super) fn differs(graph: &Graph, root: Id) -> bool {
    let open = OpenBoundaries::default();
    matches!(shown_at(graph, &[root], (&graph.symbols(root), FEW as u32), &open), Shown::Differs(..))
}

/// Whether a node differs from zero at all states that are drawn and at which it is defined.
pub(super) fn differs_everywhere(graph: &Graph, root: Id) -> bool {
    let (symbols, mut evaluation) = (graph.symbols(root), Evaluation::new(graph, &[root]));
    let mut sums = (0..DRAWS).map(|draw| evaluation.sum(&[root], &drawn(draw, &symbols))).filter(|sum| sum.is_finite());
    sums.next().is_some_and(Sized::differs) && sums.all(Sized::differs)
}

fn shown_at(graph: &Graph, terms: &[Id], (symbols, enough): (&[Symbol], u32), open: &OpenBoundaries) -> Shown {
    let mut evaluation = Evaluation::new(graph, terms);
    let mut states = 0;
    for draw in 0..DRAWS {
        let state = drawn(draw, symbols);
        let sum = evaluation.sum(terms, &state);
        if !sum.is_finite() || evaluation.is_on_any(open) {
            continue;
        }
        if sum.differs() {
            return Shown::Differs(state, sum.value);
        }
        states += 1;
        if states == enough {
            return Shown::Zero;
        }
    }
    if states == 0 { Shown::Nowhere } else { Shown::Zero }
}

/// The value at a state, if it is not zero to rounding.
pub(super) fn value_at(graph: &Graph, terms: &[Id], state: &State, open: &OpenBoundaries) -> Option<f64> {
    let mut evaluation = Evaluation::new(graph, terms);
    let sum = evaluation.sum(terms, state);
    (sum.is_finite() && sum.differs() && !evaluation.is_on_any(open)).then_some(sum.value)
}

/// Leaves the directions along which no states show that a node is not constant.
pub(super) fn retain_constant(graph: &Graph, root: Id, directions: &mut Vec<Direction>) {
    let symbols = graph.symbols(root);
    let mut evaluation = Evaluation::new(graph, &[root]);
    for draw in 0..FEW {
        let state = drawn(draw, &symbols);
        let here = evaluation.sum(&[root], &state);
        directions.retain(|direction| {
            let mut moved = state.clone();
            for (symbol, value) in &mut moved {
                let rate = direction.iter().find(|(other, _)| other == symbol).and_then(|(_, rate)| rate.mul(STEP));
                *value = rate.and_then(|rate| value.add(rate)).unwrap_or(*value);
            }
            let there = evaluation.moved(root, &moved);
            let change = Sized { value: there.value - here.value, size: there.size + here.size };
            !(change.is_finite() && change.differs())
        });
    }
}

/// Whether a state shows that a matrix is regular: no pivot of its elimination is as small as the rounding of its entries.
pub(super) fn is_regular(graph: &Graph, matrix: &[Vec<Id>]) -> bool {
    let entries = matrix.concat();
    let symbols = super::symbols(graph, &entries);
    let mut evaluation = Evaluation::new(graph, &entries);
    (0..FEW).any(|draw| {
        let values = evaluation.at(&drawn(draw, &symbols));
        let size = entries.iter().map(|id| values[*id].size).fold(0.0, f64::max);
        let rows = matrix.iter().map(|row| row.iter().map(|id| values[*id].value).collect()).collect();
        smallest_pivot(rows).is_some_and(|value| Sized { value, size }.differs())
    })
}

/// The smallest pivot, each being the largest entry that is left; `None` if one is not finite.
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

/// Values that look random: eighths up to 2; all positive, all negative, or of either sign.
fn drawn(draw: u64, symbols: &[Symbol]) -> State {
    let coordinate = |(i, symbol): (usize, &Symbol)| {
        let noise = super::residues::noise(draw * 1_000 + i as u64);
        let negative = draw % 4 == 1 || draw % 4 > 1 && noise & 64 != 0;
        let sign = if negative { -1 } else { 1 };
        (*symbol, Ratio::new(sign * (i128::from(noise % 16) + 1), 8).unwrap_or(Ratio::ONE))
    };
    symbols.iter().enumerate().map(coordinate).collect()
}
