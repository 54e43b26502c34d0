//! Truncated power series as a scalar: u₀ + u₁τ + … + u_{N−1}τ^{N−1}.
//!
//! What is computed with series in place of coordinates has the Taylor coefficients of its value: functions along a solution, such as
//! what an event is a zero of. The recurrences are those of the kernels that are emitted, but written down once more, without regard
//! to speed: tests compare the two.

use super::real::{Real, zero};
use core::array::from_fn;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A power series of `N` coefficients, that of order 0 first. Conditions are decided by its value at 0.
///
/// ```
/// use geoint_runtime::scalar::{Real, Series};
///
/// // sin τ = τ − τ³/6 + …
/// let sine = Real::sin(Series::<f64, 5>([0.0, 1.0, 0.0, 0.0, 0.0]));
/// assert_eq!(sine.0, [0.0, 1.0, 0.0, -1.0 / 6.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Series<R, const N: usize>(pub [R; N]);

impl<R: Real, const N: usize> Series<R, N> {
    /// A constant.
    pub fn constant(x: R) -> Self {
        Series(from_fn(|n| if n == 0 { x } else { zero() }))
    }

    /// The value at τ = 0.
    fn start(self) -> R {
        self.0.first().copied().unwrap_or(zero())
    }

    /// Order by order, from the coefficients that are known; the value first.
    fn by_orders(value: R, mut next: impl FnMut(usize, &[R; N]) -> R) -> Self {
        let mut y = Self::constant(value).0;
        for n in 1..N {
            y[n] = next(n, &y);
        }
        Series(y)
    }

    /// n·uₙ.
    fn weighted(self) -> [R; N] {
        from_fn(|n| whole::<R>(n) * self.0[n])
    }

    /// y with y' = y·u', of this value.
    fn exponential(self, value: R) -> Self {
        let weighted = self.weighted();
        Self::by_orders(value, |n, y| sum(1..n + 1, |j| weighted[j] * y[n - j]) / whole(n))
    }

    /// y with y'·d = u', for y of this value.
    fn quadrature(self, value: R, d: Self) -> Self {
        let weighted = self.weighted();
        Self::by_orders(value, |n, y| {
            let known = sum(1..n, |j| whole::<R>(j) * y[j] * d.0[n - j]);
            (weighted[n] - known) / (whole::<R>(n) * d.start())
        })
    }

    /// uᵅ, of this value.
    fn power(self, value: R, exponent: R) -> Self {
        let u = self.0;
        Self::by_orders(value, |n, y| {
            let factor = |j: usize| whole::<R>(j) * (exponent + whole(1)) - whole(n);
            sum(1..n + 1, |j| factor(j) * u[j] * y[n - j]) / (whole::<R>(n) * u[0])
        })
    }

    /// Both functions of a pair y' = z·u', z' = ±y·u'.
    fn pair(self, [y, z]: [R; 2], sign: f64) -> (Self, Self) {
        let (weighted, mut y, mut z) = (self.weighted(), Self::constant(y).0, Self::constant(z).0);
        for n in 1..N {
            let of = |d: &[R; N]| sum(1..n + 1, |j| weighted[j] * d[n - j]) / whole(n);
            (y[n], z[n]) = (of(&z), R::from_f64(sign) * of(&y));
        }
        (Series(y), Series(z))
    }

    /// y with y' = (1 ± y²)·u', of this value.
    fn tangent(self, value: R, sign: f64) -> Self {
        let weighted = self.weighted();
        Self::by_orders(value, |n, y| {
            let slope = |m: usize| {
                let square = R::from_f64(sign) * sum(0..m + 1, |j| y[j] * y[m - j]);
                if m == 0 { whole::<R>(1) + square } else { square }
            };
            sum(1..n + 1, |j| weighted[j] * slope(n - j)) / whole(n)
        })
    }

    fn scaled(self, c: R) -> Self {
        Series(self.0.map(|u| c * u))
    }

    /// The value replaced.
    fn with_start(mut self, value: R) -> Self {
        if let Some(start) = self.0.first_mut() {
            *start = value;
        }
        self
    }

    fn one() -> Self {
        Self::constant(whole(1))
    }

    /// (1 − u)(1 + u).
    fn circle(self) -> Self {
        (Self::one() - self) * (Self::one() + self)
    }
}

/// A whole number.
fn whole<R: Real>(n: usize) -> R {
    R::from_f64(n as f64)
}

fn sum<R: Real>(range: core::ops::Range<usize>, term: impl Fn(usize) -> R) -> R {
    range.fold(zero(), |sum, j| sum + term(j))
}

impl<R: Real, const N: usize> Add for Series<R, N> {
    type Output = Self;
    fn add(self, y: Self) -> Self {
        Series(from_fn(|n| self.0[n] + y.0[n]))
    }
}
impl<R: Real, const N: usize> Sub for Series<R, N> {
    type Output = Self;
    fn sub(self, y: Self) -> Self {
        Series(from_fn(|n| self.0[n] - y.0[n]))
    }
}
impl<R: Real, const N: usize> Mul for Series<R, N> {
    type Output = Self;
    fn mul(self, y: Self) -> Self {
        Series(from_fn(|n| sum(0..n + 1, |j| self.0[j] * y.0[n - j])))
    }
}
impl<R: Real, const N: usize> Div for Series<R, N> {
    type Output = Self;
    fn div(self, y: Self) -> Self {
        let start = y.start();
        Self::by_orders(self.start() / start, |n, q| (self.0[n] - sum(1..n + 1, |j| y.0[j] * q[n - j])) / start)
    }
}
impl<R: Real, const N: usize> Neg for Series<R, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Series(self.0.map(|u| -u))
    }
}

/// Operations with a series on the right, and with a number: functions that were written for numbers hold for series.
macro_rules! operations {
    ($($operation:ident $method:ident $assign:ident $assign_method:ident;)*) => { $(
        impl<R: Real, const N: usize> $assign for Series<R, N> {
            fn $assign_method(&mut self, y: Self) {
                *self = $operation::$method(*self, y);
            }
        }
        impl<R: Real, const N: usize> $operation<R> for Series<R, N> {
            type Output = Self;
            fn $method(self, y: R) -> Self {
                $operation::$method(self, Series::constant(y))
            }
        }
        impl<const N: usize> $operation<Series<f64, N>> for f64 {
            type Output = Series<f64, N>;
            fn $method(self, y: Series<f64, N>) -> Series<f64, N> {
                $operation::$method(Series::constant(self), y)
            }
        }
    )* };
}

operations! {
    Add add AddAssign add_assign;
    Sub sub SubAssign sub_assign;
    Mul mul MulAssign mul_assign;
    Div div DivAssign div_assign;
}

/// Functions under the names that numbers have them by, for functions of states that name no trait.
macro_rules! functions {
    ($($name:ident($($y:ident)?);)*) => {
        impl<const N: usize> Series<f64, N> {
            $(
                #[doc = concat!("`", stringify!($name), "` of a series.")]
                pub fn $name(self $(, $y: Self)?) -> Self {
                    Real::$name(self $(, $y)?)
                }
            )*
            /// A power with an integer exponent.
            pub fn powi(self, n: i32) -> Self {
                let power = (0..n.unsigned_abs()).fold(Self::one(), |power, _| power * self);
                if n < 0 { Self::one() / power } else { power }
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
