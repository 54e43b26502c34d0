//! Numbers side by side: one of each orbit, so that the processor works on all orbits at a time.

use crate::scalar::Real;
use core::array::from_fn;
use core::ops::{Add, Mul, Neg, Sub};

/// A number of each of N orbits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lanes<R, const N: usize>(pub(super) [R; N]);

macro_rules! elementwise {
    ($($operator:ident $name:ident),*) => { $(
        impl<R: Real, const N: usize> $operator for Lanes<R, N> {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Lanes(from_fn(|i| $operator::$name(self.0[i], other.0[i])))
            }
        }
    )* };
}

elementwise!(Add add, Sub sub, Mul mul);

impl<R: Real, const N: usize> Neg for Lanes<R, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Lanes(self.0.map(|x| -x))
    }
}

impl<R: Real, const N: usize> Lanes<R, N> {
    /// The same number for all.
    #[inline(always)]
    pub(super) fn all(x: f64) -> Self {
        Lanes([R::from_f64(x); N])
    }

    /// self·a + b.
    #[inline(always)]
    pub(super) fn multiply_add(self, a: Self, b: Self) -> Self {
        Lanes(from_fn(|i| self.0[i].multiply_add(a.0[i], b.0[i])))
    }

    /// c·self for a plain number.
    #[inline(always)]
    pub(super) fn times(self, c: f64) -> Self {
        self * Lanes::all(c)
    }

    /// 1/self.
    #[inline(always)]
    pub(super) fn recip(self) -> Self {
        Lanes(self.0.map(|x| R::from_f64(1.0) / x))
    }

    /// Σ cₖ selfᵏ by Horner's rule.
    #[inline(always)]
    pub(super) fn polynomial<const K: usize>(self, c: &[f64; K]) -> Self {
        c[..K - 1].iter().rev().fold(Lanes::all(c[K - 1]), |sum, c| sum.multiply_add(self, Lanes::all(*c)))
    }
}
