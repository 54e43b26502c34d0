//! Newton's iteration for the increment of an implicit step.

use crate::array::{Array, Square};
use crate::linear;
use crate::method::NotConverged;
use crate::real::Real;

/// Far more than quadratic convergence ever needs; reached only where there is no convergence.
const MAX_ITERATIONS: u32 = 40;

/// Where corrections no longer shrink because of rounding, they are at least this small.
const STAGNATION: f64 = 1e-9;

/// Solves `residual(x) = 0` for an increment of `origin` from a guess, to rounding.
///
/// `residual` writes the residual and its derivative. The iteration does not stop at a tolerance but where the next
/// correction is bound to be below the rounding of `origin + x`: symmetry of a step, and the order of its compositions,
/// hold only at the solved point. Convergence is quadratic: a correction that shrank by a factor θ is followed by one
/// that shrinks by θ² or better.
#[inline(always)]
pub(crate) fn solve<A: Array>(
    guess: A,
    origin: A,
    mut residual: impl FnMut(&A, &mut A, &mut Square<A>),
) -> Result<A, NotConverged> {
    // What is left over has the same sign in every step, and adds up: with ε/16 the energy of a pendulum drifted by 10⁻¹² in
    // a million steps.
    let rounding = A::Real::epsilon() / 1024.0;
    // A guess may look beyond the domain of the energy where the solution need not.
    let mut x = if guess.is_finite() { guess } else { A::zero() };
    let mut jacobian = A::fill(A::zero());
    let mut before = f64::INFINITY;
    for iterations in 1..=MAX_ITERATIONS {
        let mut delta = A::zero();
        residual(&x, &mut delta, &mut jacobian);
        if !linear::solve(&mut jacobian, &mut delta) {
            return Err(NotConverged { iterations, correction: before });
        }
        for (x, d) in x.as_mut_slice().iter_mut().zip(delta.as_slice()) {
            *x -= *d;
        }
        let correction = relative(&delta, &x, &origin);
        // The first correction is that of the guess, which Newton's iteration has not improved yet.
        let shrunk = if iterations == 1 { correction.sqrt() } else { correction / before };
        let next = correction * shrunk * shrunk;
        if next <= rounding || (shrunk > 0.25 && correction <= STAGNATION) {
            return Ok(x);
        }
        if !correction.is_finite() {
            return Err(NotConverged { iterations, correction });
        }
        before = correction;
    }
    Err(NotConverged { iterations: MAX_ITERATIONS, correction: before })
}

/// The largest entry of `delta`, each relative to the entry of `origin + x` that it corrects.
///
/// An entry that happens to be almost zero is measured against a millionth of the largest one: entries may have
/// different units, but are not solved beyond what rounding allows.
#[inline(always)]
fn relative<A: Array>(delta: &A, x: &A, origin: &A) -> f64 {
    let size = |i: usize| origin.as_slice()[i].magnitude() + x.as_slice()[i].magnitude();
    let mut largest = 0.0_f64;
    for i in 0..A::LEN {
        largest = largest.max(size(i));
    }
    let mut correction = 0.0;
    for i in 0..A::LEN {
        let change = delta.as_slice()[i].magnitude();
        let ratio = change / size(i).max(1e-6 * largest);
        // Not `max`: that would lose a NaN. Nothing to correct is no correction, even of zero.
        if change != 0.0 && (ratio > correction || ratio.is_nan()) {
            correction = ratio;
        }
    }
    correction
}
