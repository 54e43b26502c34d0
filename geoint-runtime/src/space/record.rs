//! What a run hands on from step to step, number by number: the same order for writing down and for reading back.

use super::array::Array;
use crate::scalar::Real;

/// A number of steps that no run reaches, though others may be added to it.
pub(crate) const NEVER: u64 = 1 << 62;

/// Writes the numbers down that it is shown, or puts those in their place that were written down.
pub trait Tape<R> {
    /// The next scalar.
    fn scalar(&mut self, x: &mut R);
    /// The next whole number.
    fn count(&mut self, n: &mut u64);

    /// The next number that is a plain one whatever the scalar is.
    fn number(&mut self, x: &mut f64) {
        let mut bits = x.to_bits();
        self.count(&mut bits);
        *x = f64::from_bits(bits);
    }

    /// The next answer.
    fn flag(&mut self, yes: &mut bool) {
        let mut n = u64::from(*yes);
        self.count(&mut n);
        *yes = n != 0;
    }

    /// The next number of steps: of what is read it is at most one that no run reaches.
    fn steps(&mut self, n: &mut u64) {
        self.count(n);
        *n = (*n).min(NEVER);
    }

    /// What may be missing; where it was there and is not, `blank` takes its place first.
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

    /// All scalars of an array.
    fn array<A: Array<Real = R>>(&mut self, array: &mut A)
    where
        Self: Sized,
    {
        array.as_mut_slice().iter_mut().for_each(|x| self.scalar(x));
    }
}

/// What is shown to a tape: always all of it, in the same order.
pub trait Record<R> {
    /// Shows every number.
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
