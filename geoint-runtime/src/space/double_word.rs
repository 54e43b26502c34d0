//! Numbers of two words, for sums of time. The second word holds the rounding error of the first one.

use super::record::{Record, Tape};
use crate::scalar::{Real, exact_sum, halves, zero};

/// The number of bits of each part of an integer in an exact product: 11 bits times half of the digits of an `f32`, 12 bits, fit into its 24 bits. A scalar
/// therefore needs at least 24 bits.
const BITS: u32 = 11;

/// The number high + low, with twice the digits of the scalar. Invariant: |low| is at most half a unit in the last place of high.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleWord<R> {
    high: R,
    low: R,
}

impl<R: Real> DoubleWord<R> {
    /// Returns the number x.
    #[inline(always)]
    pub fn new(x: R) -> Self {
        DoubleWord { high: x, low: zero() }
    }

    /// Returns the nearest number of one word.
    #[inline(always)]
    pub fn value(&self) -> R {
        self.high
    }

    /// Returns both words.
    #[inline(always)]
    pub(crate) fn words(&self) -> [R; 2] {
        [self.high, self.low]
    }

    /// Returns both words, to restore them. The caller keeps the invariant.
    #[inline(always)]
    pub(crate) fn words_mut(&mut self) -> [&mut R; 2] {
        [&mut self.high, &mut self.low]
    }

    /// Adds a number. The error is about ε² times the sum. Limit: the sum with an infinite number is NaN.
    #[inline(always)]
    pub fn add(&mut self, x: R) {
        let (sum, error) = exact_sum(self.high, x);
        (self.high, self.low) = exact_sum(sum, self.low + error);
    }

    /// Adds both words of a number.
    #[inline(always)]
    pub(crate) fn add_both(&mut self, x: Self) {
        self.add(x.low);
        self.add(x.high);
    }

    /// Adds n·h as exact products: n in parts of [`BITS`] bits, times each half of the digits of h. The error of each addition is about ε² times the sum.
    pub(crate) fn add_multiple(&mut self, mut n: u64, h: R) {
        let (upper, lower) = halves(h);
        let mut unit = 1.0;
        while n > 0 {
            let part = R::from_f64((n & ((1 << BITS) - 1)) as f64 * unit);
            self.add(part * upper);
            self.add(part * lower);
            (n, unit) = (n >> BITS, unit * f64::from(1 << BITS));
        }
    }
}

impl<R: Real> Record<R> for DoubleWord<R> {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.words_mut().into_iter().for_each(|word| tape.scalar(word));
    }
}
