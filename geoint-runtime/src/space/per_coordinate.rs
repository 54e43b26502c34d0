//! A number for every coordinate of a point.

use super::array::Array;
use super::point::Point;
use super::state::Action;
use crate::scalar::Real;

/// A number for every coordinate: the point itself, its rates, increments, errors, sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerCoordinate<A, Z = ()> {
    /// Of positions.
    pub q: A,
    /// Of momenta.
    pub p: A,
    /// Of the action of a contact system.
    pub s: Z,
}

impl<A: Array, Z: Action<A::Real>> PerCoordinate<A, Z> {
    /// How many numbers there are.
    pub const LEN: usize = 2 * A::LEN + Z::LEN;

    /// All zeros.
    #[inline(always)]
    pub fn zero() -> Self {
        PerCoordinate { q: A::zero(), p: A::zero(), s: Z::zero() }
    }

    /// Zeros to which something is to be added; see [`Array::nothing`].
    #[inline(always)]
    pub fn nothing() -> Self {
        let mut s = Z::zero();
        for s in s.numbers_mut() {
            *s = -*s;
        }
        PerCoordinate { q: A::nothing(), p: A::nothing(), s }
    }

    /// The coordinates of a point.
    #[inline(always)]
    pub(crate) fn of<C>(x: &Point<A, C, Z>) -> Self {
        PerCoordinate { q: x.q, p: x.p, s: x.s }
    }

    /// The number of the coordinate `i`, in the order q, p, s.
    #[inline(always)]
    pub(crate) fn at(&self, i: usize) -> A::Real {
        let n = A::LEN;
        match i {
            _ if i < n => self.q.as_slice()[i],
            _ if i < 2 * n => self.p.as_slice()[i - n],
            _ => self.s.numbers()[i - 2 * n],
        }
    }

    /// All numbers in that order.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = A::Real> {
        (0..Self::LEN).map(|i| self.at(i))
    }

    /// All numbers to be written to.
    pub(crate) fn numbers_mut(&mut self) -> impl Iterator<Item = &mut A::Real> {
        let ends = self.q.as_mut_slice().iter_mut().chain(self.p.as_mut_slice());
        ends.chain(self.s.numbers_mut())
    }

    /// self ← self + w·x.
    pub(crate) fn add_scaled(&mut self, w: A::Real, x: &Self) {
        for (y, x) in self.numbers_mut().zip(x.numbers()) {
            *y = w.multiply_add(x, *y);
        }
    }

    /// Whether every number is finite.
    #[inline(always)]
    pub(crate) fn is_finite(&self) -> bool {
        self.q.is_finite() && self.p.is_finite() && self.s.is_finite()
    }
}
