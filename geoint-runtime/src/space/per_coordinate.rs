//! A number for every coordinate of a point.

use super::array::Array;
use super::record::{Record, Tape};
use super::state::Action;
use crate::scalar::Real;

/// A number for every coordinate: the point itself, its rates, increments, errors, sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerCoordinate<Z, S = ()> {
    /// Of all coordinates: [q, p], or x.
    pub z: Z,
    /// Of the action of a contact system.
    pub s: S,
}

impl<Z: Array, S: Action<Z::Real>> PerCoordinate<Z, S> {
    /// How many numbers there are.
    pub const LEN: usize = Z::LEN + S::LEN;

    /// All zeros.
    #[inline(always)]
    pub fn zero() -> Self {
        PerCoordinate { z: Z::zero(), s: S::zero() }
    }

    /// Zeros to which something is to be added; see [`Array::nothing`].
    #[inline(always)]
    pub fn nothing() -> Self {
        let mut s = S::zero();
        for s in s.numbers_mut() {
            *s = -*s;
        }
        PerCoordinate { z: Z::nothing(), s }
    }

    /// The number of the coordinate `i`, the action last.
    #[inline(always)]
    pub(crate) fn at(&self, i: usize) -> Z::Real {
        if i < Z::LEN { self.z.as_slice()[i] } else { self.s.numbers()[i - Z::LEN] }
    }

    /// All numbers in that order.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = Z::Real> {
        (0..Self::LEN).map(|i| self.at(i))
    }

    /// All numbers to be written to.
    pub(crate) fn numbers_mut(&mut self) -> impl Iterator<Item = &mut Z::Real> {
        self.z.as_mut_slice().iter_mut().chain(self.s.numbers_mut())
    }

    /// self ← self + w·x.
    #[inline(always)]
    pub(crate) fn add_scaled(&mut self, w: Z::Real, x: &Self) {
        self.z.add_scaled(w, &x.z);
        for (y, x) in self.s.numbers_mut().iter_mut().zip(x.s.numbers()) {
            *y = w.multiply_add(*x, *y);
        }
    }

    /// self ← w·self.
    #[inline(always)]
    pub(crate) fn times(&mut self, w: Z::Real) {
        // Loops of a known length each, which become registers: one over both goes through memory.
        for x in self.z.as_mut_slice() {
            *x *= w;
        }
        for s in self.s.numbers_mut() {
            *s *= w;
        }
    }

    /// Whether every number is finite.
    #[inline(always)]
    pub(crate) fn is_finite(&self) -> bool {
        self.z.is_finite() && self.s.is_finite()
    }
}

impl<Z: Array, S: Action<Z::Real>> Record<Z::Real> for PerCoordinate<Z, S> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        tape.array(&mut self.z);
        self.s.numbers_mut().iter_mut().for_each(|s| tape.scalar(s));
    }
}
