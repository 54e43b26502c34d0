//! Sums, products and quotients of intervals.

use super::super::Real;
use super::{Interval, extremes};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The product of two ends: zero times what is unbounded is zero.
fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

/// a + b rounded up or down, or as it is where nothing is rounded off.
fn sum(a: f64, b: f64, outwards: fn(f64) -> f64) -> f64 {
    let sum = a + b;
    let tail = sum - a;
    if (a - (sum - tail)) + (b - tail) == 0.0 { sum } else { outwards(sum) }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Interval { low: -self.high, high: -self.low }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(sum(self.low, other.low, f64::next_down), sum(self.high, other.high, f64::next_up))
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let [low, high] =
            extremes([product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)]);
        // Zero is exact, and so is what is multiplied by ±1.
        let exact = |x: f64| x == 0.0 && (a.contains(0.0) || b.contains(0.0));
        let unit = |x: Self| x.low == x.high && x.low.magnitude() == 1.0;
        if unit(a) || unit(b) {
            return Self::new(low, high);
        }
        let low = if exact(low) { low } else { low.next_down() };
        let high = if exact(high) { high } else { high.next_up() };
        Self::new(low, high)
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let Interval { low, high } = other;
        let recip = if low > 0.0 || high < 0.0 {
            Self::rounded(1.0 / high, 1.0 / low)
        } else if low == 0.0 && high > 0.0 {
            Self::new((1.0 / high).next_down(), f64::INFINITY)
        } else if high == 0.0 && low < 0.0 {
            Self::new(f64::NEG_INFINITY, (1.0 / low).next_up())
        } else {
            Self::WHOLE
        };
        // A reciprocal has the sign of its number.
        self * if low >= 0.0 && high > 0.0 {
            recip.within(0.0, f64::INFINITY)
        } else if high <= 0.0 && low < 0.0 {
            recip.within(f64::NEG_INFINITY, 0.0)
        } else {
            recip
        }
    }
}
