//! Saving and restoring of the data that a run passes from step to step. One function defines the order of the numbers for both directions.

use super::array::Array;
use crate::scalar::Real;

/// A number of steps that no run reaches. Sums with other numbers of steps do not overflow.
pub(crate) const NEVER: u64 = 1 << 62;

/// A record of numbers. Each call either saves its argument, or replaces it by the saved number.
pub trait Tape<R> {
    /// Saves or restores a scalar.
    fn scalar(&mut self, x: &mut R);
    /// Saves or restores an integer.
    fn count(&mut self, n: &mut u64);

    /// Saves or restores an `f64`, which does not depend on the type of the scalar.
    fn number(&mut self, x: &mut f64) {
        let mut bits = x.to_bits();
        self.count(&mut bits);
        *x = f64::from_bits(bits);
    }

    /// Saves or restores a boolean.
    fn flag(&mut self, yes: &mut bool) {
        let mut n = u64::from(*yes);
        self.count(&mut n);
        *yes = n != 0;
    }

    /// Saves or restores a number of steps, limited to 2⁶², so that a damaged record cannot overflow later sums.
    fn steps(&mut self, n: &mut u64) {
        self.count(n);
        *n = (*n).min(NEVER);
    }

    /// Saves or restores an optional value. If a value was saved and `slot` is empty, `blank` first creates a value.
    fn option<T: Record<R>>(&mut self, slot: &mut Option<T>, blank: impl FnOnce() -> T)
    where
        Self: Sized,
    {
        let mut there = slot.is_some();
        self.flag(&mut there);
        *slot = if there { Some(slot.take().unwrap_or_else(blank)) } else { None };
        if let Some(value) = slot {
            value.record(self);
        }
    }

    /// Saves or restores all scalars of an array.
    fn array<A: Array<Real = R>>(&mut self, array: &mut A)
    where
        Self: Sized,
    {
        array.as_mut_slice().iter_mut().for_each(|x| self.scalar(x));
    }
}

/// Data that a [`Tape`] can save and restore.
pub trait Record<R> {
    /// Passes all numbers to the tape, always in the same order.
    fn record(&mut self, tape: &mut impl Tape<R>);
}

impl<R> Record<R> for () {
    fn record(&mut self, _: &mut impl Tape<R>) {}
}

impl<R: Real> Record<R> for R {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        tape.scalar(self);
    }
}

impl<R, T: Record<R>, const N: usize> Record<R> for [T; N] {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.iter_mut().for_each(|part| part.record(tape));
    }
}
