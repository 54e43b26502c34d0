//! Sums, products and quotients of intervals.

use super::super::Real;
use super::{Interval, extremes};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Returns the product of two ends. Zero times an infinite end is zero.
fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

/// Returns a + b, rounded by `outwards` unless the sum is exact.
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
        // Products with zero or ±1 are exact.
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
        // The reciprocal has the sign of the divisor, also after outward rounding.
        self * if low >= 0.0 && high > 0.0 {
            recip.within(0.0, f64::INFINITY)
        } else if high <= 0.0 && low < 0.0 {
            recip.within(f64::NEG_INFINITY, 0.0)
        } else {
            recip
        }
    }
}
