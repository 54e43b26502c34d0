//! Truncated power series as a scalar: u₀ + u₁τ + … + u_{N−1}τ^{N−1}.
//!
//! A function of coordinates, evaluated with the Taylor series of a solution in τ = t − t₀ in place of numbers, returns its own Taylor coefficients along the
//! solution. Event functions are
//! evaluated in this way. The recurrences are the same as in the emitted kernels, but implemented independently. Tests compare both.

mod functions;

use crate::scalar::{Real, zero};
use core::array::from_fn;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A power series with `N` coefficients, from order 0. The comparisons of [`Real`] use the value at τ = 0; `==` compares all coefficients. A product costs
/// N²/2 products of numbers.
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
    /// Returns a constant series.
    pub fn constant(x: R) -> Self {
        Series(from_fn(|n| if n == 0 { x } else { zero() }))
    }

    /// Returns the value at τ = 0.
    fn start(self) -> R {
        self.0.first().copied().unwrap_or(zero())
    }

    /// Builds a series order by order. `next(n, y)` returns the coefficient of order n from the lower orders in `y`.
    fn by_orders(value: R, mut next: impl FnMut(usize, &[R; N]) -> R) -> Self {
        let mut y = Self::constant(value).0;
        for n in 1..N {
            y[n] = next(n, &y);
        }
        Series(y)
    }

    /// Returns the coefficients n·uₙ.
    fn weighted(self) -> [R; N] {
        from_fn(|n| whole::<R>(n) * self.0[n])
    }

    /// Returns y with y' = y·u' and y(0) = `value`.
    fn exponential(self, value: R) -> Self {
        let weighted = self.weighted();
        Self::by_orders(value, |n, y| sum(1..n + 1, |j| weighted[j] * y[n - j]) / whole(n))
    }

    /// Returns y with y'·d = u' and y(0) = `value`. Precondition: d(0) ≠ 0, or the coefficients are not finite.
    fn quadrature(self, value: R, d: Self) -> Self {
        let weighted = self.weighted();
        Self::by_orders(value, |n, y| {
            let known = sum(1..n, |j| whole::<R>(j) * y[j] * d.0[n - j]);
            (weighted[n] - known) / (whole::<R>(n) * d.start())
        })
    }

    /// Returns u^`exponent`, with the given `value` at τ = 0. Precondition: u(0) ≠ 0, or the coefficients are not finite, even if the series exists.
    fn power(self, value: R, exponent: R) -> Self {
        let u = self.0;
        Self::by_orders(value, |n, y| {
            let factor = |j: usize| whole::<R>(j) * (exponent + whole(1)) - whole(n);
            sum(1..n + 1, |j| factor(j) * u[j] * y[n - j]) / (whole::<R>(n) * u[0])
        })
    }

    /// Returns the pair y, z with y' = z·u' and z' = ±y·u', for given values at τ = 0. `sign` is the sign of z'.
    fn pair(self, [y, z]: [R; 2], sign: f64) -> (Self, Self) {
        let (weighted, mut y, mut z) = (self.weighted(), Self::constant(y).0, Self::constant(z).0);
        for n in 1..N {
            let of = |d: &[R; N]| sum(1..n + 1, |j| weighted[j] * d[n - j]) / whole(n);
            (y[n], z[n]) = (of(&z), R::from_f64(sign) * of(&y));
        }
        (Series(y), Series(z))
    }

    /// Returns y with y' = (1 ± y²)·u' and y(0) = `value`. `sign` is the sign of y².
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

    /// Returns y with y·w = u. Precondition: w(0) ≠ 0, or the coefficients are not finite.
    fn quotient(self, w: Self) -> Self {
        let start = w.start();
        Self::by_orders(self.start() / start, |n, q| (self.0[n] - sum(1..n + 1, |j| w.0[j] * q[n - j])) / start)
    }

    fn scaled(self, c: R) -> Self {
        Series(self.0.map(|u| c * u))
    }

    /// Replaces the value at τ = 0.
    fn with_start(mut self, value: R) -> Self {
        if let Some(start) = self.0.first_mut() {
            *start = value;
        }
        self
    }

    fn one() -> Self {
        Self::constant(whole(1))
    }

    /// Returns 1 − u² as (1 − u)(1 + u).
    fn circle(self) -> Self {
        (Self::one() - self) * (Self::one() + self)
    }
}

/// Converts an integer to the scalar.
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
        self.quotient(y)
    }
}
impl<R: Real, const N: usize> Neg for Series<R, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Series(self.0.map(|u| -u))
    }
}

/// Defines the assigning operators, and operators between a series and a number. A function that is written for numbers then accepts series.
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
        operations!($operation $method f64);
        operations!($operation $method f32);
    )* };
    ($operation:ident $method:ident $number:ty) => {
        impl<const N: usize> $operation<Series<$number, N>> for $number {
            type Output = Series<$number, N>;
            fn $method(self, y: Series<$number, N>) -> Series<$number, N> {
                $operation::$method(Series::constant(self), y)
            }
        }
    };
}

operations! {
    Add add AddAssign add_assign;
    Sub sub SubAssign sub_assign;
    Mul mul MulAssign mul_assign;
    Div div DivAssign div_assign;
}
