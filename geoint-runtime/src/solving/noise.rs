//! How large is the rounding of a residual?
//!
//! Forces between neighbours cancel, and quotients divide by small numbers: a residual may be rounded to far more than the last digits of the
//! unknowns. Its terms are not known to a solver, but their rounding is seen where the residual is evaluated at neighbouring points: high
//! differences of a smooth function are small, those of its rounding are not. J. J. Moré & S. M. Wild, SIAM J. Sci. Comput. 33 (2011) 1292.

use crate::scalar::{Real, zero};
use crate::solving::rounding::is_rounding;
use crate::solving::size::{Sizes, largest};
use crate::space::Array;
use crate::space::vector::difference;

/// Points on a line at which the residual is evaluated.
const POINTS: usize = 16;

/// Places for a spread, two deviations, and for differences of lower orders.
const SPARE: usize = 3 + LOWER;

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

/// The irrational number that has the worst approximations by ratios.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Differences by rank: a jump changes as many of them as their order is. A quarter of them, half of them, and as many as a jump leaves as
/// they were. Of normal noise half reach to 0.67 of the standard deviation.
const QUARTER: usize = 3;
const HALF: usize = 5;
const MOST: usize = POINTS - 2 * ORDER - 1;
const MEDIAN: f64 = 0.67;

/// Differences that all shrink by more than this from order to order are those of a smooth function. One of two orders may have a zero.
const SMOOTH: f64 = 0.25;

/// A residual of so many standard deviations of its rounding is nothing but that: it is the sum of several, and they are known from a
/// few differences only.
const DEVIATIONS: f64 = 16.0;

/// Distances grow by ε^(−1/8): where the differences of order 4 leave the rounding, they are smooth at the next distance.
const DISTANCES_PER_EPSILON: i32 = 8;

/// An unknown that is rounding itself has a residual of its own size.
const LARGEST: f64 = 1024.0;

/// Unknowns that are moved by more than this part of them are far away. Noise of less than so many ε of what the residual changes by is
/// none of the point then.
const NEAR: f64 = 1.0 / 16.0;

/// Farther than this a function that is smooth may not look so.
const MOST_NEAR: f64 = 1e-3;
const GROWN: f64 = 8.0;

/// Distances reach from the last digit of the unknowns to this power of 1/ε times it.
const REACH: i32 = 2;

/// The standard deviation of the rounding of every entry of a residual near `x`.
///
/// Zero where the residual is smooth at no distance: the digits of the unknowns do not resolve it, and nothing is known of its rounding.
///
/// Unknowns come in `kinds` of so many that have one unit: they are moved by as much as the largest of them. Nearer than `farther` times the
/// last correction `delta` all points may have terms that are rounded alike, and the residual is as smooth as x. Where the first points are too far
/// apart, the residual of a small unknown beside large ones is smooth already, and its rounding is not seen. The residual is `None` where there is
/// none.
#[cold]
#[inline(never)]
pub(crate) fn measure<A: Array>(
    sizes: &Sizes<A>,
    x: &A,
    (delta, farther): (&A, f64),
    kinds: [usize; 2],
    mut residual: impl FnMut(&A) -> Option<A>,
) -> A {
    let (mut direction, mut noise) = (A::zero(), A::zero());
    along(sizes.as_slice(), kinds, direction.as_mut_slice());
    let digits = last_digits(x, &direction, &mut residual);
    let nearest = begin((delta.as_slice(), farther), kinds, direction.as_mut_slice());
    let (mut memory, mut marks) = ([A::zero(); POINTS + SPARE], [A::fill(false); 2]);
    let [smooth, resolved] = &mut marks;
    let memory = Memory {
        values: A::flatten_mut(&mut memory),
        smooth: A::entries(smooth),
        resolved: A::entries(resolved),
        noise: noise.as_mut_slice(),
    };
    memory.measure(nearest, &mut |distance, value| {
        let mut moved = *x;
        moved.add_scaled(distance, &direction);
        match residual(&moved) {
            Some(r) if r.is_finite() => {
                value.copy_from_slice(r.as_slice());
                true
            }
            _ => false,
        }
    });
    // What the last digits of coordinates change is no less rounding than what is computed with them.
    for (noise, digits) in noise.as_mut_slice().iter_mut().zip(digits.as_slice()) {
        if noise.magnitude() < digits.magnitude() {
            *noise = *digits;
        }
    }
    noise
}

/// What a residual changes by where coordinates are moved by their last digit, to the side to which it changes less: to the other one there may be a
/// jump.
fn last_digits<A: Array>(x: &A, direction: &A, residual: &mut impl FnMut(&A) -> Option<A>) -> A {
    let Some(here) = residual(x) else { return A::zero() };
    let mut change = |sign: f64| {
        let mut moved = *x;
        moved.add_scaled(A::Real::from_f64(2.0 * sign * A::Real::epsilon()), direction);
        residual(&moved).map_or(A::zero(), |there| difference(&there, &here))
    };
    let (mut least, other) = (change(1.0), change(-1.0));
    for (least, other) in least.as_mut_slice().iter_mut().zip(other.as_slice()) {
        // What is not a number is no change.
        *least = if least.magnitude() <= other.magnitude() { *least } else { *other };
    }
    least
}

