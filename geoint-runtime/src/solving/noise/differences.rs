//! Computes divided differences of a residual at points on a line. They show whether the residual is smooth, and how large its rounding is.
//!
//! The residual is evaluated at 16 points at the distances d·tⱼ, for growing d and irregular nodes tⱼ. The divided difference of order k over nodes tᵢ has the
//! deviation σ √(Σᵢ 1/wᵢ²) with wᵢ = Πⱼ (tᵢ − tⱼ), if the residual is noise with the standard deviation σ. In units of this deviation for σ = 1, differences of
//! noise are of size σ for all orders. Differences of a smooth function fall with the order, and grow as dᵏ. The distance d grows until order 4 is below a
//! quarter of order 3, or below 1/16 of order 2. The noise is the largest deviation that two successive shorter distances have in common.

use super::points::{GOLDEN, Start};
use crate::scalar::{Real, zero};
use crate::solving::size::{Units, kind};

/// The number of points on a line at which the residual is evaluated. More points would cost more.
pub(super) const POINTS: usize = 16;

/// The number of spare rows: for the spread, the least deviation, the deviation at the distance before, the curvature, and the differences of each lower order.
pub(super) const SPARE: usize = 4 + LOWER;

/// The order of the differences. A higher order would leave fewer differences unaffected by a jump.
const ORDER: usize = 4;
/// The number of lower orders, from 2 on, with which differences are compared.
const LOWER: usize = ORDER - 2;

/// The nodes tⱼ: distances of the points from x.
///
/// They are irregular. With equal distances, the digits of a coordinate that is large beside its change would follow a short pattern. If the distance
/// is nearly a multiple of the last digit, the coordinate is rounded by the same amount again and again, and its rounding remains hidden.
const NODES: [f64; POINTS] = {
    let (mut nodes, mut j) = ([0.0; POINTS], 0);
    while j < POINTS {
        let golden = GOLDEN * j as f64;
        nodes[j] = j as f64 + 0.6 * (golden - golden as u32 as f64);
        j += 1;
    }
    nodes
};

/// Rank of the lower quartile of differences of order 2 or 3, in ascending order from 0. It is a lower estimate of their size.
const QUARTILE_RANK: usize = 3;
/// Rank of the median of the 12 differences of order 4.
const MEDIAN_RANK: usize = 5;
/// Rank of the largest difference of order 4 that a jump leaves unchanged. A jump changes as many differences as their order.
const RANK_BELOW_JUMP: usize = POINTS - 2 * ORDER - 1;
/// Rank of the largest difference of order 4.
const LAST_RANK: usize = POINTS - ORDER - 1;
/// The median magnitude of normal noise, in standard deviations.
const NORMAL_MEDIAN: f64 = 0.67;

/// The largest ratio of differences of one order to the order below for a smooth function. Differences of one of the two lower orders may be zero, so
/// both orders are compared. For noise this ratio is near 1.
const SMOOTH_RATIO: f64 = 0.25;

/// The number of distances in a range of 1/ε. Distances grow by ε^(−1/8), which is 91 in `f64`. If the differences of order 4 exceed the rounding at one
/// distance, they are smooth at the next distance.
const DISTANCES_PER_EPSILON: i32 = 8;

/// The largest distance that counts as near, as a part of the unknowns. Farther away, other terms of the residual may be rounded.
const NEAR_LIMIT: f64 = 1.0 / 16.0;
/// The largest rounding of the change of the residual, in ε times this change. Smaller noise at a distant point is not noise at x.
const CHANGE_ROUNDINGS: f64 = 8.0;

/// The largest rounding up to the distance at which the residual is smooth, in √ε times the change of the residual. If a function has terms and a length scale
/// of 1, its curvature d² is as large as its rounding, ε, at d = √ε. The factor leaves room for larger terms.
const ROUGHNESS_LIMIT: f64 = 64.0;

/// The largest ratio of the rounding of a staircase at one distance to the rounding at the distance before.
const SIMILAR_RATIO: f64 = 8.0;

/// The power of 1/ε by which the distances grow in all, from the last digit of the unknowns on.
const RANGE_POWER: i32 = 2;

