//! Computes divided differences of a residual at points on a line. They show whether the residual is smooth, and how large its rounding is.
//!
//! The residual is evaluated at 16 points at the distances d·tⱼ, for growing d and irregular nodes tⱼ. If the residual is noise with the standard deviation σ,
//! its divided difference of order k over nodes tᵢ has the standard deviation σ √(Σᵢ 1/wᵢ²) with wᵢ = Πⱼ (tᵢ − tⱼ), j ≠ i. Divided by the root, differences of
//! noise are of size σ for all orders. Differences of a smooth function then fall with the order, and grow as dᵏ.
//!
//! The residual is *smooth* at a distance d if order 4 is below a quarter of order 3, or below 1/16 of order 2. Until then d grows. The smallest median of
//! orders 2 to 4 at one distance estimates σ. Of the estimates at two successive distances the smaller one counts, because a jump or a kink first comes into
//! reach at one distance only. The noise is the largest of these numbers up to the distance at which the residual is smooth.
//!
//! [`Start`] chooses between two variants. With `Near`, every estimate before that distance counts. With `Corrections`, the points lie far beyond the rounding
//! of x, where a function may look rough: an estimate counts only beside one of similar size, and a smooth residual must have curvature that grows with the
//! distance. A *staircase* is a residual that is rounded in steps much longer than the distance between points. Limit: both variants are heuristics.

use super::points::{GOLDEN, Start};
use crate::scalar::{Real, zero};
use crate::solving::size::{Units, kind};

/// The number of points on a line at which the residual is evaluated. More points would determine the deviation better, and cost more evaluations.
pub(super) const POINTS: usize = 16;

/// The number of spare [`Rows`].
pub(super) const SPARE: usize = 4 + LOWER_ORDERS;

/// The order of the differences that show noise. A higher order would leave fewer differences unaffected by a jump.
const ORDER: usize = 4;
/// The number of lower orders, from 2 on, with which differences are compared.
const LOWER_ORDERS: usize = ORDER - 2;

/// The nodes tⱼ: distances of the points from x.
///
/// They are irregular. With equal distances, the digits of a coordinate that is large beside its change would follow a short pattern. If the distance
/// is nearly a multiple of the last digit, the coordinate is rounded by equal amounts, and its rounding remains hidden.
const NODES: [f64; POINTS] = {
    let (mut nodes, mut j) = ([0.0; POINTS], 0);
    while j < POINTS {
        let golden = GOLDEN * j as f64;
        nodes[j] = j as f64 + 0.6 * (golden - golden as u32 as f64);
        j += 1;
    }
    nodes
};

/// The rank of the lower quartile of the magnitudes of order 2 or 3, in ascending order from 0. It is a lower estimate of their size.
const QUARTILE_RANK: usize = 3;
/// The rank of the median of the 12 magnitudes of order 4.
const MEDIAN_RANK: usize = 5;
/// The rank of the largest magnitude of order 4 if one jump has made the four largest ones. A jump changes as many differences as their order.
const RANK_BELOW_JUMP: usize = POINTS - 2 * ORDER - 1;
/// The rank of the largest magnitude of order 4.
const LAST_RANK: usize = POINTS - ORDER - 1;
/// The median magnitude of normal noise, in standard deviations.
const NORMAL_MEDIAN: f64 = 0.67;

/// The largest ratio of differences of one order to the order below for a smooth function. One of the two lower orders may vanish, so both are compared. For
/// noise this ratio is near 1.
const SMOOTH_RATIO: f64 = 0.25;

/// The number of distances in a range of 1/ε. Distances grow by ε^(−1/8), which is 91 in `f64`. Noise is seen only if one distance
/// is larger than its reach and smaller than the scale of the function, so a faster growth misses more of it.
const DISTANCES_PER_EPSILON: i32 = 8;

