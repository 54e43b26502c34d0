//! How large is the rounding of a residual?
//!
//! Forces between neighbours cancel, and quotients divide by small numbers: a residual may be rounded to far more than the last digits of the
//! unknowns. Its terms are not known to a solver, but their rounding is seen where the residual is evaluated at neighbouring points: high
//! differences of a smooth function are small, those of its rounding are not. J. J. Moré & S. M. Wild, SIAM J. Sci. Comput. 33 (2011) 1292.

mod differences;
mod points;

use crate::scalar::Real;
use crate::solving::rounding::{is_rounding, may_be_rounding};
use crate::solving::size::Sizes;
use crate::space::Array;
use crate::space::vector::difference;
use differences::{Memory, POINTS, SPARE};
use points::{Start, along, begin};

/// A residual of so many standard deviations of its rounding is nothing but that: it is the sum of several, and they are known from a
/// few differences only.
const DEVIATIONS: f64 = 16.0;

/// The standard deviation of the rounding of every entry of a residual near `x`.
///
/// Zero where the residual is smooth at no distance: the digits of the unknowns do not resolve it, and nothing is known of its rounding.
///
/// Where unknowns are as small as the rounding of what they are added to, corrections are as large as they are, and the residual has stairs. So it
/// is looked at from there on, too.
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
    // What the last digits of coordinates change is no less rounding than what is computed with them.
    let mut largest = last_digits(x, &direction, &mut residual);
    for start in [Start::Near, Start::Corrections] {
        let mut direction = direction;
        let Some(nearest) = begin((delta.as_slice(), farther), kinds, start, direction.as_mut_slice()) else { break };
        let (mut memory, mut marks) = ([A::zero(); POINTS + SPARE], [A::fill(false); 2]);
        let [smooth, resolved] = &mut marks;
        let memory = Memory {
            values: A::flatten_mut(&mut memory),
            smooth: A::entries(smooth),
            resolved: A::entries(resolved),
            noise: noise.as_mut_slice(),
        };
        memory.measure((nearest, farther), start, kinds, &mut |distance, value| {
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

/// Whether a residual at `x` is nothing but rounding: its own, of which the standard deviation is `noise`, or that of the unknowns.
pub(crate) fn explains<A: Array>(noise: &A, residual: &A, sizes: &Sizes<A>) -> bool {
    (0..A::LEN).all(|i| {
        let left = residual.as_slice()[i].magnitude();
        may_be_rounding(left, sizes.of(i)) && left <= DEVIATIONS * noise.as_slice()[i].magnitude()
            || is_rounding::<A::Real>(left / sizes.of(i))
    })
}

/// The addresses of what is compiled once for a scalar.
pub(crate) fn compiled<R: Real>() -> [*const (); 2] {
    [Memory::<R>::measure as *const (), along::<R> as *const ()]
}
