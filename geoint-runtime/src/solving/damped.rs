//! Damped Newton corrections x ← x − w δ with δ = J⁻¹ r(x): w starts at 1 and is halved until the residual r falls. J is the derivative of r.
//!
//! They are tried after whole corrections have failed. At steep walls and in stiff wells, the explicit guess may be outside of the domain of the energy, or so
//! far from the solution that whole corrections diverge.

use crate::scalar::Real;
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::vector::{moved, scaled};
use crate::space::{Array, Square};

/// The approach ends after a whole correction (w = 1) below this part of the state. Newton's iteration follows, and needs about three more corrections. A
/// smaller value would repeat its work here.
const NEAR: f64 = 1e-3;

/// The approach ends if the residual does not fall for a w below this value. A smaller value would only delay this end at a minimum of the residual.
const SHORTEST: f64 = 1e-6;

/// The largest number of corrections. The approach then ends without an error.
const MAX_ITERATIONS: u32 = 100;

/// Returns the end of a damped iteration from `standstill`·origin, where positions do not move and the energy is defined. The point is near a solution of
/// residual(x) = 0, or at a minimum of the residual with a singular derivative. The caller decides which by Newton's iteration.
///
/// A step w is accepted if |r(x − w δ)|² < (1 − w/2) |r(x)|². The norm sums the squares of entries in units of their sizes.
#[cold]
#[inline(never)]
pub(crate) fn approach<A: Array>(
    origin: &A,
    standstill: f64,
    sizes: &Sizes<A>,
    mut residual: impl FnMut(&A, &mut Square<A>) -> A,
) -> A {
    let mut matrix = A::fill(A::zero());
    let mut x = scaled(A::Real::from_f64(standstill), origin);
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
        // NaN does not fall, so a point outside of the domain of the energy halves w.
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