/// The largest distance that counts as near, as a part of the unknowns. Farther away, other terms of the residual may be rounded.
const NEAR_LIMIT: f64 = 1.0 / 16.0;
/// The largest rounding of the change of the residual, in ε times this change. Noise below it may come from the change, and is not noise at x.
const CHANGE_ROUNDINGS: f64 = 8.0;

/// The largest rounding, in √ε times the change of the residual at the distance at which it becomes smooth. If a function has terms and a length scale of 1,
/// its curvature d² exceeds its rounding ε from d = √ε on, where its change is √ε. The factor 64 leaves room for larger terms.
const ROUGHNESS_LIMIT: f64 = 64.0;

/// Curvature may be visible at distances shorter by this factor than for terms and a length scale of 1.
const CURVATURE_MARGIN: f64 = 64.0;

/// The largest ratio of deviations of a staircase at two successive distances. Differences of functions grow at least with the square of the distance.
const SIMILAR_RATIO: f64 = 8.0;

/// The power of 1/ε by which the distances grow at most. From the last digits of the unknowns on, they reach 1/ε times the unknowns.
const RANGE_POWER: i32 = 2;

/// Writes the residual at a multiple of the direction. Returns whether it is finite there.
pub(super) type Residual<'a, R> = dyn FnMut(R, &mut [R]) -> bool + 'a;

/// The working memory of a measurement. Its type does not contain the shape of the unknowns, so its code is compiled once for all shapes.
pub(super) struct Workspace<'a, R> {
    /// The residuals at all points, then their differences. [`SPARE`] rows follow.
    pub(super) values: &'a mut [R],
    /// True for entries that were smooth at some distance.
    pub(super) smooth: &'a mut [bool],
    /// True for entries whose measurement is complete: they were smooth, or their noise at farther points is no noise at x.
    pub(super) resolved: &'a mut [bool],
    /// The result: the standard deviation of the rounding of each entry.
    pub(super) noise: &'a mut [R],
}

/// Numbers for each entry of the residual, in spare rows.
struct Rows<'a, R> {
    /// The change of the residual from the first point to the last one.
    spread: &'a mut [R],
    /// The least deviation of the lower orders.
    least: &'a mut [R],
    /// The deviation at the distance before.
    deviation_before: &'a mut [R],
    /// The curvature at the distance before. Zero if the residual was not smooth there.
    curvature_before: &'a mut [R],
    /// The sizes of differences of order 2 and of order 3, one row for each.
    lower: &'a mut [R],
}

impl<'a, R: Real> Rows<'a, R> {
    fn of(spare: &'a mut [R], n: usize) -> Self {
        let (spread, spare) = spare.split_at_mut(n);
        let (least, spare) = spare.split_at_mut(n);
        let (deviation_before, spare) = spare.split_at_mut(n);
        let (curvature_before, lower) = spare.split_at_mut(n);
        Rows { spread, least, deviation_before, curvature_before, lower }
    }

    /// Replaces the residuals at all points by their differences of order 4, and fills the rows of this distance.
    fn fill(&mut self, values: &mut [R], n: usize) {
        for (i, spread) in self.spread.iter_mut().enumerate() {
            *spread = values[(POINTS - 1) * n + i] - values[i];
        }
        divide(values, n, 1);
        for (order, lower) in (2..).zip(self.lower.chunks_exact_mut(n)) {
            divide(&mut values[..(POINTS - order + 1) * n], n, order);
            let expected = deviations(order);
            for (i, (lower, least)) in lower.iter_mut().zip(&mut *self.least).enumerate() {
                let ranked = by_rank(&values[..(POINTS - order) * n], i, n, &expected);
                let median = ranked[(POINTS - order - 1) / 2] / NORMAL_MEDIAN;
                *lower = R::from_f64(ranked[QUARTILE_RANK]);
                *least = R::from_f64(if order == 2 { median } else { median.min(least.magnitude()) });
            }
        }
        divide(&mut values[..(POINTS - ORDER + 1) * n], n, ORDER);
    }
}

