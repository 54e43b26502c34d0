//! Coefficients of a table for steps of length h.

use super::flows::Order;
use super::kicks::Weight;
use super::moving::Times;
use super::table::Splitting;
use crate::scalar::Real;
use crate::system::Separable;

/// The flows of a step, and their times relative to the start of the step.
#[derive(Clone, Copy, Debug)]
pub struct Sequence<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> {
    /// The first outer flow of a step that does not continue another step.
    pub(super) first: O::Outer,
    pub(super) inner: [O::Inner; K],
    /// The outer flow after each inner flow if another step follows: the last one is merged with the first flow of the next step.
    pub(super) outer: [O::Outer; K],
    /// The outer flow after the last inner flow if no step follows.
    pub(super) last: Option<O::Outer>,
    /// The clock of the outer flows at each inner flow.
    inner_at: [R; K],
    /// The clock of the inner flows at each outer flow of `outer`.
    outer_at: [R; K],
    /// Whether the last flow of a step equals the first flow of the next step.
    pub(super) repeats: bool,
}

impl<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> Sequence<S, R, O, K> {
    pub(super) fn prepare(table: &Splitting<K, O>, system: &S, h: R) -> Self {
        let part = |fraction: f64| R::from_f64(fraction) * h;
        let (mut inner_at, mut outer_at) = ([h; K], [h; K]);
        let (mut outers, mut inners) = (0.0, 0.0);
        for i in 0..K {
            outers += table.outer[i];
            inners += table.inner[i];
            inner_at[i] = part(outers);
            if i + 1 < K {
                outer_at[i] = part(inners);
            }
        }
        let cube = h * h * h;
        let weight = |fraction: f64, gradient: f64| Weight {
            h: part(fraction),
            gradient: (gradient != 0.0).then(|| R::from_f64(gradient) * cube),
        };
        let outer = |(fraction, gradient)| O::prepare_outer(system, weight(fraction, gradient));
        let start = (table.outer[0], table.gradients[0]);
        let last = (table.last != 0.0).then_some((table.last, table.gradients[0]));
        let merged = last.map_or(start, |last| (start.0 + last.0, start.1 + last.1));
        let inner = |(fraction, gradient)| O::prepare_inner(system, weight(fraction, gradient));
        let between = |i| match i + 1 {
            next if next < K => (table.outer[next], table.gradients[next]),
            _ => merged,
        };
        let first = outer(start);
        Sequence {
            inner: mirrored(|i| (table.inner[i], table.gradients[i]), K, inner),
            outer: mirrored(between, K - 1, outer),
            last: last.map(|last| if last == start { first } else { outer(last) }),
            first,
            inner_at,
            outer_at,
            repeats: O::REPEATS && table.last == table.outer[0],
        }
    }

    /// Returns the times of the i-th inner flow of a step that starts at `t`, and of the outer flow after it.
    #[inline(always)]
    pub(super) fn times(&self, t: R, i: usize) -> [Times<R>; 2] {
        let before = if i == 0 { t } else { t + self.outer_at[i - 1] };
        let (outers, inners) = (t + self.inner_at[i], t + self.outer_at[i]);
        [Times { own: before, other: outers }, Times { own: outers, other: inners }]
    }
}

/// Prepares K flows. If the first `palindrome` weights are symmetric, the second half is copied from the first, because the preparation may compute a matrix.
fn mirrored<W: PartialEq, T: Copy, const K: usize>(
    weight: impl Fn(usize) -> W,
    palindrome: usize,
    prepare: impl Fn(W) -> T,
) -> [T; K] {
    let mut all = [prepare(weight(0)); K];
    for i in 1..K {
        let before = i < palindrome && palindrome <= 2 * i;
        all[i] = if before && weight(palindrome - 1 - i) == weight(i) {
            all[palindrome - 1 - i]
        } else {
            prepare(weight(i))
        };
    }
    all
}
