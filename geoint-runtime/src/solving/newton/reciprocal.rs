//! The derivative of one equation in one unknown, for the correction of the next one.

use crate::scalar::Real;
use crate::space::vector::product;
use crate::space::{Array, Record, Square, Tape};

/// 1/(1 − g') at the guess of a step, which hardly changes from step to step.
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

    /// The correction by the derivative of the step before. No division keeps it waiting.
    #[inline(always)]
    pub(super) fn early(&self, residual: &A) -> A {
        product(&self.0, residual)
    }

    /// The correction by that of this step, in place of the residual; whether the derivative is positive.
    #[inline(always)]
    pub(super) fn solve(&mut self, matrix: &Square<A>, residual: &mut A) -> bool {
        let (pivot, one) = (A::entries_of::<A>(matrix)[0].as_slice()[0], A::Real::from_f64(1.0));
        self.0.as_mut_slice()[0] = one / pivot;
        *residual = product(&self.0, residual);
        pivot.all_at_least_zero()
    }
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
