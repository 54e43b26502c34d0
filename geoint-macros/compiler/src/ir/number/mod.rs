//! Constants: exact ratios unless they are very long, floating point otherwise.
//!
//! `9.81`, `1.0 / 3.0`, `6.674e-11`, the `f64` nearest to π, square roots of ratios and exponents stay exact while the graph is
//! simplified and are rounded once, when they are emitted.

mod ratio;

pub(crate) use ratio::Ratio;
use std::cmp::Ordering;
use std::hash::{Hash, Hasher};

/// A constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Number {
    Exact(Ratio),
    /// c·√r with an integer r > 1 that is no multiple of a small square.
    Root(Ratio, i64),
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
            // Rounded under the root, which halves what that changes.
            Number::Root(c, r) => match c.mul(c).and_then(|square| square.mul(Ratio::integer(r.into()))) {
                Some(square) if c < Ratio::ZERO => -square.to_f64().sqrt(),
                Some(square) => square.to_f64().sqrt(),
                None => c.to_f64() * (r as f64).sqrt(),
            },
            Number::Float(bits) => f64::from_bits(bits),
        }
    }

    #[inline(always)]
    pub(crate) fn is_zero(self) -> bool {
        matches!(self, Number::Exact(ratio) if ratio.numerator == 0)
    }

    #[inline(always)]
    pub(crate) fn is_one(self) -> bool {
        matches!(self, Number::Exact(ratio) if ratio.numerator == 1 && ratio.denominator == 1)
    }

    pub(crate) fn is_negative(self) -> bool {
        match self {
            Number::Exact(ratio) | Number::Root(ratio, _) => ratio.numerator < 0,
            Number::Float(bits) => f64::from_bits(bits) < 0.0,
        }
    }

    /// Whether this was rounded while the graph was built: decimals have other denominators.
    pub(crate) fn is_rounded(self) -> bool {
        match self {
            Number::Float(_) => true,
            Number::Root(..) => false,
            Number::Exact(ratio) => ratio.denominator.count_ones() == 1 && ratio.denominator >= 1 << 30,
        }
    }

    pub(crate) fn neg(self) -> Number {
        match self {
            Number::Exact(ratio) => Number::Exact(ratio.neg()),
            Number::Root(ratio, radicand) => Number::Root(ratio.neg(), radicand),
            Number::Float(_) => Number::float(-self.to_f64()),
        }
    }

    pub(crate) fn add(self, other: Number) -> Number {
        match (self, other) {
            (Number::ZERO, sum) | (sum, Number::ZERO) => return sum,
            (Number::Exact(a), Number::Exact(b)) => a.add(b).map(Number::Exact),
            (Number::Root(a, r), Number::Root(b, s)) if r == s => a.add(b).map(|sum| Number::root(sum, r)),
            (Number::Root(c, r), Number::Exact(q)) | (Number::Exact(q), Number::Root(c, r)) => {
                root_and_ratio((c, r), q)
            }
            _ => None,
        }
        .unwrap_or_else(|| Number::float(self.to_f64() + other.to_f64()))
    }

    pub(crate) fn mul(self, other: Number) -> Number {
        if self.is_one() {
            return other;
        }
        match (self, other) {
            (product, Number::ONE) => return product,
            (Number::Exact(a), Number::Exact(b)) => a.mul(b).map(Number::Exact),
            (Number::Exact(a), Number::Root(b, r)) | (Number::Root(b, r), Number::Exact(a)) => {
                a.mul(b).map(|c| Number::root(c, r))
            }
            (Number::Root(a, r), Number::Root(b, s)) => product_of_roots((a, r), (b, s)),
            _ => None,
        }
        .unwrap_or_else(|| Number::float(self.to_f64() * other.to_f64()))
    }

    /// The power, if it is a finite real number.
    pub(crate) fn pow(self, exponent: Ratio) -> Option<Number> {
        let exact = || {
            let base = match self {
                Number::Exact(base) if exponent.denominator == 2 => {
                    let whole = Number::Exact(base).pow(Ratio::integer(exponent.numerator))?;
                    return whole.square_root();
                }
                Number::Exact(base) => base,
                Number::Root(..) if exponent.is_integer() && exponent.numerator.abs() <= 64 => {
                    let power = (0..exponent.numerator.abs()).fold(Number::ONE, |power, _| power.mul(self));
                    return if exponent.numerator < 0 { power.reciprocal() } else { Some(power) };
                }
                _ => return None,
            };
            let n = exponent.is_integer().then(|| u32::try_from(exponent.numerator.unsigned_abs()).ok())??;
            let power = |x: i128| x.checked_pow(n);
            let (a, b) = (power(base.numerator)?, power(base.denominator)?);
            if exponent.numerator < 0 { Ratio::new(b, a) } else { Ratio::new(a, b) }.map(Number::Exact)
        };
        let inexact = || {
            let x = match exponent {
                Ratio { numerator: 1, denominator: 2 } => self.to_f64().sqrt(),
                _ => self.to_f64().powf(exponent.to_f64()),
            };
            x.is_finite().then(|| Number::float(x))
        };
        exact().or_else(inexact)
    }

    /// c·√r, where r is no multiple of a small square.
    fn root(c: Ratio, r: i64) -> Number {
        match r {
            _ if c == Ratio::ZERO => Number::ZERO,
            1 => Number::Exact(c),
            _ => Number::Root(c, r),
        }
    }

    /// √(a/b) = √(ab)/b.
    fn square_root(self) -> Option<Number> {
        let Number::Exact(Ratio { numerator, denominator }) = self else { return None };
        let mut rest = i64::try_from(numerator.checked_mul(denominator)?).ok().filter(|product| *product >= 0)?;
        if rest == 0 {
            return Some(Number::ZERO);
        }
        let whole = (rest as f64).sqrt().round() as i64;
        if whole.checked_mul(whole) == Some(rest) {
            return Ratio::new(whole.into(), denominator).map(Number::Exact);
        }
        let mut outside = 1_i64;
        for p in 2..=SMALL {
            while rest % (p * p) == 0 {
                (rest, outside) = (rest / (p * p), outside * p);
            }
        }
        Ratio::new(outside.into(), denominator).map(|c| Number::root(c, rest))
    }

    fn reciprocal(self) -> Option<Number> {
        match self {
            Number::Exact(ratio) => ratio.recip().map(Number::Exact),
            // 1/(c√r) = √r/(cr).
            Number::Root(c, r) => Some(Number::root(c.mul(Ratio::integer(r.into()))?.recip()?, r)),
            Number::Float(_) => None,
        }
    }

    /// Equal for equal numbers, and seldom for others.
    pub(crate) fn word(self) -> u64 {
        match self {
            Number::Exact(ratio) => ratio.word(),
            Number::Root(ratio, radicand) => ratio.word() ^ (radicand as u64) << 8,
            Number::Float(bits) => bits,
        }
    }

    pub(crate) fn compare(self, other: Number) -> Option<Ordering> {
        self.to_f64().partial_cmp(&other.to_f64())
    }
}

