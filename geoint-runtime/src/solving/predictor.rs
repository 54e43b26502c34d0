//! Extrapolation of the unknowns of the last steps.

use crate::ablation;
use crate::scalar::Real;
use crate::space::{Array, Record, Tape};

/// The number of earlier steps whose unknowns are extrapolated. Steps have equal lengths. At usual step sizes the eleventh difference is below the accuracy at which one
/// evaluation is enough.
const POINTS: usize = if ablation::ELEVEN_POINTS { 11 } else { 4 };

/// (−1)ʲ (n choose j + 1) for n = `POINTS`: the n-th difference of the sequence is taken for zero.
const WEIGHTS: [f64; POINTS] = {
    let (mut weights, mut j, mut binomial) = ([0.0; POINTS], 0, 1.0);
    while j < POINTS {
        // The product is divisible, so no digit is lost.
        binomial = binomial * (POINTS - j) as f64 / (j + 1) as f64;
        weights[j] = if j % 2 == 0 { binomial } else { -binomial };
        j += 1;
    }
    weights
};

/// The unknowns of the last steps, the latest first, and the next one.
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

    /// Returns the next term.
    #[inline(always)]
    pub(super) fn predict(&self) -> A {
        self.next
    }

    /// Appends a term to the sequence, and predicts the next one. The oldest term comes first, so that only one product and one sum wait for the latest one.
    #[inline(always)]
    pub(super) fn push(&mut self, term: &A) {
        self.next = A::zero();
        for (weight, before) in WEIGHTS[1..].iter().zip(&self.terms).rev() {
            self.next.add_scaled(A::Real::from_f64(*weight), before);
        }
        self.next.add_scaled(A::Real::from_f64(WEIGHTS[0]), term);
        for j in (1..POINTS).rev() {
            self.terms[j] = self.terms[j - 1];
        }
        self.terms[0] = *term;
    }
}
