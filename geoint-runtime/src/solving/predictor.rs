//! Extrapolation of a sequence by a polynomial in the number of the step. Each step adds a term: the unknown that its solver has found.
//!
//! The prediction x₊ is the value for which the n-th difference of x₊ and the last n terms is zero. With the latest term x₀, it is
//! x₊ = Σ (−1)ʲ (n choose j + 1) xⱼ, j = 0 … n − 1. This saves evaluations, because x₊ is closer to the solution than an explicit step.
//!
//! Precondition: steps have equal lengths. Callers create a new solver if the length changes. Limits: terms must be smooth in time. Their rounding errors grow
//! by a factor of up to 2ⁿ − 1.

use crate::scalar::Real;
use crate::space::vector::moved;
use crate::space::{Array, Record, Tape};

/// The number n of terms that are extrapolated. At usual step sizes the eleventh difference is so small that one correction of x₊ is enough, as
/// [`Experience`](super::experience::Experience) decides. Rounding errors grow by a factor of up to 2047. In `f64` they are then 5·10⁻¹³ of the
/// [size](super::size::Sizes) of a term. The correction removes them, too.
const TERMS: usize = 11;

/// (−1)ʲ (11 choose j + 1).
const WEIGHTS: [f64; TERMS] = [11.0, -55.0, 165.0, -330.0, 462.0, -462.0, 330.0, -165.0, 55.0, -11.0, 1.0];

/// The terms of the last steps, and the predicted term of the next step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Predictor<A> {
    /// The latest term first. Zeros in place of steps that have not been taken.
    terms: [A; TERMS],
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
    pub(super) const TERMS: usize = TERMS;

    pub(super) fn new() -> Self {
        Predictor { terms: [A::zero(); TERMS], next: A::zero() }
    }

    /// Returns the predicted term of the next step. Precondition: [`push`](Self::push) was called at least `TERMS` times.
    #[inline(always)]
    pub(super) fn predict(&self) -> A {
        self.next
    }

    /// Stores the latest term, and predicts the next one. The latest term comes last in the sum: a processor can add the others before the solver has
    /// delivered it.
    #[inline(always)]
    pub(super) fn push(&mut self, term: &A) {
        let mut next = A::zero();
        // `terms` does not contain the new term yet, so `terms[j − 1]` is the j-th term before it.
        //
        // The compiler unrolls two loops of five terms, but not one of ten. Left rolled, the loop would take a third of a short step.
        for j in (6..TERMS).rev() {
            next.add_scaled(A::Real::from_f64(WEIGHTS[j]), &self.terms[j - 1]);
        }
        for j in (1..6).rev() {
            next.add_scaled(A::Real::from_f64(WEIGHTS[j]), &self.terms[j - 1]);
        }
        self.next = moved(&next, A::Real::from_f64(WEIGHTS[0]), term);
        for j in (1..TERMS).rev() {
            self.terms[j] = self.terms[j - 1];
        }
        self.terms[0] = *term;
    }
}
