//! Elementary functions of power series.

use super::{Series, sum, whole};
use crate::scalar::Real;
use core::array::from_fn;

/// Defines the elementary functions as methods, with the names of `f64`. A function that is written for numbers then accepts series without a trait.
macro_rules! functions {
    ($($name:ident($($y:ident)?);)*) => {
        functions!(f64: $($name($($y)?);)*);
        functions!(f32: $($name($($y)?);)*);
    };
    ($number:ty: $($name:ident($($y:ident)?);)*) => {
        impl<const N: usize> Series<$number, N> {
            $(
                #[doc = concat!("`", stringify!($name), "` of a series.")]
                pub fn $name(self $(, $y: Self)?) -> Self {
                    Real::$name(self $(, $y)?)
                }
            )*
            /// Returns a power with an integer exponent.
            pub fn powi(self, n: i32) -> Self {
                let power = (0..n.unsigned_abs()).fold(Self::one(), |power, _| power * self);
                if n < 0 { Self::one() / power } else { power }
            }
            /// Returns a power with a constant exponent.
            pub fn powf(self, exponent: $number) -> Self {
                Real::powf(self, Series::constant(exponent))
            }
            /// Returns 1/u.
            pub fn recip(self) -> Self {
                Self::one() / self
            }
            /// Returns u·a + b.
            pub fn mul_add(self, a: Self, b: Self) -> Self {
                self * a + b
            }
            /// Returns sine and cosine.
            pub fn sin_cos(self) -> (Self, Self) {
                Real::sin_cos(self)
            }
        }
    };
}

functions! {
    sqrt(); cbrt(); hypot(y); sin(); cos(); tan(); asin(); acos(); atan(); atan2(x); sinh(); cosh(); tanh(); asinh(); acosh();
    atanh(); exp(); exp2(); exp_m1(); ln(); ln_1p(); log2(); log10(); abs(); min(y); max(y); signum();
}

impl<R: Real, const N: usize> Real for Series<R, N> {
    type Mask = R::Mask;

    fn less(self, y: Self) -> R::Mask {
        self.start().less(y.start())
    }
    fn less_equal(self, y: Self) -> R::Mask {
        self.start().less_equal(y.start())
    }
    fn equal(self, y: Self) -> R::Mask {
        self.start().equal(y.start())
    }
    fn choose<const K: usize>(
        mask: R::Mask,
        first: impl FnOnce() -> [Self; K],
        second: impl FnOnce() -> [Self; K],
    ) -> [Self; K] {
        let (first, second) = (first(), second());
        from_fn(|k| Series(R::choose(mask, || first[k].0, || second[k].0)))
    }
    fn from_f64(x: f64) -> Self {
        Self::constant(R::from_f64(x))
    }
    fn magnitude(self) -> f64 {
        self.start().magnitude()
    }
    fn any_below(self, bound: f64) -> bool {
        self.start().any_below(bound)
    }
    fn epsilon() -> f64 {
        R::epsilon()
    }
    fn smallest() -> f64 {
        R::smallest()
    }
    fn sqrt(self) -> Self {
        let value = self.start().sqrt();
        Self::by_orders(value, |n, y| (self.0[n] - sum(1..n, |j| y[j] * y[n - j])) / (value + value))
    }
    fn cbrt(self) -> Self {
        self.power(self.start().cbrt(), R::from_f64(1.0 / 3.0))
    }
    fn hypot(self, y: Self) -> Self {
        let value = self.start().hypot(y.start());
        (self * self + y * y).sqrt().with_start(value)
    }
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.start().sin_cos();
        self.pair([sin, cos], -1.0)
    }
    fn tan(self) -> Self {
        self.tangent(self.start().tan(), 1.0)
    }
    fn asin(self) -> Self {
        self.quadrature(self.start().asin(), self.circle().sqrt())
    }
    fn acos(self) -> Self {
        self.quadrature(self.start().acos(), -self.circle().sqrt())
    }
    fn atan(self) -> Self {
        self.quadrature(self.start().atan(), Self::one() + self * self)
    }
    fn atan2(self, x: Self) -> Self {
        let (y, square) = (self, self * self + x * x);
        Self::by_orders(y.start().atan2(x.start()), |n, a| {
            let moved = sum(1..n + 1, |j| whole::<R>(j) * (x.0[n - j] * y.0[j] - y.0[n - j] * x.0[j]));
            let known = sum(1..n, |j| whole::<R>(j) * a[j] * square.0[n - j]);
            (moved - known) / (whole::<R>(n) * square.start())
        })
    }
    fn sinh(self) -> Self {
        self.pair([self.start().sinh(), self.start().cosh()], 1.0).0
    }
    fn cosh(self) -> Self {
        self.pair([self.start().sinh(), self.start().cosh()], 1.0).1
    }
    fn tanh(self) -> Self {
        self.tangent(self.start().tanh(), -1.0)
    }
    fn asinh(self) -> Self {
        self.quadrature(self.start().asinh(), (Self::one() + self * self).sqrt())
    }
    fn acosh(self) -> Self {
        self.quadrature(self.start().acosh(), ((self - Self::one()) * (self + Self::one())).sqrt())
    }
    fn atanh(self) -> Self {
        self.quadrature(self.start().atanh(), self.circle())
    }
    fn exp(self) -> Self {
        self.exponential(self.start().exp())
    }
    fn exp2(self) -> Self {
        self.scaled(R::from_f64(core::f64::consts::LN_2)).exponential(self.start().exp2())
    }
    fn exp_m1(self) -> Self {
        self.exp().with_start(self.start().exp_m1())
    }
    fn ln(self) -> Self {
        self.quadrature(self.start().ln(), self)
    }
    fn ln_1p(self) -> Self {
        self.quadrature(self.start().ln_1p(), Self::one() + self)
    }
    fn log2(self) -> Self {
        self.ln().scaled(R::from_f64(1.0 / core::f64::consts::LN_2)).with_start(self.start().log2())
    }
    fn log10(self) -> Self {
        self.ln().scaled(R::from_f64(1.0 / core::f64::consts::LN_10)).with_start(self.start().log10())
    }
    fn powf(self, y: Self) -> Self {
        let value = self.start().powf(y.start());
        if y.0.iter().skip(1).all(|y| y.magnitude() == 0.0) {
            return self.power(value, y.start());
        }
        (y * self.ln()).exponential(value)
    }
    fn abs(self) -> Self {
        self.scaled(self.start().signum())
    }
    fn min(self, y: Self) -> Self {
        let [min] = Self::choose(self.less_equal(y), || [self], || [y]);
        min
    }
    fn max(self, y: Self) -> Self {
        let [max] = Self::choose(y.less_equal(self), || [self], || [y]);
        max
    }
    fn signum(self) -> Self {
        Self::constant(self.start().signum())
    }
}