/// A distance d of the points, and the numbers that judge curvature there.
struct Distance {
    /// d, in units of the last correction.
    length: f64,
    /// The distance from which curvature may be visible.
    visible: f64,
    /// The factor by which curvature grows at least from one distance to the next. Differences of order 2 grow with the square of the distance. The factor is its
    /// power 3/2, between linear and quadratic growth.
    growth: f64,
}

impl<R: Real> Workspace<'_, R> {
    /// Measures the rounding at growing distances, from `nearest` on, and writes it to `noise`. It writes zero for entries whose rounding is unknown, and for
    /// those without rounding.
    ///
    /// `nearest` is `multiple` times the last correction, unless it is ε. The measurement ends early at a point without a residual.
    #[cold]
    #[inline(never)]
    pub(super) fn measure(
        mut self,
        nearest: f64,
        multiple: f64,
        start: Start,
        units: Units,
        residual: &mut Residual<'_, R>,
    ) {
        let n = self.noise.len();
        let (differences, spare) = core::mem::take(&mut self.values).split_at_mut(POINTS * n);
        let mut rows = Rows::of(spare, n);
        rows.deviation_before.fill(R::from_f64(if start == Start::Near { f64::INFINITY } else { 0.0 }));
        rows.curvature_before.fill(zero());
        self.noise.fill(zero());
        let growth = libm::pow(R::epsilon(), -1.0 / f64::from(DISTANCES_PER_EPSILON));
        // Curvature may be visible from c/√ε on, with the relative correction c: for c = ε this is √ε. The factor 64 leaves room.
        let visible = nearest / (multiple * CURVATURE_MARGIN * Real::sqrt(R::epsilon()));
        let mut distance = Distance { length: nearest, visible, growth: growth * Real::sqrt(growth) };
        'distances: for _ in 0..RANGE_POWER * DISTANCES_PER_EPSILON {
            for (j, value) in differences.chunks_exact_mut(n).enumerate() {
                if !residual(R::from_f64(distance.length * NODES[j]), value) {
                    break 'distances;
                }
            }
            rows.fill(differences, n);
            let expected = deviations(ORDER);
            let mut all_resolved = true;
            for i in 0..n {
                let ranked = by_rank(&differences[..(POINTS - ORDER) * n], i, n, &expected);
                all_resolved &= self.judge(i, &ranked, &mut rows, &distance, start);
            }
            if all_resolved {
                break;
            }
            distance.length *= growth;
        }
        self.fill_unresolved(start, units);
    }

    /// Includes the differences of entry `i` at one distance. `ranked` are its magnitudes of order 4. Returns whether its measurement is complete.
    fn judge(
        &mut self,
        i: usize,
        ranked: &[f64; POINTS],
        rows: &mut Rows<'_, R>,
        distance: &Distance,
        start: Start,
    ) -> bool {
        let orders = rows.lower.chunks_exact(self.noise.len());
        let low = orders.fold(0.0, |low, row| row[i].magnitude().max(SMOOTH_RATIO * low));
        // Two jumps affect most of the differences of order 4, but fewer of lower order.
        let deviation = (ranked[MEDIAN_RANK] / NORMAL_MEDIAN).min(rows.least[i].magnitude());
        let curvature = if ranked[RANK_BELOW_JUMP] < SMOOTH_RATIO * low { low } else { 0.0 };
        let (spread, noise) = (rows.spread[i].magnitude(), self.noise[i].magnitude());
        let change_rounding = CHANGE_ROUNDINGS * R::epsilon() * spread;
        let rounds_as_change = deviation <= change_rounding;
        // Far away, the terms by which the residual has changed are rounded. The noise at x has been measured by then.
        let is_past_noise = match start {
            Start::Near => {
                self.smooth[i] |= curvature > 0.0;
                rounds_as_change && distance.length > NEAR_LIMIT
            }
            Start::Corrections => {
                // A smooth residual has curvature that grows with the distance, and has changed by much more than its rounding.
                let earlier = rows.curvature_before[i].magnitude();
                let grows = earlier > 0.0 && curvature > distance.growth * earlier;
                let is_fine = noise <= ROUGHNESS_LIMIT * Real::sqrt(R::epsilon()) * spread;
                self.smooth[i] |= grows && distance.length >= distance.visible && is_fine;
                rows.curvature_before[i] = R::from_f64(curvature);
                // The residual shows no stair, neither here nor nearer to x.
                noise == 0.0 && ranked[LAST_RANK] <= change_rounding
            }
        };
        let is_complete = self.smooth[i] || is_past_noise;
        self.resolved[i] |= is_complete;
        let before = rows.deviation_before[i].magnitude();
        rows.deviation_before[i] = R::from_f64(deviation);
        let estimate = deviation.min(before);
        let counts = match start {
            Start::Near => true,
            // The rounding of a staircase is similar at both distances.
            Start::Corrections => {
                !(rounds_as_change || curvature > 0.0) && deviation.max(before) <= SIMILAR_RATIO * estimate
            }
        };
        if !is_complete && counts && estimate > noise {
            self.noise[i] = R::from_f64(estimate);
        }
        is_complete
    }

    /// Writes the noise of entries whose measurement is not complete: zero, or what entries of the same kind have.
    fn fill_unresolved(&mut self, start: Start, units: Units) {
        let n = self.noise.len();
        for i in (0..n).filter(|i| !self.resolved[*i]) {
            // In a staircase, an entry may be resolved at no distance while other entries of its kind are. If these are at least half of the kind, its rounding
            // is taken to be at most the smallest of theirs. Otherwise it is unknown.
            let alike = |j: &usize| kind(units, *j) == kind(units, i);
            let known = (0..n).filter(alike).filter(|j| self.resolved[*j]);
            let (count, least) = known.fold((0, self.noise[i].magnitude()), |(count, least), j| {
                (count + 1, least.min(self.noise[j].magnitude()))
            });
            let is_half_known = 2 * count >= (0..n).filter(alike).count();
            self.noise[i] = if start == Start::Corrections && is_half_known { R::from_f64(least) } else { zero() };
        }
    }
}

