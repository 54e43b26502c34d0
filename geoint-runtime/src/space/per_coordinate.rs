//! One number for each coordinate of a point.

use super::array::Array;
use super::record::{Record, Tape};
use super::state::Action;
use crate::scalar::Real;

/// One number for each coordinate, for example the point itself, its rates, increments, errors or sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerCoordinate<Z, S = ()> {
    /// The numbers of the coordinates [q, p], or x.
    pub z: Z,
    /// The number of the action of a contact system.
    pub s: S,
}

impl<Z: Array, S: Action<Z::Real>> PerCoordinate<Z, S> {
    /// The number of entries.
    pub const LEN: usize = Z::LEN + S::LEN;

    /// Returns zeros.
    #[inline(always)]
    pub fn zero() -> Self {
        PerCoordinate { z: Z::zero(), s: S::zero() }
    }

    /// Returns −0 in all entries, as the start of a sum; see [`Array::nothing`].
    #[inline(always)]
    pub fn nothing() -> Self {
        let mut s = S::zero();
        for s in s.numbers_mut() {
            *s = -*s;
        }
        PerCoordinate { z: Z::nothing(), s }
    }

    /// Returns the entry of the coordinate `i`. The action is the last one.
    #[inline(always)]
    pub(crate) fn at(&self, i: usize) -> Z::Real {
        if i < Z::LEN { self.z.as_slice()[i] } else { self.s.numbers()[i - Z::LEN] }
    }

    /// Returns all entries in the order of [`at`](PerCoordinate::at).
    pub(crate) fn numbers(&self) -> impl Iterator<Item = Z::Real> {
        (0..Self::LEN).map(|i| self.at(i))
    }

    /// Returns all entries, mutably.
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
        // Two loops of known length stay in registers. One loop over both parts would not.
        for x in self.z.as_mut_slice() {
            *x *= w;
        }
        for s in self.s.numbers_mut() {
            *s *= w;
        }
    }

    /// Returns whether all entries are finite.
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
