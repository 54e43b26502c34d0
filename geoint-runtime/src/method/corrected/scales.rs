//! The units in which a projection measures distances.

use crate::scalar::Real;
use crate::solving::size::Sizes;
use crate::space::{Array, Record, Tape};

/// The size of each coordinate, and the length of its increments: maxima that halve in 44 steps, or those of a single path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales<A> {
    sizes: Sizes<A>,
    moved: Sizes<A>,
}

/// The unit of a coordinate that moves is at most its increment times this number of steps, unless rounding explains more. Otherwise an angle of 10⁵ turns would
/// take the whole correction.
const STEPS: f64 = 1024.0;

/// A change of an invariant by at most this many ε of its terms counts as rounding of its coordinates: one evaluation rounds a few times. The number is empirical.
const EXPLAINED_ROUNDINGS: f64 = 16.0;

impl<A: Array> Scales<A> {
    pub(super) fn new() -> Self {
        Scales { sizes: Sizes::new(), moved: Sizes::new() }
    }

    /// Returns the scales of a single increment `moved` between points of these `sizes`.
    pub(super) fn along(sizes: Sizes<A>, moved: &A) -> Self {
        Scales { sizes, moved: Sizes::at(moved) }
    }

    #[inline]
    pub(super) fn include(&mut self, before: &A, moved: &A) {
        self.sizes.include(before, moved);
        self.moved.include(&A::zero(), moved);
    }

    /// Returns the units for a correction: the size of each coordinate, or less for a coordinate that hardly moves. A coordinate that has not moved keeps
    /// its size as unit.
    ///
    /// `explained` returns for each coordinate the part of the correction that rounding explains, from 0 to 1. The unit is at least this part of the size:
    /// a coordinate takes a correction within its own rounding. With a tiny unit, the correction would move the other coordinates, even those on which the
    /// invariant hardly depends.
    #[inline]
    pub(super) fn units(&self, explained: impl FnOnce() -> A) -> Sizes<A> {
        let reached = |i: usize| STEPS * self.moved.of(i);
        let is_slow = |i: &usize| reached(*i) > 0.0 && reached(*i) < self.sizes.of(*i);
        let mut units = self.sizes;
        if (0..A::LEN).any(|i| is_slow(&i)) {
            let explained = explained();
            for i in (0..A::LEN).filter(is_slow) {
                let least = explained.as_slice()[i].magnitude() * self.sizes.of(i);
                units.entries()[i] = A::Real::from_f64(reached(i).max(least));
            }
        }
        units
    }
}

/// Returns the part of its terms by which rounding of coordinates may change an invariant, with room for several operations.
pub(super) fn rounding<R: Real>() -> f64 {
    EXPLAINED_ROUNDINGS * R::epsilon()
}

/// Returns the part of a change that rounding explains, where ε times `terms` is the rounding of one evaluation.
pub(super) fn part_of_rounding<R: Real>(change: R, terms: f64) -> f64 {
    let limit = rounding::<R>() * terms;
    // Zero if the change is NaN.
    if change.magnitude() <= limit { 1.0 } else { (limit / change.magnitude()).max(0.0) }
}

impl<A: Array> Record<A::Real> for Scales<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.sizes.record(tape);
        self.moved.record(tape);
    }
}
