//! Newton's iteration with a matrix that is not quite the derivative: corrections shrink by a factor, not by squares.

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::damped;
use crate::solving::linear;
use crate::solving::newton::relative_square;
use crate::space::{Array, Square};

/// Reached only where there is no convergence worth the name.
const MAX_ITERATIONS: u32 = 100;

/// Iterations without a smaller correction than all before are due to rounding if there are so many.
const MOST_STUCK: u32 = 4;

/// An error of so many roundings cannot be seen in the result.
const LEFT_OVER: f64 = 1.0 / 1024.0;

/// A correction of so many roundings that does not shrink any more is nothing else.
const ROUNDINGS: f64 = 1024.0;

/// Solves `residual(x) = 0` for an increment of `origin`, to rounding, from `guess` on; or, if that fails, from where damped
/// corrections lead.
///
/// `residual` writes the residual and a matrix near its derivative. What is left after a correction is about the next one:
/// the iteration ends where that is bound to be below rounding, or where rounding keeps corrections from shrinking.
/// The determinant has the meaning that it has for Newton's iteration.
#[inline(always)]
pub(crate) fn solve<A: Array>(
    origin: &A,
    guess: A,
    mut residual: impl FnMut(&A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
) -> Result<A, Refusal> {
    // A guess may look beyond the domain of the energy where the solution need not.
    let guess = if guess.is_finite() { guess } else { A::zero() };
    iterate(origin, guess, &mut residual).or_else(|refusal| {
        iterate(origin, damped::approach(origin, 0.0, &mut residual), &mut residual).map_err(|_| refusal)
    })
}

fn iterate<A: Array>(
    origin: &A,
    mut x: A,
    residual: &mut impl FnMut(&A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
) -> Result<A, Refusal> {
    let epsilon = A::Real::epsilon();
    let mut matrix = A::fill(A::zero());
    let (mut before, mut smallest, mut stuck) = (f64::INFINITY, f64::INFINITY, 0);
    for iterations in 1..=MAX_ITERATIONS {
        let mut delta = A::zero();
        residual(&x, &mut delta, &mut matrix)?;
        let Some(positive) = linear::solve(&mut matrix, &mut delta) else {
            let not_converged = Refusal::NotConverged { iterations, correction: before };
            return Err(if delta.is_finite() { Refusal::Singular } else { not_converged });
        };
        x.add_scaled(A::Real::from_f64(-1.0), &delta);
        let correction = relative_square(&delta, &x, origin).sqrt();
        let next = correction * (correction / before);
        // Once may be chance: corrections that turn round one another shrink on the whole.
        stuck = if correction < smallest { 0 } else { stuck + 1 };
        smallest = smallest.min(correction);
        let rounding = correction >= before && correction <= ROUNDINGS * epsilon;
        if correction == 0.0
            || iterations > 1
                && (next <= LEFT_OVER * epsilon
                    || rounding
                    || stuck >= MOST_STUCK && correction * correction <= epsilon)
        {
            return if positive { Ok(x) } else { Err(Refusal::Singular) };
        }
        if !correction.is_finite() {
            return Err(Refusal::NotConverged { iterations, correction });
        }
        // What a correction shrinks to says nothing if it was larger than the solution.
        before = correction.min(1.0);
    }
    Err(Refusal::NotConverged { iterations: MAX_ITERATIONS, correction: before })
}
