//! Constants: exact ratios and square roots, or floating point if the exact value is very long.
//!
//! `9.81`, `1.0 / 3.0`, `6.674e-11`, the `f64` nearest to π, square roots of ratios and exponents stay exact while the graph is simplified. They are
//! rounded once, when they are emitted.

mod ratio;
#[cfg(test)]
mod tests;

pub(crate) use ratio::Ratio;
use std::hash::{Hash, Hasher};

/// A constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Number {
    Exact(Ratio),
    /// c·√r for an integer r > 1 without small square factors.
    Root(Ratio, i64),
    /// The bits of an `f64`, which can be hashed.
    Float(u64),
}

impl Number {
    pub(crate) const ZERO: Number = Number::integer(0);
    pub(crate) const ONE: Number = Number::integer(1);
    pub(crate) const MINUS_ONE: Number = Number::integer(-1);
    pub(crate) const HALF: Number = Number::Exact(Ratio::HALF);

    /// Returns an integer.
    pub(crate) const fn integer(n: i128) -> Number {
        Number::Exact(Ratio::integer(n))
    }

    /// Returns the value of an `f64`, exact if its parts are not too long.
    pub(crate) fn float(x: f64) -> Number {
        if x == 0.0 {
            return Number::ZERO;
        }
        Ratio::of_f64(x).map_or(Number::Float(x.to_bits()), Number::Exact)
    }

    /// Parses a decimal literal, exactly unless it is very long: `9.81` is 981/100.
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

    /// Returns the value rounded to `f64`.
    pub(crate) fn to_f64(self) -> f64 {
        match self {
            Number::Exact(ratio) => ratio.to_f64(),
            // The first rounding is under the root, which halves its relative error.
            Number::Root(c, r) => match c.mul(c).and_then(|square| square.mul(Ratio::integer(r.into()))) {
                Some(square) if c < Ratio::ZERO => -square.to_f64().sqrt(),
                Some(square) => square.to_f64().sqrt(),
                None => c.to_f64() * (r as f64).sqrt(),
            },
            Number::Float(bits) => f64::from_bits(bits),
        }
    }

    /// Returns whether this is 0.
    #[inline(always)]
    pub(crate) fn is_zero(self) -> bool {
        matches!(self, Number::Exact(ratio) if ratio.numerator == 0)
    }

    /// Returns whether this is 1.
    #[inline(always)]
    pub(crate) fn is_one(self) -> bool {
        matches!(self, Number::Exact(ratio) if ratio.numerator == 1 && ratio.denominator == 1)
    }

    /// Returns whether this is below 0.
    pub(crate) fn is_negative(self) -> bool {
        match self {
            Number::Exact(ratio) | Number::Root(ratio, _) => ratio.numerator < 0,
            Number::Float(bits) => f64::from_bits(bits) < 0.0,
        }
    }

    /// Returns whether this is the result of a rounded operation. Short decimals have other denominators than large powers of two.
    pub(crate) fn is_rounded(self) -> bool {
        match self {
            Number::Float(_) => true,
            Number::Root(..) => false,
            Number::Exact(ratio) => ratio.denominator.count_ones() == 1 && ratio.denominator >= 1 << 30,
        }
    }

    /// Returns the negative.
    pub(crate) fn neg(self) -> Number {
        match self {
            Number::Exact(ratio) => Number::Exact(ratio.neg()),
            Number::Root(ratio, radicand) => Number::Root(ratio.neg(), radicand),
            Number::Float(_) => Number::float(-self.to_f64()),
        }
    }

    /// Returns the sum, exact if possible.
    pub(crate) fn add(self, other: Number) -> Number {
        match (self, other) {
            (Number::ZERO, sum) | (sum, Number::ZERO) => return sum,
            (Number::Exact(a), Number::Exact(b)) => a.add(b).map(Number::Exact),
            (Number::Root(a, r), Number::Root(b, s)) if r == s => a.add(b).map(|sum| Number::root(sum, r)),
            (Number::Root(c, r), Number::Exact(q)) | (Number::Exact(q), Number::Root(c, r)) => root_plus_ratio(c, r, q),
            _ => None,
        }
        .unwrap_or_else(|| Number::float(self.to_f64() + other.to_f64()))
    }

    /// Returns the product, exact if possible.
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
            (Number::Root(a, r), Number::Root(b, s)) => a.mul(b).and_then(|c| product_of_roots(c, r, s)),
            _ => None,
        }
        .unwrap_or_else(|| Number::float(self.to_f64() * other.to_f64()))
    }

    /// Returns the power, if it is a finite real number.
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

    /// Returns c·√r in normal form. Precondition: r has no small square factors.
    fn root(c: Ratio, r: i64) -> Number {
        match r {
            _ if c == Ratio::ZERO => Number::ZERO,
            1 => Number::Exact(c),
            _ => Number::Root(c, r),
        }
    }

    /// Returns the exact square root of a ratio: √(a/b) = √(ab)/b.
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

    /// Returns the exact reciprocal.
    fn reciprocal(self) -> Option<Number> {
        match self {
            Number::Exact(ratio) => ratio.recip().map(Number::Exact),
            // 1/(c√r) = √r/(cr).
            Number::Root(c, r) => Some(Number::root(c.mul(Ratio::integer(r.into()))?.recip()?, r)),
            Number::Float(_) => None,
        }
    }

    /// Returns a hash that is equal for equal numbers.
    pub(crate) fn hash_word(self) -> u64 {
        match self {
            Number::Exact(ratio) => ratio.hash_word(),
            Number::Root(ratio, radicand) => ratio.hash_word() ^ (radicand as u64) << 8,
            Number::Float(bits) => bits,
        }
    }
}

/// Returns c√r + q = (c²r − q²)/(c√r − q) for opposite signs of c and q. The terms may nearly cancel, but the sum is never zero.
fn root_plus_ratio(c: Ratio, r: i64, q: Ratio) -> Option<Number> {
    if (c < Ratio::ZERO) == (q < Ratio::ZERO) {
        return None;
    }
    let squares = c.mul(c)?.mul(Ratio::integer(r.into()))?.add(q.mul(q)?.neg())?;
    Some(Number::float(squares.to_f64() / (Number::Root(c, r).to_f64() - q.to_f64())))
}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.hash_word());
    }
}

/// The largest number whose square is divided out of radicands.
const SMALL: i64 = 1000;

/// Returns c·√r·√s.
fn product_of_roots(c: Ratio, r: i64, s: i64) -> Option<Number> {
    let common = gcd(r, s);
    let radicand = (r / common).checked_mul(s / common)?;
    Some(Number::root(c.mul(Ratio::integer(common.into()))?, radicand))
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Returns the factors of a radicand: its small primes and the remaining cofactor.
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
