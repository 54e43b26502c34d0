//! Enclosures: intervals that contain the values and the derivatives of a function on a part of a line.

use super::Real;
use super::interval::Interval;
use core::f64::consts::{LN_2, LN_10};
use core::marker::PhantomData;
use core::ops::{Add, AddAssign, BitAnd, BitOr, Div, DivAssign, Mul, MulAssign, Neg, Not, Sub, SubAssign};

/// Intervals that contain the values of a function and its derivative.
///
/// The interval of the derivative contains each difference quotient, as in the mean value theorem. This definition also covers functions that are not
/// differentiable, or not continuous. Constants are rounded to the scalar `R`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Enclosure<R> {
    pub(crate) value: Interval,
    pub(crate) rate: Interval,
    scalar: PhantomData<fn() -> R>,
}

impl<R> PartialEq for Enclosure<R> {
    fn eq(&self, other: &Self) -> bool {
        (self.value, self.rate) == (other.value, other.rate)
    }
}

const ZERO: Interval = Interval { low: 0.0, high: 0.0 };
const ONE: Interval = Interval { low: 1.0, high: 1.0 };

impl<R> Enclosure<R> {
    pub(crate) fn new(value: Interval, rate: Interval) -> Self {
        Enclosure { value, rate, scalar: PhantomData }
    }

    /// Returns the enclosure of f(x) by the chain rule. `value` encloses f(x), and `slope` encloses f'(x).
    fn chain(self, value: Interval, slope: Interval) -> Self {
        Self::new(value, slope * self.rate)
    }
}

impl<R: Real> Enclosure<R> {
    /// Returns the enclosure of a constant: all numbers between the components of a scalar.
    pub(crate) fn constant(x: R) -> Self {
        Self::new(bounds(x), ZERO)
    }
}

/// Returns an interval that contains all components of a scalar.
pub(crate) fn bounds<R: Real>(x: R) -> Interval {
    let size = x.magnitude();
    let value = if !x.any_below(size) {
        Interval::point(size)
    } else if !x.any_above(-size) {
        Interval::point(-size)
    } else {
        Interval::new(if x.any_below(0.0) { -size } else { 0.0 }, if x.any_above(0.0) { size } else { 0.0 })
    };
    // A scalar with more digits than `f64` was rounded to `f64`.
    if R::epsilon() < f64::EPSILON { value * Interval::new(1.0 - f64::EPSILON, 1.0 + f64::EPSILON) } else { value }
}

impl<R: Copy> Neg for Enclosure<R> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.rate)
    }
}

impl<R: Copy> Add for Enclosure<R> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.rate + other.rate)
    }
}

impl<R: Copy> Sub for Enclosure<R> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.rate - other.rate)
    }
}

impl<R: Copy> Mul for Enclosure<R> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.value * other.value, self.rate * other.value + self.value * other.rate)
    }
}

impl<R: Copy> Div for Enclosure<R> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::new(value, (self.rate - value * other.rate) / other.value)
    }
}

macro_rules! assign {
    ($($trait:ident::$method:ident = $op:tt;)*) => { $(
        impl<R: Copy> $trait for Enclosure<R> {
            fn $method(&mut self, other: Self) {
                *self = *self $op other;
            }
        }
    )* };
}

assign! { AddAssign::add_assign = +; SubAssign::sub_assign = -; MulAssign::mul_assign = *; DivAssign::div_assign = /; }

/// Implements functions of one argument, from the value f(x) and the derivative in terms of x and f.
macro_rules! functions {
    ($($name:ident($x:ident) = $value:expr, $f:ident => $slope:expr;)*) => { $(
        fn $name(self) -> Self {
            let $x = self.value;
            let $f = $value;
            self.chain($f, $slope)
        }
    )* };
}

/// The result of a comparison of intervals: `yes` if it may be true, `no` if it may be false.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Possible {
    yes: bool,
    no: bool,
}

impl BitAnd for Possible {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Possible { yes: self.yes && other.yes, no: self.no || other.no }
    }
}

impl BitOr for Possible {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        !(!self & !other)
    }
}

impl Not for Possible {
    type Output = Self;
    fn not(self) -> Self {
        Possible { yes: self.no, no: self.yes }
    }
}

impl<R: Real> Real for Enclosure<R> {
    type Mask = Possible;

