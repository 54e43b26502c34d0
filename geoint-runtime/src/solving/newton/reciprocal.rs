//! The derivative of one equation in one unknown, for the correction of the next one.

use crate::scalar::{Real, zero};
use crate::space::{Array, Record, Square, Tape};

/// A derivative that has changed by so little, relative, is followed: of what a correction by the one before misses three terms of a series are then
/// enough, the next one is 2⁻²⁰ of the correction.
const LITTLE: f64 = 1.0 / 32.0;

/// 1/(1 − g') where it was evaluated last, which hardly changes from step to step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reciprocal<A>(A);

impl<A: Array> Record<A::Real> for Reciprocal<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        if Self::KNOWN {
            tape.array(&mut self.0);
        }
    }
}

impl<A: Array> Reciprocal<A> {
    /// Whether there is one.
    pub(super) const KNOWN: bool = A::LEN == 1;

    /// Of no step.
    pub(super) fn new() -> Self {
        Reciprocal(A::zero())
    }

    /// The correction by the derivative before, and what it is too large by, if the derivative m has changed little: of mr = 1 + c with the reciprocal r
    /// before, e − e/(1 + c) is ec(1 − c + c²). Then m is positive as r is, and its reciprocal is r(1 − c + c²). No division keeps the correction
    /// waiting, nor is there one.
    #[inline(always)]
    pub(super) fn followed(&mut self, matrix: &Square<A>, residual: &A) -> Option<(A, A)> {
        let (pivot, reciprocal) = (pivot::<A>(matrix), &mut self.0.as_mut_slice()[0]);
        let one = A::Real::from_f64(1.0);
        let change = pivot.multiply_add(*reciprocal, -one);
        let changes_little = change.magnitude() <= LITTLE;
        if !changes_little {
            return None;
        }
        let (mut early, mut missed) = (*residual, A::zero());
        early.as_mut_slice()[0] *= *reciprocal;
        let inverse = (-change).multiply_add(one - change, one);
        missed.as_mut_slice()[0] = early.as_slice()[0] * change * inverse;
        *reciprocal *= inverse;
        Some((early, missed))
    }

    /// The correction by the derivative here, in place of the residual; whether the derivative is positive. None is known after one that is not.
    #[inline(always)]
    pub(super) fn solve(&mut self, matrix: &Square<A>, residual: &mut A) -> bool {
        let (pivot, one) = (pivot::<A>(matrix), A::Real::from_f64(1.0));
        let (reciprocal, positive) = (one / pivot, pivot.all_at_least_zero());
        residual.as_mut_slice()[0] *= reciprocal;
        self.0.as_mut_slice()[0] = if positive { reciprocal } else { zero() };
        positive
    }
}

/// The one entry of a matrix.
#[inline(always)]
fn pivot<A: Array>(matrix: &Square<A>) -> A::Real {
    A::entries_of::<A>(matrix)[0].as_slice()[0]
}

#[cfg(test)]
mod tests {
    use super::super::curved::{Count, Curved};
    use super::super::{Found, Newton};

    /// x = a + bx, where b changes from step to step.
    #[test]
    fn what_the_derivative_of_the_step_before_misses_is_carried() {
        let (mut newton, mut missed) = (Newton::<[f32; 1]>::new(1, 1), 0.0_f64);
        for n in 0..1000 {
            let phase = 0.05 * f64::from(n);
            let equation = Curved { a: 1.5 + phase.sin(), b: 0.1 * phase.cos(), c: 0.0 };
            let Found { x: [x], lost: [lost], outcome } = newton.solve(&equation, &mut Count(0));
            assert!(outcome.is_ok());
            let [x, lost, exact] = [f64::from(x), f64::from(lost), equation.a / (1.0 - equation.b)];
            assert!((x + lost - exact).abs() < 1e-9, "step {n}: {:.1e}", x + lost - exact);
            missed = missed.max((x - exact).abs());
        }
        // The last digit of x alone would be half of 2.4e-7 at most.
        assert!(missed > 3e-7, "{missed:.1e}");
    }
}
