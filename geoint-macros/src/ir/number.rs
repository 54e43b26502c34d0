//! Constants: exact ratios unless they are very long, floating point otherwise.
//!
//! `9.81`, `1.0 / 3.0`, `6.674e-11`, the `f64` nearest to π and exponents stay exact while the graph is simplified and are rounded
//! once, when they are emitted.

use super::ratio::Ratio;
use std::cmp::Ordering;

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

    pub(crate) const fn integer(n: i128) -> Number {
        Number::Exact(Ratio::integer(n))
    }

    pub(crate) fn float(x: f64) -> Number {
        if x == 0.0 {
            return Number::ZERO;
        }
        Ratio::of_f64(x).map_or(Number::Float(x.to_bits()), Number::Exact)
    }

    /// A decimal literal, exact unless it is very long: `9.81` is 981/100.
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
            let power = |x: i128| x.checked_pow(n);
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
        assert_eq!(Number::decimal("1.380649e-23"), Ratio::new(1_380_649, 10_i128.pow(29)).map(Number::Exact));
        let long = "0.12345678901234567890123456789012345678901";
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
        let big = Number::float(2.0_f64.powi(80) + 2.0_f64.powi(30));
        assert!(matches!(big.mul(big), Number::Float(_)));
        assert_eq!(big.mul(big).to_f64(), big.to_f64() * big.to_f64());
    }

    #[test]
    fn numbers_of_the_machine_are_exact_and_come_back() {
        for x in [std::f64::consts::PI, -0.1, 1e-20, 3e30, 2.0_f64.powi(-70) * 3.0, 1.5e300, 5e-324, f64::INFINITY] {
            assert_eq!(Number::float(x).to_f64(), x);
        }
        assert!(matches!(Number::float(std::f64::consts::PI), Number::Exact(_)));
    }

    #[test]
    fn long_ratios_are_rounded_once_to_the_nearest_even() {
        let one = 1_i128 << 60;
        for (numerator, rounded) in [
            (one + 128, 2.0_f64.powi(60)),
            (one + 129, 2.0_f64.powi(60) + 256.0),
            (one + 384, 2.0_f64.powi(60) + 512.0),
            (-one - 129, -(2.0_f64.powi(60) + 256.0)),
        ] {
            assert_eq!(Ratio::new(numerator, 1).unwrap().to_f64(), rounded);
            let scaled = Ratio::new(numerator, 3 * one).unwrap().to_f64();
            assert!((scaled * 3.0 * one as f64 / numerator as f64 - 1.0).abs() < 4e-16);
        }
        let tenth = Ratio::new(10_i128.pow(30), 10_i128.pow(31) + 1).unwrap();
        assert_eq!(tenth.to_f64(), 0.1);
        for text in
            ["1.380649e-23", "6.62607015e-34", "1.602176634e-19", "0.1234567890123456789", "299792458.123456789"]
        {
            assert_eq!(Number::decimal(text).unwrap().to_f64(), text.parse::<f64>().unwrap(), "{text}");
        }
    }
}
