//! The trait [`Real`]: the scalar type of all kernels.
//!
//! A scalar may have several components, for instance one for each of many trajectories, or a value with derivatives. Therefore kernels do not branch
//! on a comparison. An `if` in an energy becomes [`Real::choose`]. Drivers use functions of all components, such as [`Real::magnitude`] and
//! [`Real::any_below`], for pivots and tests of convergence.

use core::array::from_fn;
use core::fmt::Debug;
use core::ops::{Add, AddAssign, BitAnd, BitOr, Div, DivAssign, Mul, MulAssign, Neg, Not, Sub, SubAssign};

/// A scalar of kernels: `f64`, `f32`, or a type of the user with the same operations.
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
    /// The result of a comparison: a `bool`, or one for each component.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// Returns whether `self < y`.
    fn less(self, y: Self) -> Self::Mask;
    /// Returns whether `self <= y`.
    fn less_equal(self, y: Self) -> Self::Mask;
    /// Returns whether `self == y`.
    fn equal(self, y: Self) -> Self::Mask;
    /// Returns `first` for the components with a true `mask`, and `second` for the others. A branch that no component takes need not be computed.
    fn choose<const N: usize>(
        mask: Self::Mask,
        first: impl FnOnce() -> [Self; N],
        second: impl FnOnce() -> [Self; N],
    ) -> [Self; N];

    /// Returns the scalar nearest to `x`.
    fn from_f64(x: f64) -> Self;

    /// Returns |x| as an `f64`: the largest magnitude of all components. NaN if a component is NaN.
    fn magnitude(self) -> f64;

    /// Returns whether any component is below `bound`.
    fn any_below(self, bound: f64) -> bool;

    /// Returns whether any component is above `bound`.
    fn any_above(self, bound: f64) -> bool {
        (-self).any_below(-bound)
    }

    /// Returns whether each component is finite and a positive normal number.
    fn all_positive(self) -> bool {
        self.all_at_least_zero() && !self.any_not_positive()
    }

    /// Returns whether each component is finite and not negative.
    fn all_at_least_zero(self) -> bool {
        self.magnitude() < f64::INFINITY && !self.any_below(0.0)
    }

    /// Returns ε, the distance from 1 to the next larger number.
    fn epsilon() -> f64;

    /// Returns the smallest positive normal number.
    fn smallest() -> f64;

    /// Returns whether any component is negative, zero or subnormal.
    fn any_not_positive(self) -> bool {
        self.any_below(Self::smallest())
    }

    /// Returns `t0 + n·h` for a t₀ of two words, the larger one first. Time is never a running sum. A short type may evaluate this expression in a
    /// longer type.
    fn time(t0: [Self; 2], n: u64, h: Self) -> Self {
        t0[0] + (t0[1] + Self::from_f64(n as f64) * h)
    }

    /// Returns `self·a + b`, fused if the build targets a processor with such an instruction.
    ///
    /// Otherwise a product and a sum are used, because a fused multiply-add would be a library call. The feature `strict-math` enforces product and sum.
    fn multiply_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    /// Returns four numbers as [`Four`]. Emitted code uses it for terms with the same formula.
    #[doc(hidden)]
    #[inline(always)]
    fn four(numbers: [Self; 4]) -> Four<Self> {
        Four(numbers)
    }
    /// Returns four sums. A scalar with SIMD registers overrides this function and the following ones. The results must have the same bits.
    #[doc(hidden)]
    #[inline(always)]
    fn add_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| a[i] + b[i])
    }
    /// Returns four differences.
    #[doc(hidden)]
    #[inline(always)]
    fn subtract_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| a[i] - b[i])
    }
    /// Returns four products.
    #[doc(hidden)]
    #[inline(always)]
    fn multiply_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| a[i] * b[i])
    }
    /// Returns four quotients.
    #[doc(hidden)]
    #[inline(always)]
    fn divide_four(a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| a[i] / b[i])
    }
    /// Returns four results of [`Real::multiply_add`].
    #[doc(hidden)]
    #[inline(always)]
    fn multiply_add_four(x: [Self; 4], a: [Self; 4], b: [Self; 4]) -> [Self; 4] {
        from_fn(|i| x[i].multiply_add(a[i], b[i]))
    }
    /// Returns four square roots.
    #[doc(hidden)]
    #[inline(always)]
    fn sqrt_four(x: [Self; 4]) -> [Self; 4] {
        x.map(Self::sqrt)
    }

    /// Returns the upper half of the digits. A product of two halves is exact. T. J. Dekker, Numer. Math. 18 (1971) 224.
    fn upper_half(self) -> Self {
        let digits = 1.0 - Real::log2(Self::epsilon());
        let shifted = Self::from_f64(Real::exp2(libm::ceil(0.5 * digits)) + 1.0) * self;
        shifted - (shifted - self)
    }

    /// Square root.
    fn sqrt(self) -> Self;
    /// Cube root, also of negative numbers.
    fn cbrt(self) -> Self;
    /// √(x² + y²) without overflow of the squares.
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
    /// eˣ − 1, without cancellation near 0.
    fn exp_m1(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// ln(1 + x), without cancellation near 0.
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

/// Four numbers with the same operations. The bits of each number are the same as in scalar arithmetic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Four<R>(pub [R; 4]);

/// Returns zero.
#[inline(always)]
pub(crate) fn zero<R: Real>() -> R {
    R::from_f64(0.0)
}

/// Returns a scalar as an `f64` with its sign.
#[inline(always)]
pub(crate) fn signed<R: Real>(x: R) -> f64 {
    if x.any_below(0.0) { -x.magnitude() } else { x.magnitude() }
}
