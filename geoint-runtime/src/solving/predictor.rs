//! Extrapolation of the unknowns of the last steps by a polynomial in the number of the step.
//!
//! The next unknown x₊ follows if the n-th difference of the last n unknowns and x₊ is zero. Let x₀ be the latest unknown: x₊ = Σ (−1)ʲ (n choose j + 1) xⱼ,
//! j = 0 … n − 1. This saves evaluations, because x₊ is closer to the solution than an explicit step. Limits: steps must have equal lengths, and unknowns
//! must be smooth in time. Rounding errors of the unknowns grow by up to 2ⁿ − 1.

use crate::scalar::Real;
use crate::space::vector::moved;
use crate::space::{Array, Record, Tape};

/// The number n of earlier steps whose unknowns are extrapolated. At usual step sizes the eleventh difference is so small that one correction is enough, as
/// `experience` decides. Rounding errors grow by up to 2047, to 5·10⁻¹³ in `f64`, which is small enough, too.
const POINTS: usize = 11;

/// (−1)ʲ (11 choose j + 1).
const WEIGHTS: [f64; POINTS] = [11.0, -55.0, 165.0, -330.0, 462.0, -462.0, 330.0, -165.0, 55.0, -11.0, 1.0];

/// The unknowns of the last steps, the latest first, and the predicted unknown of the next step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Predictor<A> {
    /// Zeros in place of steps that have not been taken.
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

    /// Appends an unknown to the sequence, and predicts the next one. The latest term comes last in the sum, because its solver has only just finished.
    #[inline(always)]
    pub(super) fn push(&mut self, term: &A) {
        let mut next = A::zero();
        // The compiler unrolls two loops of five terms, but not one of ten, which would take a third of a short step.
        for j in (6..POINTS).rev() {
            next.add_scaled(A::Real::from_f64(WEIGHTS[j]), &self.terms[j - 1]);
        }
        for j in (1..6).rev() {
            next.add_scaled(A::Real::from_f64(WEIGHTS[j]), &self.terms[j - 1]);
        }
        self.next = moved(&next, A::Real::from_f64(WEIGHTS[0]), term);
        for j in (1..POINTS).rev() {
            self.terms[j] = self.terms[j - 1];
        }
        self.terms[0] = *term;
    }
}