/// Replaces the divided differences of the order below by those of `order`. There is one less: the last one becomes invalid. Each difference has `n` entries.
/// The distance d is taken as 1.
fn divide<R: Real>(values: &mut [R], n: usize, order: usize) {
    for j in 0..values.len() - n {
        let width = NODES[j / n + order] - NODES[j / n];
        values[j] = (values[j + n] - values[j]) * R::from_f64(1.0 / width);
    }
}

/// Returns the standard deviation of each divided difference of an order, for noise with standard deviation 1. It is infinite for missing differences.
fn deviations(order: usize) -> [f64; POINTS] {
    core::array::from_fn(|first| {
        let Some(nodes) = NODES.get(first..=first + order) else { return f64::INFINITY };
        let weight = |x: &f64| nodes.iter().filter(|y| *y != x).map(|y| x - y).product::<f64>();
        Real::sqrt(nodes.iter().map(|x| 1.0 / (weight(x) * weight(x))).sum::<f64>())
    })
}

/// Returns the magnitudes of entry `i` (of `n`) of all differences in ascending order, in units of their deviations. Missing differences count as infinite.
fn by_rank<R: Real>(values: &[R], i: usize, n: usize, deviations: &[f64; POINTS]) -> [f64; POINTS] {
    let mut sizes = [f64::INFINITY; POINTS];
    // The standard library's sort is avoided because it contains code for lists of any length.
    for (filled, (value, deviation)) in values.chunks_exact(n).zip(deviations).enumerate() {
        let size = value[i].magnitude() / deviation;
        let mut place = filled;
        while place > 0 && sizes[place - 1].total_cmp(&size).is_gt() {
            sizes[place] = sizes[place - 1];
            place -= 1;
        }
        sizes[place] = size;
    }
    sizes
}
