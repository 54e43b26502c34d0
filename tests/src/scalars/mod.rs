//! Scalars for kernels in tests only: one with a derivative, one with twice the digits, one with two components, and one that counts.

mod double;
mod dual;
mod lanes;
mod tallied;

pub use double::Double;
pub use dual::Dual;
pub use lanes::Lanes;
pub use tallied::{Tallied, Tally};

use geoint_runtime::Real;

/// A scalar that is compared in tests.
pub trait Scalar: Real + PartialOrd {}
impl<R: Real + PartialOrd> Scalar for R {}

/// The choices of a scalar that is compared as a whole.
macro_rules! compared {
    () => {
        type Mask = bool;
        fn less(self, y: Self) -> bool {
            self < y
        }
        fn less_equal(self, y: Self) -> bool {
            self <= y
        }
        fn equal(self, y: Self) -> bool {
            self == y
        }
        fn choose<const N: usize>(
            mask: bool,
            first: impl FnOnce() -> [Self; N],
            second: impl FnOnce() -> [Self; N],
        ) -> [Self; N] {
            if mask { first() } else { second() }
        }
    };
}
use compared;

/// The arithmetic of `std::ops` from functions of two values, the other operand being the same type or `f64`.
macro_rules! arithmetic {
    ($scalar:ident: $($op:ident::$method:ident, $assign:ident::$assign_method:ident = |$a:ident, $b:ident| $value:expr;)*) => { $(
        impl core::ops::$op for $scalar {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $value
            }
        }
        impl core::ops::$assign for $scalar {
            #[inline]
            fn $assign_method(&mut self, other: Self) {
                *self = core::ops::$op::$method(*self, other);
            }
        }
        impl core::ops::$op<f64> for $scalar {
            type Output = Self;
            #[inline]
            fn $method(self, other: f64) -> Self {
                core::ops::$op::$method(self, <$scalar>::from(other))
            }
        }
        impl core::ops::$op<$scalar> for f64 {
            type Output = $scalar;
            #[inline]
            fn $method(self, other: $scalar) -> $scalar {
                core::ops::$op::$method(<$scalar>::from(self), other)
            }
        }
    )* };
}
use arithmetic;
