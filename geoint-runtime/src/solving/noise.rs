//! How large is the rounding of a residual?
//!
//! Forces between neighbours cancel, and quotients divide by small numbers: a residual may be rounded to far more than the last digits of the
//! unknowns. Its terms are not known to a solver, but their rounding is seen where the residual is evaluated at neighbouring points: high
//! differences of a smooth function are small, those of its rounding are not. J. J. Moré & S. M. Wild, SIAM J. Sci. Comput. 33 (2011) 1292.

use crate::scalar::{Real, zero};
use crate::solving::rounding::is_rounding;
use crate::solving::size::Sizes;
use crate::space::Array;

/// Points on a line at which the residual is evaluated.
const POINTS: usize = 16;

/// The order of the differences, and the standard deviation of one for noise of 1: (8 choose 4)½.
const ORDER: usize = 4;
const DEVIATION: f64 = 8.366_600_265_340_756;

/// The same for differences of lower orders, from 2 on: (4 choose 2)½, (6 choose 3)½.
const LOWER_DEVIATIONS: [f64; ORDER - 2] = [2.449_489_742_783_178, 4.472_135_954_999_58];

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
/// Nearer than `nearest`, relative to `sizes`, all points may have terms that are rounded alike, and the residual is as smooth as x.
///
/// Unknowns of the same `kind` have one unit: they are moved by as much as the largest of them. The residual is `None` where there is none.
#[cold]
#[inline(never)]
pub(crate) fn measure<A: Array>(
    sizes: &Sizes<A>,
    (x, nearest): (&A, f64),
    kind: impl Fn(usize) -> usize,
    mut residual: impl FnMut(&A) -> Option<A>,
) -> A {
    let mut direction = A::zero();
    for (i, d) in direction.as_mut_slice().iter_mut().enumerate() {
        let unit = (0..A::LEN).filter(|j| kind(*j) == kind(i)).map(|j| sizes.of(j)).fold(0.0, f64::max);
        // By different parts of that, so that differences of neighbours change, and each by something else.
        let golden = 0.618_033_988_749_894_9 * ((i + 1) * (i + 1)) as f64;
        *d = A::Real::from_f64(unit * (0.5 + (golden - libm::floor(golden))));
    }
    let growth = libm::pow(A::Real::epsilon(), -1.0 / f64::from(DISTANCES_PER_EPSILON));
    let (mut noise, mut smooth, mut resolved) = (A::zero(), A::fill(false), A::fill(false));
    let mut distance = if nearest <= MOST_NEAR { nearest.max(A::Real::epsilon()) } else { A::Real::epsilon() };
    let (smooth, resolved) = (A::entries(&mut smooth), A::entries(&mut resolved));
    'distances: for _ in 0..REACH * DISTANCES_PER_EPSILON {
        let mut differences = [A::zero(); POINTS];
        for (j, value) in differences.iter_mut().enumerate() {
            let mut moved = *x;
            moved.add_scaled(A::Real::from_f64(distance * j as f64), &direction);
            match residual(&moved) {
                Some(r) if r.is_finite() => *value = r,
                _ => break 'distances,
            }
        }
        let mut spread = differences[POINTS - 1];
        spread.add_scaled(A::Real::from_f64(-1.0), &differences[0]);
        let mut lower = [A::zero(); ORDER - 2];
        difference(&mut differences);
        for (order, (lower, deviation)) in (2..).zip(lower.iter_mut().zip(LOWER_DEVIATIONS)) {
            difference(&mut differences[..=POINTS - order]);
            for (i, lower) in lower.as_mut_slice().iter_mut().enumerate() {
                *lower = A::Real::from_f64(by_rank(&differences[..POINTS - order], i)[QUARTER] / deviation);
            }
        }
        difference(&mut differences[..=POINTS - ORDER]);
        let mut over = true;
        for i in 0..A::LEN {
            let last = lower.iter().fold(0.0, |last, lower| lower.as_slice()[i].magnitude().max(SMOOTH * last));
            let high = by_rank(&differences[..POINTS - ORDER], i).map(|x| x / DEVIATION);
            let deviation = high[HALF] / MEDIAN;
            smooth[i] |= high[MOST] < SMOOTH * last;
            // Far away other terms are rounded: those that the residual has grown by.
            let grown = distance > NEAR && deviation <= GROWN * A::Real::epsilon() * spread.as_slice()[i].magnitude();
            over &= smooth[i] || grown;
            resolved[i] |= smooth[i] || grown;
            let noise = &mut noise.as_mut_slice()[i];
            if !(smooth[i] || grown) && deviation > noise.magnitude() {
                *noise = A::Real::from_f64(deviation);
            }
        }
        if over {
            break;
        }
        distance *= growth;
    }
    for (noise, resolved) in noise.as_mut_slice().iter_mut().zip(resolved) {
        if !*resolved {
            *noise = zero();
        }
    }
    noise
}

/// Whether a residual at `x` is nothing but rounding: its own, of which the standard deviation is `noise`, or that of the unknowns.
pub(crate) fn explains<A: Array>(noise: &A, residual: &A, sizes: &Sizes<A>) -> bool {
    (0..A::LEN).all(|i| {
        let left = residual.as_slice()[i].magnitude();
        left <= DEVIATIONS * noise.as_slice()[i].magnitude() || is_rounding::<A::Real>(left / sizes.of(i))
    })
}

/// Differences of neighbours, in place of all values but the last.
fn difference<A: Array>(values: &mut [A]) {
    for j in 1..values.len() {
        let mut change = values[j];
        change.add_scaled(A::Real::from_f64(-1.0), &values[j - 1]);
        values[j - 1] = change;
    }
}

/// The magnitudes of entry `i`, in order; those that are not there are infinite.
fn by_rank<A: Array>(values: &[A], i: usize) -> [f64; POINTS] {
    let mut sizes = [f64::INFINITY; POINTS];
    // A sort of the standard library is code for lists of any length.
    for (n, value) in values.iter().enumerate() {
        let size = value.as_slice()[i].magnitude();
        let mut place = n;
        while place > 0 && sizes[place - 1].total_cmp(&size).is_gt() {
            sizes[place] = sizes[place - 1];
            place -= 1;
        }
        sizes[place] = size;
    }
    sizes
}
