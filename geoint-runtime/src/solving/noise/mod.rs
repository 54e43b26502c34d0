//! Measures the rounding of a residual.
//!
//! Forces between neighbours cancel, and quotients divide by small numbers. The rounding of a residual may therefore be far larger than the last
//! digits of the unknowns. A solver does not know the terms of the residual, but the rounding shows if the residual is evaluated at neighbouring
//! points: high differences of a smooth function are small, and high differences of rounding are not. J. J. Moré & S. M. Wild, SIAM J. Sci. Comput.
//! 33 (2011) 1292.

mod differences;
mod points;

use crate::scalar::Real;
use crate::solving::rounding::{is_rounding, may_be_rounding};
use crate::solving::size::{Sizes, Units};
use crate::space::Array;
use crate::space::vector::difference;
use differences::{Memory, POINTS, SPARE};
use points::{Start, along, begin};

/// The largest residual that counts as rounding, in standard deviations of its rounding. A residual is the sum of several rounding errors, and a few
/// differences determine the deviations only roughly.
const DEVIATIONS: f64 = 16.0;

/// Returns the standard deviation of the rounding of every entry of a residual near `x`.
///
/// `residual` returns `None` at points at which no residual exists. Unknowns move in proportion to the largest unknown of their kind.
///
/// The first measurement starts close to `x`. Points nearer than `farther` times the last correction `delta` may share equally rounded terms, and the
/// residual then looks as smooth as `x`. If the first points are too far apart, the residual of a small unknown beside large unknowns is already
/// smooth, and its rounding remains hidden.
///
/// The second measurement starts at the distance of the corrections. An unknown may be as small as the rounding of the quantity to which it is added.
/// Its corrections are then as large as the unknown itself, and the residual has stairs.
///
/// Differences yield zero for an entry that is smooth at no distance. The digits of the unknowns do not resolve this entry, and its rounding is
/// unknown.
#[cold]
#[inline(never)]
pub(crate) fn measure<A: Array>(
    sizes: &Sizes<A>,
    x: &A,
    (delta, farther): (&A, f64),
    units: Units,
    mut residual: impl FnMut(&A) -> Option<A>,
) -> A {
    let (mut direction, mut noise) = (A::zero(), A::zero());
    along(sizes.as_slice(), units, direction.as_mut_slice());
    // The last digits of the coordinates also change the residual. This change counts as rounding, like the rounding of the terms.
    let mut largest = last_digits(x, &direction, &mut residual);
    for start in [Start::Near, Start::Corrections] {
        let mut direction = direction;
        let Some(nearest) = begin((delta.as_slice(), farther), units, start, direction.as_mut_slice()) else { break };
        let (mut memory, mut marks) = ([A::zero(); POINTS + SPARE], [A::fill(false); 2]);
        let [smooth, resolved] = &mut marks;
        let memory = Memory {
            values: A::flatten_mut(&mut memory),
            smooth: A::entries(smooth),
            resolved: A::entries(resolved),
            noise: noise.as_mut_slice(),
        };
        memory.measure((nearest, farther), start, units, &mut |distance, value| {
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
        for (largest, noise) in largest.as_mut_slice().iter_mut().zip(noise.as_slice()) {
            if largest.magnitude() < noise.magnitude() {
                *largest = *noise;
            }
        }
    }
    largest
}

/// Returns the change of a residual if the coordinates move by their last digit to one side. The side with the smaller change counts, because the
/// other side may contain a jump.
fn last_digits<A: Array>(x: &A, direction: &A, residual: &mut impl FnMut(&A) -> Option<A>) -> A {
    let Some(here) = residual(x) else { return A::zero() };
    let mut change = |sign: f64| {
        let mut moved = *x;
        moved.add_scaled(A::Real::from_f64(2.0 * sign * A::Real::epsilon()), direction);
        residual(&moved).map_or(A::zero(), |there| difference(&there, &here))
    };
    let (mut least, other) = (change(1.0), change(-1.0));
    for (least, other) in least.as_mut_slice().iter_mut().zip(other.as_slice()) {
        // NaN does not count on either side.
        let (first, second) = (least.magnitude(), other.magnitude());
        *least = if second < first || first.is_nan() { *other } else { *least };
    }
    least
}

/// Returns whether rounding explains a residual. The rounding is either its own, with the standard deviation `noise`, or the rounding of the
/// unknowns.
pub(crate) fn explains<A: Array>(noise: &A, residual: &A, sizes: &Sizes<A>) -> bool {
    (0..A::LEN).all(|i| {
        let left = residual.as_slice()[i].magnitude();
        may_be_rounding(left, sizes.of(i)) && left <= DEVIATIONS * noise.as_slice()[i].magnitude()
            || is_rounding::<A::Real>(left / sizes.of(i))
    })
}

/// Returns the addresses of the functions that are compiled once for each scalar.
pub(crate) fn compiled<R: Real>() -> [*const (); 2] {
    [Memory::<R>::measure as *const (), along::<R> as *const ()]
}
