//! Computes divided differences of a residual at points on a line. They show whether the residual is smooth, and how large its rounding is.

use super::points::{GOLDEN, Start};
use crate::scalar::{Real, zero};
use crate::solving::size::{Units, kind};

/// The number of points on a line at which the residual is evaluated.
pub(super) const POINTS: usize = 16;

/// The number of spare rows: for the spread, two deviations, the curves, and the differences of each lower order.
pub(super) const SPARE: usize = 4 + LOWER;

/// The order of the differences, and the number of lower orders, from 2 on, with which they are compared.
const ORDER: usize = 4;
const LOWER: usize = ORDER - 2;

/// The distances of the points from the first point.
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

/// Ranks of differences in ascending order: a quarter of them, half of them, as many as a jump leaves unchanged, and all. A jump changes as many
/// differences as their order.
const QUARTER: usize = 3;
const HALF: usize = 5;
const MOST: usize = POINTS - 2 * ORDER - 1;
const ALL: usize = POINTS - ORDER - 1;
/// The median magnitude of normal noise, in standard deviations.
const MEDIAN: f64 = 0.67;

/// The largest ratio of differences of one order to the order below for a smooth function. Differences of one of the two lower orders may be zero, so
/// both orders are compared.
const SMOOTH: f64 = 0.25;

/// The number of distances in a range of 1/ε. Distances grow by ε^(−1/8). If the differences of order 4 exceed the rounding at one distance, they are
/// smooth at the next distance.
const DISTANCES_PER_EPSILON: i32 = 8;

/// The largest distance that counts as near, as a part of the unknowns.
const NEAR: f64 = 1.0 / 16.0;
/// The least noise at a distant point that counts, in ε times the change of the residual. Smaller noise is not noise of the point itself.
const GROWN: f64 = 8.0;

/// The largest rounding up to the distance at which the residual is smooth, in √ε times the change of the residual. If a function has terms of size
/// 1, its curves are as large as its rounding, ε, at √ε of its length.
const ROUGH: f64 = 64.0;

/// The largest ratio of the rounding at one distance to the rounding at another.
const ALIKE: f64 = 8.0;

/// The power of 1/ε by which the distances grow in all, from the last digit of the unknowns on.
const REACH: i32 = 2;

/// A function that writes the residual at a multiple of the direction. It returns whether the residual exists there.
pub(super) type Residual<'a, R> = dyn FnMut(R, &mut [R]) -> bool + 'a;

/// The working memory of a measurement. It knows no shape of the unknowns, so its code is compiled once for all shapes.
pub(super) struct Memory<'a, R> {
    /// The residuals at all points. Spare rows hold their spread, the deviations, the curves and the differences of lower orders.
    pub(super) values: &'a mut [R],
    /// The entries that were smooth at some distance.
    pub(super) smooth: &'a mut [bool],
    /// The entries whose rounding was seen.
    pub(super) resolved: &'a mut [bool],
    /// The standard deviation of the rounding of every entry, which is the result.
    pub(super) noise: &'a mut [R],
}

