//! Ratios of integers in lowest terms, with checked arithmetic. Constants of an energy stay exact in derivatives and proofs.

use std::cmp::Ordering;

/// A ratio of two integers. Invariants: lowest terms, a positive denominator, and no part above [`LARGEST`]. All constructors and operations keep
/// them, but `integer` trusts its caller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Ratio {
    pub(crate) numerator: i128,
    pub(crate) denominator: i128,
}

/// The largest numerator and denominator. A decimal such as 1.380649e-23 is exact, and so is the square of any `f64` near one. The limit is below `i128::MAX`, so
/// `neg` cannot overflow. All other operations are checked.
const LARGEST: u128 = 1 << 126;

/// Integers up to this size are exact in `f64`.
const EXACT_IN_F64: i128 = 1 << 53;

impl Ratio {
    pub(crate) const ZERO: Ratio = Ratio::integer(0);
    pub(crate) const ONE: Ratio = Ratio::integer(1);
    pub(crate) const HALF: Ratio = Ratio { numerator: 1, denominator: 2 };

    /// Returns an integer. Precondition: its size is at most [`LARGEST`]; a constant function cannot return an error here.
    pub(crate) const fn integer(n: i128) -> Ratio {
        Ratio { numerator: n, denominator: 1 }
    }

    /// Returns the ratio. `None` if a part is too large or the denominator is zero.
    pub(crate) fn new(numerator: i128, denominator: i128) -> Option<Ratio> {
        if denominator == 0 {
            return None;
        }
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs());
        let (n, d) = (numerator.unsigned_abs() / divisor, denominator.unsigned_abs() / divisor);
        let sign = if (numerator < 0) == (denominator < 0) { 1 } else { -1 };
        (n <= LARGEST && d <= LARGEST).then_some(Ratio { numerator: sign * n as i128, denominator: d as i128 })
    }

    /// Returns an integer of checked size. `None` if it is too large.
    fn checked_integer(n: i128) -> Option<Ratio> {
        (n.unsigned_abs() <= LARGEST).then_some(Ratio::integer(n))
    }

    /// Returns the exact value of a normal `f64`. `None` if a part is too large, and for zero, subnormal numbers, infinities and NaN, which the caller handles.
    pub(super) fn of_f64(x: f64) -> Option<Ratio> {
        let bits = x.to_bits();
        let (biased, mantissa) = ((bits >> 52 & 0x7ff) as i32, i128::from(bits & ((1 << 52) - 1)));
        let mantissa = (1..0x7ff).contains(&biased).then_some(mantissa | 1 << 52)?;
        let zeros = mantissa.trailing_zeros();
        // x = mantissa · 2^(biased − 1023 − 52).
        let (mantissa, exponent) = (mantissa >> zeros, biased - 1075 + zeros as i32);
        let signed = if x < 0.0 { -mantissa } else { mantissa };
        // 1 << 127 is negative.
        let power = 1_i128.checked_shl(exponent.unsigned_abs()).filter(|power| *power > 0)?;
        if exponent < 0 { Ratio::new(signed, power) } else { Ratio::new(signed.checked_mul(power)?, 1) }
    }

    /// Returns the sum. `None` if a part or an intermediate product is too large.
    pub(crate) fn add(self, other: Ratio) -> Option<Ratio> {
        // Fast path: most ratios are integers.
        if self.is_integer() && other.is_integer() {
            return Ratio::checked_integer(self.numerator.checked_add(other.numerator)?);
        }
        let common = gcd(self.denominator.unsigned_abs(), other.denominator.unsigned_abs()) as i128;
        let (b, d) = (self.denominator / common, other.denominator / common);
        let sum = self.numerator.checked_mul(d)?.checked_add(other.numerator.checked_mul(b)?)?;
        Ratio::new(sum, self.denominator.checked_mul(d)?)
    }

    /// Returns the product. Common factors are cancelled first. `None` if a part is too large.
    pub(crate) fn mul(self, other: Ratio) -> Option<Ratio> {
        if self.is_integer() && other.is_integer() {
            return Ratio::checked_integer(self.numerator.checked_mul(other.numerator)?);
        }
        let cancelled = |n: i128, d: i128| {
            let common = gcd(n.unsigned_abs(), d.unsigned_abs()) as i128;
            (n / common, d / common)
        };
        let ((a, d), (c, b)) =
            (cancelled(self.numerator, other.denominator), cancelled(other.numerator, self.denominator));
        Ratio::new(a.checked_mul(c)?, b.checked_mul(d)?)
    }

    /// Returns the reciprocal. `None` for zero.
    pub(crate) fn recip(self) -> Option<Ratio> {
        Ratio::new(self.denominator, self.numerator)
    }

    /// Returns a hash that is equal for equal ratios, made of the low bits of both parts. The graph hashes millions of numbers, and `Hash` is slower.
    #[inline(always)]
    pub(crate) fn hash_word(self) -> u64 {
        self.numerator as u64 ^ (self.denominator as u64) << 32
    }

    /// Returns the negative.
    pub(crate) fn neg(self) -> Ratio {
        Ratio { numerator: -self.numerator, ..self }
    }

    /// Returns whether the denominator is 1.
    pub(crate) fn is_integer(self) -> bool {
        self.denominator == 1
    }

    /// Returns the largest integer that is not above the ratio.
    pub(crate) fn floor(self) -> i128 {
        self.numerator.div_euclid(self.denominator)
    }

    /// Returns the ratio as an `i64`, if it is an integer of this size.
    pub(crate) fn to_i64(self) -> Option<i64> {
        i64::try_from(self.numerator).ok().filter(|_| self.is_integer())
    }

    /// Returns whether both parts are at most 2⁵³. They are then exact in `f64`, and their quotient is rounded once.
    pub(crate) fn fits_f64(self) -> bool {
        self.numerator.abs() <= EXACT_IN_F64 && self.denominator <= EXACT_IN_F64
    }

    /// Returns the nearest `f64`.
    pub(crate) fn to_f64(self) -> f64 {
        // Fast path: most numerators and denominators fit into 32 bits.
        let (n, d) = (self.numerator as i32, self.denominator as i32);
        if i128::from(n) == self.numerator && i128::from(d) == self.denominator {
            return f64::from(n) / f64::from(d);
        }
        if self.fits_f64() {
            return self.numerator as f64 / self.denominator as f64;
        }
        // Long division to at least 55 bits. A remainder sets the last bit, which lies below the rounding bit, so there is no false tie.
        let (n, d) = (self.numerator.unsigned_abs(), self.denominator.unsigned_abs());
        let (mut quotient, mut rest, mut shift) = (n / d, n % d, 0_i32);
        while quotient < 1 << 54 {
            rest <<= 1;
            quotient = quotient << 1 | u128::from(rest >= d);
            rest = if rest >= d { rest - d } else { rest };
            shift += 1;
        }
        // The factor is an exact power of two: the shift is at most 180.
        let magnitude = (quotient | u128::from(rest > 0)) as f64 * 2.0_f64.powi(-shift);
        if self.numerator < 0 { -magnitude } else { magnitude }
    }
}

