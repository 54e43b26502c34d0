//! What the next increment will be, from those before.

use crate::ablation;
use crate::scalar::Real;
use crate::space::{Array, Tape};

/// How many increments are extrapolated. At usual step sizes the eleventh difference is smaller than the accuracy that leaves nothing to do
/// for a second Newton iteration: with nine a sixth of the steps of predators and prey took a second one.
pub(crate) const POINTS: usize = if ablation::ELEVEN_POINTS { 11 } else { FEW + 1 };

/// (−1)ʲ (11 choose j + 1), j = 0 … 4; those of j = 5 … 9 are their opposites, and the last is 1: the eleventh difference of the
/// sequence is zero.
const WEIGHTS: [f64; 5] = [11.0, -55.0, 165.0, -330.0, 462.0];

/// How many increments are extrapolated where steps are too long for all: differences of higher order are larger than these there.
pub(crate) const FEW: usize = 4;

/// (−1)ʲ (4 choose j).
const DIFFERENCE: [f64; FEW + 1] = [1.0, -4.0, 6.0, -4.0, 1.0];

/// How many terms are remembered, where they slide, before the last ones are moved to the end of memory.
const SPARE: usize = 9;

/// Extrapolates a smooth sequence by a polynomial through its last terms.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Predictor<A> {
    /// From `latest` on the last terms, the latest first.
    terms: [A; SPARE + POINTS],
    latest: usize,
    /// What the polynomial through few terms is expected to miss by.
    expected: A,
}

impl<A: Array> Predictor<A> {
    /// Whether terms stay where they are while the sequence goes on. Terms that fill whole registers are shifted by one place instead: then all
    /// addresses are known, which is 1.5 ns a step. Of others a register reaches over two, so that one is read just after both were written: the
    /// processor waits until they are in memory, 9 of the 35 ns of a step of Euler's top.
    const SLIDES: bool = A::LEN % 2 == 1 && ablation::RING;

    pub(crate) fn new() -> Self {
        Predictor { terms: [A::zero(); SPARE + POINTS], latest: 0, expected: A::zero() }
    }

    /// The terms, the latest first. What is expected is not recorded: it is computed before each step that has it.
    pub(crate) fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        let latest = self.latest;
        self.terms[latest..].iter_mut().take(POINTS).for_each(|term| tape.array(term));
    }

    /// The last terms, the latest first.
    #[inline(always)]
    fn last<const N: usize>(&self) -> &[A; N] {
        let latest = if Self::SLIDES { self.latest } else { 0 };
        self.terms[latest..].first_chunk().expect("no fewer than are extrapolated")
    }

    /// The next term: only one product and one sum wait for the latest one. Other terms of opposite weights are one product.
    #[inline(always)]
    pub(crate) fn predict(&self) -> A {
        if const { !ablation::ELEVEN_POINTS } {
            return self.extrapolate_few(A::zero());
        }
        let [latest, inner @ .., before, oldest] = self.last::<POINTS>();
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

    /// The next term by a polynomial through few terms, and by what that is expected to miss.
    pub(crate) fn predict_by_few(&self) -> A {
        self.extrapolate_few(self.expected)
    }

    /// The sum of `start` and the next term by a polynomial through few terms.
    #[inline(always)]
    fn extrapolate_few(&self, start: A) -> A {
        let mut sum = start;
        for (weight, term) in DIFFERENCE[1..].iter().zip(self.last::<FEW>()) {
            sum.add_scaled(A::Real::from_f64(-weight), term);
        }
        sum
    }

    /// What the polynomial through few terms has missed the latest term by.
    fn missed(&self) -> A {
        let mut sum = A::zero();
        for (weight, term) in DIFFERENCE.iter().zip(self.last::<{ FEW + 1 }>()) {
            sum.add_scaled(A::Real::from_f64(*weight), term);
        }
        sum
    }

    /// Expects these multiples of what the polynomials of other sequences have missed last.
    pub(crate) fn expect(&mut self, others: [(A::Real, &Self); 2]) {
        self.expected = A::zero();
        for (weight, other) in others {
            self.expected.add_scaled(weight, &other.missed());
        }
    }

    /// Expects nothing.
    #[inline(always)]
    pub(crate) fn expect_nothing(&mut self) {
        self.expected = A::zero();
    }

    /// The sequence goes on.
    #[inline(always)]
    pub(crate) fn push(&mut self, term: &A) {
        if !Self::SLIDES {
            for j in (1..POINTS).rev() {
                self.terms[j] = self.terms[j - 1];
            }
            self.terms[0] = *term;
            return;
        }
        if self.latest == 0 {
            self.terms.copy_within(..POINTS - 1, SPARE + 1);
            self.latest = SPARE + 1;
        }
        self.latest -= 1;
        self.terms[self.latest] = *term;
    }
}