/// A function that writes the residual at a multiple of the direction. It returns whether the residual is finite there.
pub(super) type Residual<'a, R> = dyn FnMut(R, &mut [R]) -> bool + 'a;

/// The working memory of a measurement. Its type does not contain the shape of the unknowns, so its code is compiled once for all shapes.
pub(super) struct Workspace<'a, R> {
    /// The residuals at all points, then their differences. [`SPARE`] rows follow.
    pub(super) values: &'a mut [R],
    /// The entries that were smooth at some distance.
    pub(super) smooth: &'a mut [bool],
    /// The entries whose measurement is complete: they were smooth, or show no more noise of x.
    pub(super) resolved: &'a mut [bool],
    /// The result: the standard deviation of the rounding of every entry.
    pub(super) noise: &'a mut [R],
}

impl<R: Real> Workspace<'_, R> {
    /// Measures the rounding at growing distances, from `nearest` on, and writes it to `noise`. It writes zero for entries whose rounding is unknown.
    ///
    /// `farther` is the first distance in units of the last correction. The measurement ends early at a point without a residual.
    #[cold]
    #[inline(never)]
    pub(super) fn measure(
        self,
        (nearest, farther): (f64, f64),
        start: Start,
        units: Units,
        residual: &mut Residual<'_, R>,
    ) {
        let Workspace { values, smooth, resolved, noise } = self;
        let n = noise.len();
        let (differences, spare) = values.split_at_mut(POINTS * n);
        let (spread, lower) = spare.split_at_mut(n);
        let (least, lower) = lower.split_at_mut(n);
        let (before, lower) = lower.split_at_mut(n);
        let (curves, lower) = lower.split_at_mut(n);
        before.fill(R::from_f64(if start == Start::Near { f64::INFINITY } else { 0.0 }));
        curves.fill(zero());
        noise.fill(zero());
        let growth = libm::pow(R::epsilon(), -1.0 / f64::from(DISTANCES_PER_EPSILON));
        // The distance from which on curvature is visible. Corrections are as large as the rounding, and this distance is as large as its root.
        let curvature_distance = nearest / (farther * ROUGHNESS_LIMIT * Real::sqrt(R::epsilon()));
        // Differences of order 2 grow with the square of the distance. The threshold is the power 3/2, between linear and quadratic growth.
        let growth_of_curvature = growth * Real::sqrt(growth);
        let mut distance = nearest;
        'distances: for _ in 0..RANGE_POWER * DISTANCES_PER_EPSILON {
            for (j, value) in differences.chunks_exact_mut(n).enumerate() {
                if !residual(R::from_f64(distance * NODES[j]), value) {
                    break 'distances;
                }
            }
            for (i, spread) in spread.iter_mut().enumerate() {
                *spread = differences[(POINTS - 1) * n + i] - differences[i];
            }
            divide(differences, n, 1);
            for (order, lower) in (2..).zip(lower.chunks_exact_mut(n)) {
                divide(&mut differences[..(POINTS - order + 1) * n], n, order);
                let deviations = deviations(order);
                for (i, (lower, least)) in lower.iter_mut().zip(&mut *least).enumerate() {
                    let by_rank = by_rank(&differences[..(POINTS - order) * n], i, n, &deviations);
                    let median = by_rank[(POINTS - order - 1) / 2] / NORMAL_MEDIAN;
                    *lower = R::from_f64(by_rank[QUARTILE_RANK]);
                    *least = R::from_f64(if order == 2 { median } else { median.min(least.magnitude()) });
                }
            }
            divide(&mut differences[..(POINTS - ORDER + 1) * n], n, ORDER);
            let deviations = deviations(ORDER);
            let mut all_resolved = true;
            for i in 0..n {
                let orders = lower.chunks_exact(n);
                let low = orders.fold(0.0, |low, lower| lower[i].magnitude().max(SMOOTH_RATIO * low));
                let high = by_rank(&differences[..(POINTS - ORDER) * n], i, n, &deviations);
                // Two jumps affect most of the high differences, but few of the lower differences.
                let deviation = (high[MEDIAN_RANK] / NORMAL_MEDIAN).min(least[i].magnitude());
                let curvature = if high[RANK_BELOW_JUMP] < SMOOTH_RATIO * low { low } else { 0.0 };
                let rounds_as_change = deviation <= CHANGE_ROUNDINGS * R::epsilon() * spread[i].magnitude();
                // Far away, other terms are rounded: the terms by which the residual has grown. Nearer noise has been measured by then.
                let is_past_noise = match start {
                    Start::Near => {
                        smooth[i] |= curvature > 0.0;
                        rounds_as_change && distance > NEAR_LIMIT
                    }
                    Start::Corrections => {
                        // Visible curvature grows with the distance, and the residual has changed by much more than its rounding.
                        let most = ROUGHNESS_LIMIT * Real::sqrt(R::epsilon()) * spread[i].magnitude();
                        let grows =
                            curves[i].magnitude() > 0.0 && curvature > growth_of_curvature * curves[i].magnitude();
                        smooth[i] |= grows && distance >= curvature_distance && noise[i].magnitude() <= most;
                        curves[i] = R::from_f64(curvature);
                        // The residual does not have a single stair.
                        noise[i].magnitude() == 0.0
                            && high[LAST_RANK] <= CHANGE_ROUNDINGS * R::epsilon() * spread[i].magnitude()
                    }
                };
                all_resolved &= smooth[i] || is_past_noise;
                resolved[i] |= smooth[i] || is_past_noise;
                // Rounding also shows at the distance before, so the smaller deviation counts. A jump or a kink first comes into reach at one distance only.
                let both = [deviation, before[i].magnitude()];
                before[i] = R::from_f64(deviation);
                let estimate = both[0].min(both[1]);
                let counts = match start {
                    Start::Near => !(smooth[i] || is_past_noise),
                    // The rounding of a staircase is similar at both distances.
                    Start::Corrections => {
                        !(smooth[i] || is_past_noise || rounds_as_change || curvature > 0.0)
                            && both[0].max(both[1]) <= SIMILAR_RATIO * estimate
                    }
                };
                if counts && estimate > noise[i].magnitude() {
                    noise[i] = R::from_f64(estimate);
                }
            }
            if all_resolved {
                break;
            }
            distance *= growth;
        }
        for i in (0..n).filter(|i| !resolved[*i]) {
            // In a staircase, an entry may be resolved at no distance while other entries of its kind are. If these are at least half of the entries, its
            // rounding is taken to be at most the smallest of theirs. Otherwise it is unknown.
            let alike = |j: &usize| kind(units, *j) == kind(units, i);
            let known = (0..n).filter(alike).filter(|j| resolved[*j]);
            let (count, least) =
                known.fold((0, noise[i].magnitude()), |(count, least), j| (count + 1, least.min(noise[j].magnitude())));
            let is_half_known = 2 * count >= (0..n).filter(alike).count();
            noise[i] = if start == Start::Corrections && is_half_known { R::from_f64(least) } else { zero() };
        }
    }
}

/// Replaces the divided differences of the order below by the divided differences of `order`, except the last one, which becomes invalid. Each difference has
/// `n` entries. The distance d is taken as 1.
fn divide<R: Real>(values: &mut [R], n: usize, order: usize) {
    for j in 0..values.len() - n {
        let width = NODES[j / n + order] - NODES[j / n];
        values[j] = (values[j + n] - values[j]) * R::from_f64(1.0 / width);
    }
}

/// Returns the standard deviation of each divided difference of an order, for noise with standard deviation 1. Differences that do not exist have infinity.
fn deviations(order: usize) -> [f64; POINTS] {
    core::array::from_fn(|first| {
        let Some(nodes) = NODES.get(first..=first + order) else { return f64::INFINITY };
        let weight = |x: &f64| nodes.iter().filter(|y| *y != x).map(|y| x - y).product::<f64>();
        Real::sqrt(nodes.iter().map(|x| 1.0 / (weight(x) * weight(x))).sum::<f64>())
    })
}

/// Returns the magnitudes of entry `i` of `n` of each difference in ascending order, in units of their deviations. Missing differences count as infinite.
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