impl<R: Real> Memory<'_, R> {
    /// Measures the rounding at growing distances, from `nearest` on, and writes it to `noise`.
    #[cold]
    #[inline(never)]
    pub(super) fn measure(
        self,
        (nearest, farther): (f64, f64),
        start: Start,
        units: Units,
        residual: &mut Residual<'_, R>,
    ) {
        let Memory { values, smooth, resolved, noise } = self;
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
        // The distance at which curves come into sight. Corrections are as large as the rounding, and this distance is as large as its root.
        let sight = nearest / (farther * ROUGH * Real::sqrt(R::epsilon()));
        // Differences of order 2 grow with the square of the distance. The threshold is the power 3/2.
        let steepest = growth * Real::sqrt(growth);
        let mut distance = nearest;
        'distances: for _ in 0..REACH * DISTANCES_PER_EPSILON {
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
                    let median = by_rank[(POINTS - order - 1) / 2] / MEDIAN;
                    *lower = R::from_f64(by_rank[QUARTER]);
                    *least = R::from_f64(if order == 2 { median } else { median.min(least.magnitude()) });
                }
            }
            divide(&mut differences[..(POINTS - ORDER + 1) * n], n, ORDER);
            let deviations = deviations(ORDER);
            let mut over = true;
            for i in 0..n {
                let orders = lower.chunks_exact(n);
                let last = orders.fold(0.0, |last, lower| lower[i].magnitude().max(SMOOTH * last));
                let high = by_rank(&differences[..(POINTS - ORDER) * n], i, n, &deviations);
                // Two jumps affect most of the high differences, but few of the lower differences.
                let deviation = (high[HALF] / MEDIAN).min(least[i].magnitude());
                let curved = if high[MOST] < SMOOTH * last { last } else { 0.0 };
                let rounded = deviation <= GROWN * R::epsilon() * spread[i].magnitude();
                // Far away, other terms are rounded: the terms by which the residual has grown.
                let grown = match start {
                    Start::Near => {
                        smooth[i] |= curved > 0.0;
                        rounded && distance > NEAR
                    }
                    Start::Corrections => {
                        // When the curves of a residual come into sight, they grow, and the residual has changed by much more than its rounding.
                        let changed = ROUGH * Real::sqrt(R::epsilon()) * spread[i].magnitude();
                        let grows = curves[i].magnitude() > 0.0 && curved > steepest * curves[i].magnitude();
                        smooth[i] |= grows && distance >= sight && noise[i].magnitude() <= changed;
                        curves[i] = R::from_f64(curved);
                        // The residual does not have a single stair.
                        noise[i].magnitude() == 0.0 && high[ALL] <= GROWN * R::epsilon() * spread[i].magnitude()
                    }
                };
                over &= smooth[i] || grown;
                resolved[i] |= smooth[i] || grown;
                // Rounding also shows at the distance before. A jump or a kink comes into reach at one distance only.
                let both = [deviation, before[i].magnitude()];
                before[i] = R::from_f64(deviation);
                let seen = both[0].min(both[1]);
                let counts = match start {
                    Start::Near => !(smooth[i] || grown),
                    // The rounding of stairs is alike at both distances.
                    Start::Corrections => {
                        !(smooth[i] || grown || rounded || curved > 0.0) && both[0].max(both[1]) <= ALIKE * seen
                    }
                };
                if counts && seen > noise[i].magnitude() {
                    noise[i] = R::from_f64(seen);
                }
            }
            if over {
                break;
            }
            distance *= growth;
        }
        for i in (0..n).filter(|i| !resolved[*i]) {
            // Among stairs, an entry may be smooth at no distance while other entries of its unit are. If these are at least half of the entries, its
            // rounding is at most as large as theirs.
            let alike = |j: &usize| kind(units, *j) == kind(units, i);
            let known = (0..n).filter(alike).filter(|j| resolved[*j]);
            let (count, least) =
                known.fold((0, noise[i].magnitude()), |(count, least), j| (count + 1, least.min(noise[j].magnitude())));
            let most = 2 * count >= (0..n).filter(alike).count();
            noise[i] = if start == Start::Corrections && most { R::from_f64(least) } else { zero() };
        }
    }
}

/// Replaces the divided differences of the order below by the divided differences of `order`. Each difference has `n` entries. The last difference
/// stays unchanged.
fn divide<R: Real>(values: &mut [R], n: usize, order: usize) {
    for j in 0..values.len() - n {
        let width = NODES[j / n + order] - NODES[j / n];
        values[j] = (values[j + n] - values[j]) * R::from_f64(1.0 / width);
    }
}

/// Returns the standard deviation of each divided difference of an order, for noise with standard deviation 1.
fn deviations(order: usize) -> [f64; POINTS] {
    core::array::from_fn(|first| {
        let Some(nodes) = NODES.get(first..=first + order) else { return f64::INFINITY };
        let weight = |x: &f64| nodes.iter().filter(|y| *y != x).map(|y| x - y).product::<f64>();
        Real::sqrt(nodes.iter().map(|x| 1.0 / (weight(x) * weight(x))).sum::<f64>())
    })
}

/// Returns the magnitudes of entry `i` of `n` in ascending order, in units of their deviations. Missing values count as infinite.
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
