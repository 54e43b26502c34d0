//! Constants: exact ratios as long as they are small, floating point otherwise.
//!
//! `9.81`, `1.0 / 3.0` and exponents stay exact while the graph is simplified and are rounded once, when they are
//! emitted.

use std::cmp::Ordering;

/// A ratio in lowest terms with positive denominator, both parts exact in `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Ratio {
    pub(crate) numerator: i64,
    pub(crate) denominator: i64,
}

/// Integers up to here are exact in `f64`, so that numerator/denominator is rounded once.
const EXACT: i128 = 1 << 53;

impl Ratio {
    pub(crate) const ZERO: Ratio = Ratio::integer(0);
    pub(crate) const ONE: Ratio = Ratio::integer(1);
    pub(crate) const HALF: Ratio = Ratio { numerator: 1, denominator: 2 };

    pub(crate) const fn integer(n: i64) -> Ratio {
        Ratio { numerator: n, denominator: 1 }
    }

    /// `None` if a part is not exact in `f64`, or the denominator is zero.
    pub(crate) fn new(numerator: i128, denominator: i128) -> Option<Ratio> {
        if denominator == 0 {
            return None;
        }
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs()).max(1) as i128;
        let sign = denominator.signum();
        let (n, d) = (sign * numerator / divisor, sign * denominator / divisor);
        (n.abs() <= EXACT && d <= EXACT).then_some(Ratio { numerator: n as i64, denominator: d as i64 })
    }

    pub(crate) fn add(self, other: Ratio) -> Option<Ratio> {
        let (a, b) = (i128::from(self.numerator), i128::from(self.denominator));
        let (c, d) = (i128::from(other.numerator), i128::from(other.denominator));
        Ratio::new(a * d + c * b, b * d)
    }

    pub(crate) fn mul(self, other: Ratio) -> Option<Ratio> {
        let (a, b) = (i128::from(self.numerator), i128::from(self.denominator));
        let (c, d) = (i128::from(other.numerator), i128::from(other.denominator));
        Ratio::new(a * c, b * d)
    }

    /// `None` for zero.
    pub(crate) fn recip(self) -> Option<Ratio> {
        Ratio::new(self.denominator.into(), self.numerator.into())
    }

    pub(crate) fn is_integer(self) -> bool {
        self.denominator == 1
    }

    pub(crate) fn to_f64(self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }
}

fn gcd(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// A constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Number {
    Exact(Ratio),
    /// The bits of an `f64`, so that constants can be hashed.
    Float(u64),
}

impl Number {
    pub(crate) const ZERO: Number = Number::integer(0);
    pub(crate) const ONE: Number = Number::integer(1);
    pub(crate) const MINUS_ONE: Number = Number::integer(-1);
    pub(crate) const HALF: Number = Number::Exact(Ratio::HALF);

    pub(crate) const fn integer(n: i64) -> Number {
        Number::Exact(Ratio::integer(n))
    }

    pub(crate) fn float(x: f64) -> Number {
        if x.fract() == 0.0 && x.abs() <= EXACT as f64 { Number::integer(x as i64) } else { Number::Float(x.to_bits()) }
    }

    /// A decimal literal, exact if it is short: `9.81` is 981/100.
    pub(crate) fn decimal(text: &str) -> Option<Number> {
        let value: f64 = text.parse().ok()?;
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let power = exponent.parse::<i32>().ok()?.checked_sub(i32::try_from(fraction.len()).ok()?)?;
        let exact = || {
            let digits: i128 = format!("{whole}{fraction}").parse().ok()?;
            let scale = 10_i128.checked_pow(power.unsigned_abs())?;
            if power < 0 { Ratio::new(digits, scale) } else { Ratio::new(digits.checked_mul(scale)?, 1) }
        };
        Some(exact().map_or(Number::float(value), Number::Exact))
    }

    pub(crate) fn to_f64(self) -> f64 {
        match self {
            Number::Exact(ratio) => ratio.to_f64(),
            Number::Float(bits) => f64::from_bits(bits),
        }
    }

    pub(crate) fn is_zero(self) -> bool {
        self.to_f64() == 0.0
    }

    pub(crate) fn is_negative(self) -> bool {
        self.to_f64() < 0.0
    }

    pub(crate) fn neg(self) -> Number {
        self.mul(Number::MINUS_ONE)
    }

    pub(crate) fn add(self, other: Number) -> Number {
        match (self, other) {
            (Number::ZERO, sum) | (sum, Number::ZERO) => return sum,
            (Number::Exact(a), Number::Exact(b)) => a.add(b).map(Number::Exact),
            _ => None,
        }
        .unwrap_or_else(|| Number::float(self.to_f64() + other.to_f64()))
    }

    pub(crate) fn mul(self, other: Number) -> Number {
        match (self, other) {
            (Number::ONE, product) | (product, Number::ONE) => return product,
            (Number::Exact(a), Number::Exact(b)) => a.mul(b).map(Number::Exact),
            _ => None,
        }
        .unwrap_or_else(|| Number::float(self.to_f64() * other.to_f64()))
    }

    /// The power, if it is a finite real number.
    pub(crate) fn pow(self, exponent: Ratio) -> Option<Number> {
        let exact = || {
            let Number::Exact(base) = self else { return None };
            let n = exponent.is_integer().then(|| u32::try_from(exponent.numerator.unsigned_abs()).ok())??;
            let power = |x: i64| i128::from(x).checked_pow(n);
            let (a, b) = (power(base.numerator)?, power(base.denominator)?);
            if exponent.numerator < 0 { Ratio::new(b, a) } else { Ratio::new(a, b) }
        };
        let inexact = || {
            let x = match exponent {
                Ratio { numerator: 1, denominator: 2 } => self.to_f64().sqrt(),
                _ => self.to_f64().powf(exponent.to_f64()),
            };
            x.is_finite().then(|| Number::float(x))
        };
        exact().map(Number::Exact).or_else(inexact)
    }

    pub(crate) fn compare(self, other: Number) -> Option<Ordering> {
        self.to_f64().partial_cmp(&other.to_f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact_while_short() {
        assert_eq!(Number::decimal("9.81"), Ratio::new(981, 100).map(Number::Exact));
        assert_eq!(Number::decimal("1e3"), Some(Number::integer(1000)));
        assert_eq!(Number::decimal("6.67430e-11"), Ratio::new(66743, 10_i128.pow(15)).map(Number::Exact));
        let long = "0.12345678901234567890123";
        assert_eq!(Number::decimal(long), Some(Number::float(long.parse().unwrap())));
        assert_eq!(Number::decimal("1e400").map(Number::to_f64), Some(f64::INFINITY));
    }

    #[test]
    fn thirds_cancel() {
        let third = Number::integer(3).pow(Ratio::integer(-1)).unwrap();
        assert_eq!(third.mul(Number::integer(3)), Number::ONE);
        assert_eq!(third.add(third).add(third), Number::ONE);
    }

    #[test]
    fn powers_that_are_not_real_numbers_are_refused() {
        assert_eq!(Number::integer(-2).pow(Ratio::HALF), None);
        assert_eq!(Number::ZERO.pow(Ratio::integer(-1)), None);
    }

    #[test]
    fn overflow_falls_back_to_floating_point() {
        let big = Number::integer(1 << 40);
        assert_eq!(big.mul(big).to_f64(), 2.0_f64.powi(80));
    }
}
