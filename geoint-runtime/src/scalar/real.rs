//! `Real`: the scalar of every kernel.
//!
//! A scalar may stand for many trajectories side by side, or carry derivatives along. So kernels never decide by a comparison:
//! where an energy has an `if` they ask the scalar to choose ([`Real::choose`]), and drivers ask questions that speak for all
//! components at once (pivots, convergence, "is this a number": [`Real::magnitude`], [`Real::any_below`]).

use core::array::from_fn;
use core::fmt::Debug;
use core::ops::{Add, AddAssign, BitAnd, BitOr, Div, DivAssign, Mul, MulAssign, Neg, Not, Sub, SubAssign};

/// The scalar of kernels: `f64`, `f32`, and whatever behaves like them.
pub trait Real:
    Copy
    + Debug
    + PartialEq
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// What comparisons give: a `bool`, or one a component.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// Whether `self < y`.
    fn less(self, y: Self) -> Self::Mask;
    /// Whether `self <= y`.
    fn less_equal(self, y: Self) -> Self::Mask;
    /// Whether `self == y`.
    fn equal(self, y: Self) -> Self::Mask;
    /// `first` where `mask` holds, `second` elsewhere; a branch that no component takes need not be computed.
    fn choose<const N: usize>(
        mask: Self::Mask,
        first: impl FnOnce() -> [Self; N],
        second: impl FnOnce() -> [Self; N],
    ) -> [Self; N];

    /// The scalar nearest to `x`.
    fn from_f64(x: f64) -> Self;

    /// |x| as a plain number (the largest of all components); NaN if any of them is.
    fn magnitude(self) -> f64;

    /// Whether any component lies below `bound`.
    fn any_below(self, bound: f64) -> bool;

    /// Whether any component lies above `bound`.
    fn any_above(self, bound: f64) -> bool {
        (-self).any_below(-bound)
    }

    /// Whether every component is a positive number.
    fn all_positive(self) -> bool {
        self.all_at_least_zero() && !self.any_not_positive()
    }

    /// Whether every component is a number that is not negative.
    fn all_at_least_zero(self) -> bool {
        self.magnitude() < f64::INFINITY && !self.any_below(0.0)
    }

    /// The distance from 1 to the next larger number.
    fn epsilon() -> f64;

    /// The smallest positive number that has all its digits.
    fn smallest() -> f64;

    /// Whether any component is not above zero, or so little that it has lost digits.
    fn any_not_positive(self) -> bool {
        self.any_below(Self::smallest())
    }

    /// `t0 + n·h` for a t₀ of two words, the larger one first. Time is never a running sum; a short type may evaluate this in a
    /// longer one.
    fn time(t0: [Self; 2], n: u64, h: Self) -> Self {
        t0[0] + (t0[1] + Self::from_f64(n as f64) * h)
    }

    /// `self·a + b`, fused where the processor of this build does that in one instruction.
    ///
    /// Without such hardware a fused multiply-add is a slow library call, so a product and a sum are used; the feature
    /// `strict-math` asks for that everywhere.
    fn multiply_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    /// Four numbers side by side, as emitted code computes what is alike.
    #[doc(hidden)]
    #[inline(always)]
    fn four(numbers: [Self; 4]) -> Four<Self> {
        Four(numbers)
    }
    /// Four sums, of numbers side by side. A scalar with registers for four overrides this, and what follows: with the same bits.
    #[doc(hidden)]
    #[inline(always)]
    fn add_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| a[i] + b[i])
    }
    /// Four differences.
    #[doc(hidden)]
    #[inline(always)]
    fn subtract_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| a[i] - b[i])
    }
    /// Four products.
    #[doc(hidden)]
    #[inline(always)]
    fn multiply_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| a[i] * b[i])
    }
    /// Four quotients.
    #[doc(hidden)]
    #[inline(always)]
    fn divide_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| a[i] / b[i])
    }
    /// Four times [`Real::multiply_add`].
    #[doc(hidden)]
    #[inline(always)]
    fn multiply_add_four(x: [Self; 4], a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| x[i].multiply_add(a[i], b[i]))
    }
    /// Four square roots.
    #[doc(hidden)]
    #[inline(always)]
    fn sqrt_four(x: [Self; 4]) -> [Self; 4] {
        x.map(Self::sqrt)
    }

    /// The upper half of the digits, so that a product of two halves is exact. T. J. Dekker, Numer. Math. 18 (1971) 224.
    fn upper_half(self) -> Self {
        let digits = 1.0 - Real::log2(Self::epsilon());
        let shifted = Self::from_f64(Real::exp2(libm::ceil(0.5 * digits)) + 1.0) * self;
        shifted - (shifted - self)
    }

    /// Square root.
    fn sqrt(self) -> Self;
    /// Cube root, of negative numbers too.
    fn cbrt(self) -> Self;
    /// √(x² + y²) without overflow on the way.
    fn hypot(self, y: Self) -> Self;
    /// Sine.
    fn sin(self) -> Self;
    /// Cosine.
    fn cos(self) -> Self;
    /// Sine and cosine of one argument.
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
    /// Tangent.
    fn tan(self) -> Self;
    /// Inverse sine.
    fn asin(self) -> Self;
    /// Inverse cosine.
    fn acos(self) -> Self;
    /// Inverse tangent.
    fn atan(self) -> Self;
    /// The angle of the point (`x`, `self`).
    fn atan2(self, x: Self) -> Self;
    /// Hyperbolic sine.
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Inverse hyperbolic sine.
    fn asinh(self) -> Self;
    /// Inverse hyperbolic cosine.
    fn acosh(self) -> Self;
    /// Inverse hyperbolic tangent.
    fn atanh(self) -> Self;
    /// eˣ.
    fn exp(self) -> Self;
    /// 2ˣ.
    fn exp2(self) -> Self;
    /// eˣ − 1, exact near 0.
    fn exp_m1(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// ln(1 + x), exact near 0.
    fn ln_1p(self) -> Self;
    /// Logarithm to base 2.
    fn log2(self) -> Self;
    /// Logarithm to base 10.
    fn log10(self) -> Self;
    /// xʸ for a real exponent.
    fn powf(self, y: Self) -> Self;
    /// |x|.
    fn abs(self) -> Self;
    /// The smaller of two.
    fn min(self, y: Self) -> Self;
    /// The larger of two.
    fn max(self, y: Self) -> Self;
    /// ±1, the sign of x.
    fn signum(self) -> Self;
}

/// Four numbers that go through the same operations. Each number has the bits that it would have alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Four<R>(pub [R; 4]);

/// Zero.
#[inline(always)]
pub(crate) fn zero<R: Real>() -> R {
    R::from_f64(0.0)
}

/// A scalar as a plain number, with its sign.
#[inline(always)]
pub(crate) fn signed<R: Real>(x: R) -> f64 {
    if x.any_below(0.0) { -x.magnitude() } else { x.magnitude() }
}
