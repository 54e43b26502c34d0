//! Damped corrections: each one is halved until the residual falls.
//!
//! They are tried after whole corrections have failed. At steep walls and in stiff wells, the explicit guess may be outside of the domain of the energy, or so far
//! from the solution that whole corrections run away.

use crate::scalar::Real;
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::vector::{moved, scaled};
use crate::space::{Array, Square};

/// A whole correction below this part of the state ends the approach. Newton's iteration follows.
const NEAR: f64 = 1e-3;

/// The least part of a correction that is tried.
const SHORTEST: f64 = 1e-6;

const MAX_ITERATIONS: u32 = 100;

/// Returns the end of a damped iteration from `still`·origin, where nothing moves and the energy is defined. The point is near a solution of residual(x) = 0, or at a
/// minimum of the residual with a singular derivative; the caller finds out.
#[cold]
#[inline(never)]
pub(crate) fn approach<A: Array>(
    origin: &A,
    still: f64,
    sizes: &Sizes<A>,
    mut residual: impl FnMut(&A, &mut Square<A>) -> A,
) -> A {
    let mut matrix = A::fill(A::zero());
    let mut x = scaled(A::Real::from_f64(still), origin);
    let mut r = residual(&x, &mut matrix);
    // The residual has the units of the unknowns.
    let mut units = *sizes;
    units.include(origin, &x);
    units.include(&A::zero(), &r);
    for _ in 0..MAX_ITERATIONS {
        let mut delta = r;
        if linear::solve(&mut matrix, &mut delta, &units).is_none() {
            break;
        }
        let mut w = 1.0;
        // Not a number is not less.
        let falls = |w: f64, next: &A| units.square(next) < (1.0 - 0.5 * w) * units.square(&r);
        let (next, less) = loop {
            let next = moved(&x, A::Real::from_f64(-w), &delta);
            let less = residual(&next, &mut matrix);
            if falls(w, &less) {
                break (next, less);
            }
            if w < SHORTEST {
                return x;
            }
            w *= 0.5;
        };
        (x, r) = (next, less);
        if w == 1.0 && units.square(&delta) <= NEAR * NEAR {
            break;
        }
    }
    x
}
