//! A value with one derivative: `num_dual::Dual64` as the scalar of a kernel.
//!
//! In a kernel, a dual number gives the derivative of the kernel. In a step, it gives a column of the step's Jacobian. The rules come from another
//! crate, so this code cannot share an error with the macro.

use super::{arithmetic, compared};
use core::cmp::Ordering;
use geoint_runtime::Real;
use num_dual::{Dual64, DualNum};

/// x + x'ε with ε² = 0.
#[derive(Clone, Copy, Debug)]
pub struct Dual(Dual64);

impl Dual {
    /// The coordinate that is differentiated by.
    pub fn variable(x: f64) -> Self {
        Dual(Dual64::new(x, 1.0))
    }

    /// x.
    pub fn value(self) -> f64 {
        self.0.re
    }

    /// x'.
    pub fn derivative(self) -> f64 {
        self.0.eps
    }

    /// x to an integer power.
    pub fn powi(self, n: i32) -> Self {
        Dual(self.0.powi(n))
    }

    /// x to the power of a constant or of another dual number, like the method of `f64`.
    pub fn powf(self, y: impl Into<Dual>) -> Self {
        Real::powf(self, y.into())
    }

    /// x·π/180.
    pub fn to_radians(self) -> Self {
        self * (std::f64::consts::PI / 180.0)
    }

    /// x·180/π.
    pub fn to_degrees(self) -> Self {
        self * (180.0 / std::f64::consts::PI)
    }

    /// 1/x.
    pub fn recip(self) -> Self {
        Dual(self.0.recip())
    }

    /// Restricts the number to the interval between two bounds.
    pub fn clamp(self, low: impl Into<Dual>, high: impl Into<Dual>) -> Self {
        Real::min(Real::max(self, low.into()), high.into())
    }

    /// x·a + b.
    pub fn mul_add(self, a: Self, b: Self) -> Self {
        Dual(DualNum::mul_add(&self.0, a.0, b.0))
    }
}

impl From<f64> for Dual {
    fn from(x: f64) -> Self {
        Dual(Dual64::from_re(x))
    }
}

impl PartialEq for Dual {
    fn eq(&self, other: &Self) -> bool {
        self.value() == other.value() && self.derivative() == other.derivative()
    }
}

impl PartialOrd for Dual {
    /// Compares values: a point and its neighbours lie on the same side of a branch.
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value().partial_cmp(&other.value())
    }
}

arithmetic! { Dual:
    Add::add, AddAssign::add_assign = |a, b| Dual(a.0 + b.0);
    Sub::sub, SubAssign::sub_assign = |a, b| Dual(a.0 - b.0);
    Mul::mul, MulAssign::mul_assign = |a, b| Dual(a.0 * b.0);
    Div::div, DivAssign::div_assign = |a, b| Dual(a.0 / b.0);
}

impl core::ops::Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Dual(-self.0)
    }
}

macro_rules! forward {
    ($($function:ident),*) => { $(
        fn $function(self) -> Self {
            Dual(DualNum::$function(&self.0))
        }
    )* };
}

impl Real for Dual {
    compared!();
    fn from_f64(x: f64) -> Self {
        x.into()
    }
    fn magnitude(self) -> f64 {
        let (x, dx) = (self.value().abs(), self.derivative().abs());
        // Not `max`: that would lose a NaN.
        if x >= dx || x.is_nan() { x } else { dx }
    }
    fn any_below(self, bound: f64) -> bool {
        self.value() < bound
    }
    fn smallest() -> f64 {
        f64::MIN_POSITIVE
    }

    fn epsilon() -> f64 {
        f64::EPSILON
    }

    forward!(sqrt, cbrt, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh);
    forward!(exp, exp2, exp_m1, ln, ln_1p, log2, log10);

    fn hypot(self, y: Self) -> Self {
        (self * self + y * y).sqrt()
    }
    fn atan2(self, x: Self) -> Self {
        Dual(self.0.atan2(x.0))
    }
    fn powf(self, y: Self) -> Self {
        if y.derivative() == 0.0 { Dual(self.0.powf(y.value())) } else { Dual(self.0.powd(y.0)) }
    }
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { self }
    }
    fn min(self, y: Self) -> Self {
        if y.value() < self.value() { y } else { self }
    }
    fn max(self, y: Self) -> Self {
        if y.value() > self.value() { y } else { self }
    }
    fn signum(self) -> Self {
        self.value().signum().into()
    }
}