/// The direction in which unknowns are moved.
#[inline(never)]
fn along<R: Real>(sizes: &[R], [n, kinds]: [usize; 2], direction: &mut [R]) {
    let kind = |i: usize| i / n % kinds;
    for (i, d) in direction.iter_mut().enumerate() {
        let alike = sizes.iter().enumerate().filter(|(j, _)| kind(*j) == kind(i));
        let unit = alike.map(|(_, size)| size.magnitude()).fold(0.0, f64::max);
        // By different parts of that, so that differences of neighbours change, and each by something else.
        let golden = GOLDEN * ((i + 1) * (i + 1)) as f64;
        *d = R::from_f64(unit * (0.5 + (golden - libm::floor(golden))));
    }
}

/// How much of a direction the first distance is. Unknowns of each kind begin near their own corrections: an angle may be large beside all in
/// which a function of it changes.
#[inline(never)]
fn begin<R: Real>((delta, farther): (&[R], f64), [n, kinds]: [usize; 2], direction: &mut [R]) -> f64 {
    let kind = |i: usize| i / n % kinds;
    // The largest part of the direction that corrections of a kind are.
    let first = |direction: &[R], k: usize| {
        let part = |(i, (delta, size)): (usize, (&R, &R))| {
            if kind(i) != k || delta.magnitude() == 0.0 { 0.0 } else { delta.magnitude() / size.magnitude() }
        };
        let nearest = farther * largest(delta.iter().zip(direction).enumerate().map(part));
        if nearest <= MOST_NEAR { nearest.max(R::epsilon()) } else { R::epsilon() }
    };
    let nearest = (0..kinds).map(|k| first(direction, k)).fold(0.0, f64::max);
    for k in 0..kinds {
        let less = R::from_f64(first(direction, k) / nearest);
        direction.iter_mut().enumerate().filter(|(i, _)| kind(*i) == k).for_each(|(_, d)| *d *= less);
    }
    nearest
}

/// A residual at so much of a direction; whether there is one.
type Residual<'a, R> = dyn FnMut(R, &mut [R]) -> bool + 'a;

/// What is remembered while rounding is measured. No shape of unknowns is known here: it is compiled once for all of them.
struct Memory<'a, R> {
    /// The residuals at all points, and in spare places how they spread, and their differences of lower orders.
    values: &'a mut [R],
    /// Entries that have been smooth, and those of which the rounding was seen.
    smooth: &'a mut [bool],
    resolved: &'a mut [bool],
    noise: &'a mut [R],
}

impl<R: Real> Memory<'_, R> {
    #[cold]
    #[inline(never)]
    fn measure(self, nearest: f64, residual: &mut Residual<'_, R>) {
        let Memory { values, smooth, resolved, noise } = self;
        let n = noise.len();
        let (differences, spare) = values.split_at_mut(POINTS * n);
        let (spread, lower) = spare.split_at_mut(n);
        let (least, lower) = lower.split_at_mut(n);
        let (before, lower) = lower.split_at_mut(n);
        before.fill(R::from_f64(f64::INFINITY));
        let growth = libm::pow(R::epsilon(), -1.0 / f64::from(DISTANCES_PER_EPSILON));
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
                smooth[i] |= high[MOST] < SMOOTH * last;
                // Far away other terms are rounded: those that the residual has grown by.
                let grown = distance > NEAR && deviation <= GROWN * R::epsilon() * spread[i].magnitude();
                over &= smooth[i] || grown;
                resolved[i] |= smooth[i] || grown;
                // Rounding is there at the distance before as well; jumps and kinks come into reach at one distance.
                let seen = deviation.min(before[i].magnitude());
                before[i] = R::from_f64(deviation);
                if !(smooth[i] || grown) && seen > noise[i].magnitude() {
                    noise[i] = R::from_f64(seen);
                }
            }
            if over {
                break;
            }
            distance *= growth;
        }
        for (noise, resolved) in noise.iter_mut().zip(resolved) {
            if !*resolved {
                *noise = zero();
            }
        }
    }
}

/// The addresses of what is compiled once for a scalar.
pub(crate) fn compiled<R: Real>() -> [*const (); 2] {
    [Memory::<R>::measure as *const (), along::<R> as *const ()]
}

/// Whether a residual at `x` is nothing but rounding: its own, of which the standard deviation is `noise`, or that of the unknowns.
///
/// What is larger than the unknown by far is no solution, whatever it is: far away from all that a state has been, terms may be rounded to more
/// than they move.
pub(crate) fn explains<A: Array>(noise: &A, residual: &A, sizes: &Sizes<A>) -> bool {
    (0..A::LEN).all(|i| {
        let left = residual.as_slice()[i].magnitude();
        let small = left <= LARGEST * sizes.of(i);
        small && left <= DEVIATIONS * noise.as_slice()[i].magnitude() || is_rounding::<A::Real>(left / sizes.of(i))
    })
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
