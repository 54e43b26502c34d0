//! Extrapolation of the unknowns of the last steps by a polynomial in the number of the step.
//!
//! The n-th difference of the last n unknowns and the next one is set to zero: x₊ = Σ (−1)ʲ (n choose j + 1) x₋ⱼ for j = 0 … n − 1. The latest unknown is x₋₀.
//! This saves evaluations, because x₊ is closer to the solution than an explicit step. Limits: steps must have equal lengths, and unknowns must be smooth in
//! time. Rounding errors of the unknowns grow by up to 2ⁿ − 1.

use crate::scalar::Real;
use crate::space::vector::{difference, moved};
use crate::space::{Array, Record, Tape};

/// The number n of earlier steps whose unknowns are extrapolated. At usual step sizes the eleventh difference is below the accuracy at which one evaluation is
/// enough.
const POINTS: usize = 11;

/// (−1)ʲ (11 choose j + 1) for j = 0 … 4. The weights of j = 5 … 9 are their opposites in reverse order, and the last weight is 1.
const WEIGHTS: [f64; 5] = [11.0, -55.0, 165.0, -330.0, 462.0];

/// The unknowns of the last steps, the latest first, and the predicted unknown of the next step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Predictor<A> {
    terms: [A; POINTS],
    next: A,
}

impl<A: Array> Record<A::Real> for Predictor<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.terms.iter_mut().for_each(|term| tape.array(term));
        tape.array(&mut self.next);
    }
}

impl<A: Array> Predictor<A> {
    /// The number of terms that a prediction needs.
    pub(super) const TERMS: usize = POINTS;

    pub(super) fn new() -> Self {
        Predictor { terms: [A::zero(); POINTS], next: A::zero() }
    }

    /// Returns the predicted unknown of the next step. Precondition: [`push`](Self::push) was called `TERMS` times.
    #[inline(always)]
    pub(super) fn predict(&self) -> A {
        self.next
    }

    /// Appends an unknown to the sequence, and predicts the next one. Two terms with opposite weights take one product. Only one product and one sum wait for the
    /// latest term, because it is added last.
    #[inline(always)]
    pub(super) fn push(&mut self, term: &A) {
        let weight = |j: usize| A::Real::from_f64(WEIGHTS[j]);
        let before = &self.terms;
        let mut next = moved(&before[9], -weight(0), &before[8]);
        for j in (0..4).rev() {
            next.add_scaled(weight(j + 1), &difference(&before[j], &before[7 - j]));
        }
        self.next = moved(&next, weight(0), term);
        for j in (1..POINTS).rev() {
            self.terms[j] = self.terms[j - 1];
        }
        self.terms[0] = *term;
    }
}
