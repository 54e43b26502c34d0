//! What the next increment will be, from those before.

use crate::scalar::Real;
use crate::space::Array;

/// How many increments are extrapolated. At usual step sizes the ninth difference is about as large as the accuracy that leaves
/// nothing to do for a second Newton iteration.
const POINTS: usize = 9;

/// (−1)ʲ (9 choose j + 1), j = 0 … 3; those of j = 4 … 7 are their opposites, and the last is 1: the ninth difference of the
/// sequence is zero.
const WEIGHTS: [f64; 4] = [9.0, -36.0, 84.0, -126.0];

/// Extrapolates a smooth sequence by a polynomial through its last terms.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Predictor<A> {
    /// The latest first.
    terms: [A; POINTS],
    pub(crate) started: bool,
}

impl<A: Array> Predictor<A> {
    pub(crate) fn new() -> Self {
        Predictor { terms: [A::zero(); POINTS], started: false }
    }

    /// The next term: only one product and one sum wait for the latest one. Other terms of opposite weights are one product.
    #[inline(always)]
    pub(crate) fn predict(&self) -> A {
        let [latest, inner @ .., before, oldest] = &self.terms;
        let mut sum = *oldest;
        sum.add_scaled(A::Real::from_f64(-WEIGHTS[0]), before);
        for j in (0..3).rev() {
            let mut pair = inner[j];
            pair.add_scaled(A::Real::from_f64(-1.0), &inner[5 - j]);
            sum.add_scaled(A::Real::from_f64(WEIGHTS[j + 1]), &pair);
        }
        sum.add_scaled(A::Real::from_f64(WEIGHTS[0]), latest);
        sum
    }

    /// The sequence goes on. Before its first term it is taken to have been constant.
    #[inline(always)]
    pub(crate) fn push(&mut self, term: &A) {
        if !self.started {
            (self.terms, self.started) = ([*term; POINTS], true);
        }
        for j in (1..POINTS).rev() {
            self.terms[j] = self.terms[j - 1];
        }
        self.terms[0] = *term;
    }
}
