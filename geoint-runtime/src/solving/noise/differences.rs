//! Divided differences of a residual at points on a line, and what they say of it: smooth, or rounded to so much.

use super::points::{GOLDEN, Start};
use crate::scalar::{Real, zero};
use crate::solving::size::kind;

/// Points on a line at which the residual is evaluated.
pub(super) const POINTS: usize = 16;

/// Places for a spread, two deviations, curves, and for differences of lower orders.
pub(super) const SPARE: usize = 4 + LOWER;

/// The order of the differences, and how many lower ones, from 2 on, are compared with it.
const ORDER: usize = 4;
const LOWER: usize = ORDER - 2;

/// Distances from the first point. Were they all alike, digits of a coordinate that is large beside what it changes by would come in a
/// pattern of few: a coordinate is rounded by the same again and again where the distance is nearly a multiple of its last digit, and nothing is
/// seen of it.
const NODES: [f64; POINTS] = {
    let (mut nodes, mut j) = ([0.0; POINTS], 0);
    while j < POINTS {
        let golden = GOLDEN * j as f64;
        nodes[j] = j as f64 + 0.6 * (golden - golden as u32 as f64);
        j += 1;
    }
    nodes
};

/// Differences by rank: a jump changes as many of them as their order is. A quarter of them, half of them, as many as a jump leaves as they were,
/// and all. Of normal noise half reach to 0.67 of the standard deviation.
const QUARTER: usize = 3;
const HALF: usize = 5;
const MOST: usize = POINTS - 2 * ORDER - 1;
const ALL: usize = POINTS - ORDER - 1;
const MEDIAN: f64 = 0.67;

/// Differences that all shrink by more than this from order to order are those of a smooth function. One of two orders may have a zero.
const SMOOTH: f64 = 0.25;

/// Distances grow by ε^(−1/8): where the differences of order 4 leave the rounding, they are smooth at the next distance.
const DISTANCES_PER_EPSILON: i32 = 8;

/// Unknowns that are moved by more than this part of them are far away. Noise of less than so many ε of what the residual changes by is
/// none of the point then.
const NEAR: f64 = 1.0 / 16.0;
const GROWN: f64 = 8.0;

/// Rounding is at most this times √ε of what the residual changes by up to where it is smooth: curves of a function with terms of size 1 are as
/// large as its rounding, ε, at √ε of its length.
const ROUGH: f64 = 64.0;

/// Rounding at one distance is at most this times that at another.
const ALIKE: f64 = 8.0;

/// Distances reach from the last digit of the unknowns to this power of 1/ε times it.
const REACH: i32 = 2;

/// A residual at so much of a direction; whether there is one.
pub(super) type Residual<'a, R> = dyn FnMut(R, &mut [R]) -> bool + 'a;

/// What is remembered while rounding is measured. No shape of unknowns is known here: it is compiled once for all of them.
pub(super) struct Memory<'a, R> {
    /// The residuals at all points, and in spare places how they spread, and their differences of lower orders.
    pub(super) values: &'a mut [R],
    /// Entries that have been smooth, and those of which the rounding was seen.
    pub(super) smooth: &'a mut [bool],
    pub(super) resolved: &'a mut [bool],
    pub(super) noise: &'a mut [R],
}

impl<R: Real> Memory<'_, R> {
    #[cold]
    #[inline(never)]
    pub(super) fn measure(
        self,
        (nearest, farther): (f64, f64),
        start: Start,
        kinds: [usize; 2],
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
        // Corrections are as large as rounding, curves as its root.
        let sight = nearest / (farther * ROUGH * Real::sqrt(R::epsilon()));
        // Differences of order 2 grow by the square of the distance.
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
                // Two jumps are in most of the high differences, and in few of the lower ones.
                let deviation = (high[HALF] / MEDIAN).min(least[i].magnitude());
                let curved = if high[MOST] < SMOOTH * last { last } else { 0.0 };
                let rounded = deviation <= GROWN * R::epsilon() * spread[i].magnitude();
                // Far away other terms are rounded: those that the residual has grown by.
                let grown = match start {
                    Start::Near => {
                        smooth[i] |= curved > 0.0;
                        rounded && distance > NEAR
                    }
                    Start::Corrections => {
                        // Beside rounding the residual has changed by much when its curves come into sight; and they grow.
                        let changed = ROUGH * Real::sqrt(R::epsilon()) * spread[i].magnitude();
                        let grows = curves[i].magnitude() > 0.0 && curved > steepest * curves[i].magnitude();
                        smooth[i] |= grows && distance >= sight && noise[i].magnitude() <= changed;
                        curves[i] = R::from_f64(curved);
                        // Not even one stair.
                        noise[i].magnitude() == 0.0 && high[ALL] <= GROWN * R::epsilon() * spread[i].magnitude()
                    }
                };
                over &= smooth[i] || grown;
                resolved[i] |= smooth[i] || grown;
                // Rounding is there at the distance before as well; jumps and kinks come into reach at one distance.
                let both = [deviation, before[i].magnitude()];
                before[i] = R::from_f64(deviation);
                let seen = both[0].min(both[1]);
                let counts = match start {
                    Start::Near => !(smooth[i] || grown),
                    // That of stairs is alike at both.
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
            // Among stairs one entry may be smooth at no distance where others of its unit are: it is rounded as they are.
            let alike = |j: &usize| kind(kinds, *j) == kind(kinds, i);
            let known = (0..n).filter(alike).filter(|j| resolved[*j]);
            let (count, least) =
                known.fold((0, noise[i].magnitude()), |(count, least), j| (count + 1, least.min(noise[j].magnitude())));
            let most = 2 * count >= (0..n).filter(alike).count();
            noise[i] = if start == Start::Corrections && most { R::from_f64(least) } else { zero() };
        }
    }
}

/// Divided differences of an order of those of the order before, each of `n` entries, in place of all values but the last.
fn divide<R: Real>(values: &mut [R], n: usize, order: usize) {
    for j in 0..values.len() - n {
        let width = NODES[j / n + order] - NODES[j / n];
        values[j] = (values[j + n] - values[j]) * R::from_f64(1.0 / width);
    }
}

/// The standard deviation of each divided difference of an order, for noise of 1.
fn deviations(order: usize) -> [f64; POINTS] {
    core::array::from_fn(|first| {
        let Some(nodes) = NODES.get(first..=first + order) else { return f64::INFINITY };
        let weight = |x: &f64| nodes.iter().filter(|y| *y != x).map(|y| x - y).product::<f64>();
        Real::sqrt(nodes.iter().map(|x| 1.0 / (weight(x) * weight(x))).sum::<f64>())
    })
}

/// The magnitudes of entry `i` of `n` in units of their deviations, in order; those that are not there are infinite.
fn by_rank<R: Real>(values: &[R], i: usize, n: usize, deviations: &[f64; POINTS]) -> [f64; POINTS] {
    let mut sizes = [f64::INFINITY; POINTS];
    // A sort of the standard library is code for lists of any length.
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