/// c√r + q = (c²r − q²)/(c√r − q) where they nearly cancel: never zero.
fn root_and_ratio((c, r): (Ratio, i64), q: Ratio) -> Option<Number> {
    if (c < Ratio::ZERO) == (q < Ratio::ZERO) {
        return None;
    }
    let squares = c.mul(c)?.mul(Ratio::integer(r.into()))?.add(q.mul(q)?.neg())?;
    Some(Number::float(squares.to_f64() / (Number::Root(c, r).to_f64() - q.to_f64())))
}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.word());
    }
}

/// The squares of larger numbers are not looked for in radicands.
const SMALL: i64 = 1000;

/// a√r·b√s.
fn product_of_roots((a, r): (Ratio, i64), (b, s): (Ratio, i64)) -> Option<Number> {
    let common = gcd(r, s);
    let radicand = (r / common).checked_mul(s / common)?;
    Some(Number::root(a.mul(b)?.mul(Ratio::integer(common.into()))?, radicand))
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The prime factors of a radicand: small ones, and what is left.
pub(crate) fn factors_of_radicand(mut r: i64) -> Vec<i64> {
    let mut factors = vec![];
    for p in 2..=SMALL {
        if r % p == 0 {
            factors.push(p);
            r /= p;
        }
    }
    factors.extend((r > 1).then_some(r));
    factors
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn square_roots_are_exact() {
        let root = |n: i128| Number::integer(n).pow(Ratio::HALF).unwrap();
        assert_eq!(root(3).mul(root(3)), Number::integer(3));
        assert_eq!(root(12), root(3).mul(Number::integer(2)));
        assert_eq!(root(2).mul(root(3)), root(6));
        assert_eq!(root(6).mul(root(2)), root(3).mul(Number::integer(2)));
        assert_eq!(root(144), Number::integer(12));
        assert_eq!(root(3).add(root(3).neg()), Number::ZERO);
        assert_eq!(root(3).pow(Ratio::integer(-2)), Ratio::new(1, 3).map(Number::Exact));
        assert_eq!(root(3).pow(Ratio::integer(-1)).unwrap().mul(root(3)), Number::ONE);
        // √9.81 = 3√109/10.
        let decimal = Number::decimal("9.81").unwrap().pow(Ratio::HALF).unwrap();
        assert_eq!(decimal.mul(decimal), Number::decimal("9.81").unwrap());
        for n in [2.0_f64, 3.0, 0.3, 9.81, 7e-5, 1e9 + 7.0] {
            let number = Number::decimal(&n.to_string()).unwrap();
            assert_eq!(number.pow(Ratio::HALF).unwrap().to_f64(), n.sqrt(), "{n}");
        }
        assert_eq!(Number::integer(-3).pow(Ratio::HALF), None);
        assert_eq!(
            Number::integer(2).pow(Ratio { numerator: 3, denominator: 2 }),
            Some(root(2).mul(Number::integer(2)))
        );
    }

    /// √2 is 1.41421356237309504880168872420969807857….
    #[test]
    fn no_root_is_a_ratio() {
        let root = Number::integer(2).pow(Ratio::HALF).unwrap();
        for (decimal, rest) in
            [("1.4142135623730951", -5.1198311275790302e-17), ("1.41421356237309504", 8.801688724209698e-18)]
        {
            let decimal = Number::decimal(decimal).unwrap();
            for difference in [root.add(decimal.neg()), decimal.neg().add(root), decimal.add(root.neg()).neg()] {
                assert!((difference.to_f64() / rest - 1.0).abs() < 1e-15, "{difference:?}");
            }
        }
        assert_eq!(root.add(Number::ONE).to_f64(), 1.0 + std::f64::consts::SQRT_2);
    }

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