impl Ord for Ratio {
    fn cmp(&self, other: &Ratio) -> Ordering {
        if self.denominator == other.denominator {
            return self.numerator.cmp(&other.numerator);
        }
        // Compare whole parts first, then the reciprocals of the remainders, and so on, as in Euclid's algorithm. Products of long parts would overflow.
        let rest = |x: &Ratio| Ratio { numerator: x.numerator.rem_euclid(x.denominator), ..*x };
        let (a, b) = (rest(self), rest(other));
        self.floor().cmp(&other.floor()).then_with(|| match (a.recip(), b.recip()) {
            (Some(a), Some(b)) => b.cmp(&a),
            _ => a.numerator.cmp(&b.numerator),
        })
    }
}

impl PartialOrd for Ratio {
    fn partial_cmp(&self, other: &Ratio) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Returns the greatest common divisor. Most numbers are short, and division of `u64` is much faster.
fn gcd(a: u128, b: u128) -> u128 {
    match (u64::try_from(a), u64::try_from(b)) {
        (Ok(mut a), Ok(mut b)) => {
            while b != 0 {
                (a, b) = (b, a % b);
            }
            a.into()
        }
        _ if b == 0 => a,
        _ => gcd(b, a % b),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_in_order() {
        let of = |n, d| Ratio::new(n, d).unwrap();
        let long = 1_i128 << 120;
        let ordered = [
            of(-7, 2),
            of(-long - 1, long),
            of(-1, 1),
            of(-1, 3),
            of(0, 1),
            of(1, 3),
            of(long - 1, 2 * long),
            of(1, 2),
            of(long + 1, 2 * long),
            of(2, 3),
            of(5, 1),
        ];
        for (i, a) in ordered.iter().enumerate() {
            for (j, b) in ordered.iter().enumerate() {
                assert_eq!(a.cmp(b), i.cmp(&j), "{a:?} {b:?}");
            }
        }
    }
}
