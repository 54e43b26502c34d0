//! Damped Newton corrections x ← x − w δ with δ = J⁻¹ r(x). The factor w starts at 1 and is halved until the residual r falls. J is the derivative of r.
//!
//! They find a guess if whole corrections (w = 1) from the explicit guess fail. At steep walls and in stiff wells, this guess may lie outside of the domain of
//! the energy, or so far from the solution that whole corrections diverge.

use crate::scalar::Real;
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::vector::{moved, scaled};
use crate::space::{Array, Square};

/// The iteration ends after a whole correction below this part of the sizes. Newton's iteration follows, and needs about three more corrections. A smaller
/// value would repeat its work here.
const NEAR: f64 = 1e-3;

/// The iteration ends if the residual does not fall for a w below this value. A smaller value would only delay this end at a minimum of the residual.
const SMALLEST_FACTOR: f64 = 1e-6;

/// The largest number of corrections. The iteration then ends without an error.
const MAX_ITERATIONS: u32 = 100;

/// Returns a guess for Newton's iteration: the end of a damped iteration from `standstill`·origin, where the energy is usually defined
/// ([`standstill`](super::equation::StepEquation::standstill)).
///
/// A factor w is accepted if |r(x − w δ)|² < (1 − w/2) |r(x)|². The norm sums the squares of entries in units of their sizes. Limit: the end need not be near
/// a solution. It may be a minimum of |r|, a point with a singular J, or the last point that [`MAX_ITERATIONS`] allows.
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
    // Entries of the residual have the units of the unknowns, so both have one size.
    let mut sizes = *sizes;
    sizes.include(origin, &x);
    sizes.include(&A::zero(), &r);
    for _ in 0..MAX_ITERATIONS {
        let mut delta = r;
        if linear::solve(&mut matrix, &mut delta, &sizes).is_none() {
            break;
        }
        let mut w = 1.0;
        // NaN does not fall, so a point outside of the domain of the energy halves w.
        let falls = |w: f64, next_r: &A| sizes.square(next_r) < (1.0 - 0.5 * w) * sizes.square(&r);
        let (next, next_r) = loop {
            let next = moved(&x, A::Real::from_f64(-w), &delta);
            let next_r = residual(&next, &mut matrix);
            if falls(w, &next_r) {
                break (next, next_r);
            }
            if w < SMALLEST_FACTOR {
                return x;
            }
            w *= 0.5;
        };
        (x, r) = (next, next_r);
        if w == 1.0 && sizes.square(&delta) <= NEAR * NEAR {
            break;
        }
    }
    x
}
