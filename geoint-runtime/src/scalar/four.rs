//! Four numbers side by side: one register of a processor, where it has such.

use super::real::Real;
use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Four numbers that go through the same operations. Each of them has the bits that it would have alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Four<R>(pub [R; 4]);

impl<R: Real> Add for Four<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Four(R::add_four(self.0, other.0))
    }
}

impl<R: Real> Sub for Four<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Four(R::subtract_four(self.0, other.0))
    }
}

impl<R: Real> Mul for Four<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Four(R::multiply_four(self.0, other.0))
    }
}

impl<R: Real> Div for Four<R> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Four(R::divide_four(self.0, other.0))
    }
}

impl<R: Real> Neg for Four<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Four(from_fn(|i| -self.0[i]))
    }
}

impl<R: Real> Four<R> {
    /// `self·a + b`, fused where [`Real::multiply_add`] is.
    #[inline(always)]
    pub fn multiply_add(self, a: Self, b: Self) -> Self {
        Four(R::multiply_add_four(self.0, a.0, b.0))
    }

    /// Square roots.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Four(R::sqrt_four(self.0))
    }
}