    fn less(self, y: Self) -> Possible {
        !y.less_equal(self)
    }
    fn less_equal(self, y: Self) -> Possible {
        let (a, b) = (self.value, y.value);
        Possible { yes: a.low <= b.high, no: a.high > b.low }
    }
    fn equal(self, y: Self) -> Possible {
        self.less_equal(y) & y.less_equal(self)
    }
    fn choose<const N: usize>(
        mask: Possible,
        first: impl FnOnce() -> [Self; N],
        second: impl FnOnce() -> [Self; N],
    ) -> [Self; N] {
        match mask {
            Possible { no: false, .. } => first(),
            Possible { yes: false, .. } => second(),
            _ => {
                let (first, second) = (first(), second());
                core::array::from_fn(|i| Self::new(first[i].value.hull(second[i].value), Interval::WHOLE))
            }
        }
    }

    fn from_f64(x: f64) -> Self {
        Self::new(bounds(R::from_f64(x)).hull(Interval::point(x)), ZERO)
    }
    fn magnitude(self) -> f64 {
        self.value.abs().high
    }
    fn any_below(self, bound: f64) -> bool {
        self.value.low < bound
    }
    fn epsilon() -> f64 {
        R::epsilon()
    }
    fn smallest() -> f64 {
        R::smallest()
    }

    functions! {
        sqrt(x) = x.sqrt(), f => ONE / (f + f);
        cbrt(x) = x.cbrt(), f => ONE / (Interval::point(3.0) * f.square());
        sin(x) = x.sin(), _f => x.cos();
        cos(x) = x.cos(), _f => -x.sin();
        tan(x) = x.tan(), f => ONE + f.square();
        asin(x) = x.asin(), _f => ONE / (ONE - x.square()).sqrt();
        acos(x) = x.acos(), _f => -(ONE / (ONE - x.square()).sqrt());
        atan(x) = x.atan(), _f => ONE / (ONE + x.square());
        sinh(x) = x.sinh(), _f => x.cosh();
        cosh(x) = x.cosh(), _f => x.sinh();
        tanh(x) = x.tanh(), f => ONE - f.square();
        asinh(x) = x.asinh(), _f => ONE / (ONE + x.square()).sqrt();
        acosh(x) = x.acosh(), _f => ONE / (x.square() - ONE).sqrt();
        atanh(x) = x.atanh(), _f => ONE / (ONE - x.square());
        exp(x) = x.exp(), f => f;
        exp2(x) = x.exp2(), f => f * nearly(LN_2);
        exp_m1(x) = x.exp_m1(), _f => x.exp();
        ln(x) = x.logarithm(0.0, Real::ln), _f => ONE / x;
        ln_1p(x) = x.logarithm(-1.0, Real::ln_1p), _f => ONE / (ONE + x);
        log2(x) = x.logarithm(0.0, Real::log2), _f => ONE / (x * nearly(LN_2));
        log10(x) = x.logarithm(0.0, Real::log10), _f => ONE / (x * nearly(LN_10));
        abs(x) = x.abs(), _f => x.signum();
        signum(x) = x.signum(), f => if f.low == f.high { ZERO } else { Interval::WHOLE };
    }

    fn hypot(self, y: Self) -> Self {
        let value = self.value.hypot(y.value);
        Self::new(value, (self.value * self.rate + y.value * y.rate) / value)
    }
    fn atan2(self, x: Self) -> Self {
        let value = self.value.atan2(x.value);
        let rate = if self.value.is_cut(x.value) {
            Interval::WHOLE
        } else {
            (x.value * self.rate - self.value * x.rate) / (x.value.square() + self.value.square())
        };
        Self::new(value, rate)
    }
    fn powf(self, y: Self) -> Self {
        let value = self.value.powf(y.value);
        let slope = y.value * self.value.powf(y.value - ONE);
        let growth = value * self.value.logarithm(0.0, Real::ln);
        Self::new(value, slope * self.rate + growth * y.rate)
    }
    fn min(self, y: Self) -> Self {
        -(-self).max(-y)
    }
    fn max(self, y: Self) -> Self {
        let rate = match (self.value - y.value).signum() {
            Interval { low: 1.0, .. } => self.rate,
            Interval { high: -1.0, .. } => y.rate,
            _ => self.rate.hull(y.rate),
        };
        Self::new(self.value.max(y.value), rate)
    }
}

/// Returns an interval around a rounded constant.
fn nearly(x: f64) -> Interval {
    Interval::new(x.next_down(), x.next_up())
}

#[cfg(test)]
mod tests;
