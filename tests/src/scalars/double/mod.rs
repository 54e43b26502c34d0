//! Double-double arithmetic: an unevaluated sum of two `f64`, about 31 digits.
//!
//! A method of order 12 then shows its error over several halvings of the step before rounding hides the error. `+ − · ÷ √` are accurate to a few
//! units of 2⁻¹⁰⁴. `sin cos exp ln atan2` and their derived functions come from Taylor series and Newton steps. They are accurate to about 10⁻²⁹ for
//! arguments of moderate size (|x| up to some hundreds). Differences such as `exp_m1` and `ln_1p` are accurate in the absolute, not in the relative
//! sense. Special values (NaN, ±∞, ±0) are not handled.
//!
//! T. J. Dekker, Numer. Math. 18 (1971) 224; D. E. Knuth, *The Art of Computer Programming* 2, 4.2.2.

mod elementary;

use super::arithmetic;

/// hi + lo with |lo| ≤ ulp(hi)/2.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Double {
    hi: f64,
    lo: f64,
}

/// Digits beyond the 53 bits of hi.
const fn constant(hi: f64, lo: f64) -> Double {
    Double { hi, lo }
}

impl Double {
    /// π.
    pub const PI: Double = constant(std::f64::consts::PI, 1.224_646_799_147_353_2e-16);
    /// ln 2.
    pub const LN_2: Double = constant(std::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);
    /// ln 10.
    pub const LN_10: Double = constant(std::f64::consts::LN_10, -2.170_756_223_382_249_4e-16);
}

/// a + b as a rounded sum and its error.
#[inline]
fn two_sum(a: f64, b: f64) -> Double {
    let hi = a + b;
    let b_part = hi - a;
    Double { hi, lo: (a - (hi - b_part)) + (b - b_part) }
}

/// Returns a + b with its rounding error, for |a| ≥ |b|.
#[inline]
fn quick_two_sum(a: f64, b: f64) -> Double {
    let hi = a + b;
    Double { hi, lo: b - (hi - a) }
}

/// a·b as a rounded product and its error.
#[inline]
fn two_product(a: f64, b: f64) -> Double {
    let hi = a * b;
    Double { hi, lo: a.mul_add(b, -hi) }
}

#[inline]
fn sum(a: Double, b: Double) -> Double {
    let (s, t) = (two_sum(a.hi, b.hi), two_sum(a.lo, b.lo));
    let s = quick_two_sum(s.hi, s.lo + t.hi);
    quick_two_sum(s.hi, s.lo + t.lo)
}

#[inline]
fn product(a: Double, b: Double) -> Double {
    let p = two_product(a.hi, b.hi);
    quick_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi))
}

/// Long division: three digits of 53 bits.
#[inline]
fn quotient(a: Double, b: Double) -> Double {
    let first = a.hi / b.hi;
    let rest = a - b * first;
    let second = rest.hi / b.hi;
    let rest = rest - b * second;
    quick_two_sum(first, second) + rest.hi / b.hi
}

arithmetic! { Double:
    Add::add, AddAssign::add_assign = |a, b| sum(a, b);
    Sub::sub, SubAssign::sub_assign = |a, b| sum(a, -b);
    Mul::mul, MulAssign::mul_assign = |a, b| product(a, b);
    Div::div, DivAssign::div_assign = |a, b| quotient(a, b);
}

impl core::ops::Neg for Double {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Double { hi: -self.hi, lo: -self.lo }
    }
}

impl From<f64> for Double {
    #[inline]
    fn from(x: f64) -> Self {
        Double { hi: x, lo: 0.0 }
    }
}

impl Double {
    /// Rounded to `f64`.
    pub fn value(self) -> f64 {
        self.hi
    }

    fn scaled(self, power_of_two: f64) -> Self {
        Double { hi: self.hi * power_of_two, lo: self.lo * power_of_two }
    }

    /// Σ xᵏ/k! for |x| ≤ 2⁻⁸ over k = first, first + step, …, with the sign changing if asked.
    fn series(self, first: u32, step: u32, alternating: bool) -> Self {
        let mut term = Double::from(1.0);
        for k in 1..=first {
            term = term * self / f64::from(k);
        }
        let (mut total, mut k) = (term, first);
        while term.hi.abs() > 1e-34 {
            for _ in 0..step {
                k += 1;
                term = term * self / f64::from(k);
            }
            if alternating {
                term = -term;
            }
            total += term;
        }
        total
    }
}
