//! What the next increment will be, from those before.

use crate::scalar::Real;
use crate::space::{Array, Tape};

/// How many increments are extrapolated. At usual step sizes the eleventh difference is smaller than the accuracy that leaves nothing to do
/// for a second Newton iteration: with nine a sixth of the steps of predators and prey took a second one.
pub(crate) const POINTS: usize = 11;

/// (−1)ʲ (11 choose j + 1), j = 0 … 4; those of j = 5 … 9 are their opposites, and the last is 1: the eleventh difference of the
/// sequence is zero.
const WEIGHTS: [f64; 5] = [11.0, -55.0, 165.0, -330.0, 462.0];

/// Extrapolates a smooth sequence by a polynomial through its last terms.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Predictor<A> {
    /// The latest first.
    terms: [A; POINTS],
}

impl<A: Array> Predictor<A> {
    pub(crate) fn new() -> Self {
        Predictor { terms: [A::zero(); POINTS] }
    }

    /// The terms, the latest first.
    pub(crate) fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.terms.iter_mut().for_each(|term| tape.array(term));
    }

    /// The next term: only one product and one sum wait for the latest one. Other terms of opposite weights are one product.
    #[inline(always)]
    pub(crate) fn predict(&self) -> A {
        let [latest, inner @ .., before, oldest] = &self.terms;
        let mut sum = *oldest;
        sum.add_scaled(A::Real::from_f64(-WEIGHTS[0]), before);
        for j in (0..4).rev() {
            let mut pair = inner[j];
            pair.add_scaled(A::Real::from_f64(-1.0), &inner[7 - j]);
            sum.add_scaled(A::Real::from_f64(WEIGHTS[j + 1]), &pair);
        }
        sum.add_scaled(A::Real::from_f64(WEIGHTS[0]), latest);
        sum
    }

    /// The sequence goes on.
    #[inline(always)]
    pub(crate) fn push(&mut self, term: &A) {
        for j in (1..POINTS).rev() {
            self.terms[j] = self.terms[j - 1];
        }
        self.terms[0] = *term;
    }
}
