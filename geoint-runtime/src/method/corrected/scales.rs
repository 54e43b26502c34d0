//! What distances of a projection are measured in.

use crate::scalar::Real;
use crate::solving::size::Sizes;
use crate::space::{Array, Record, Tape};

/// How large coordinates are, and how far steps have moved them lately.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales<A> {
    sizes: Sizes<A>,
    moved: Sizes<A>,
}

/// A coordinate that has moved is worth no more than what it moves by in so many steps: its distance from zero may mean nothing.
pub(super) const STEPS: f64 = 1024.0;

impl<A: Array> Scales<A> {
    pub(super) fn new() -> Self {
        Scales { sizes: Sizes::new(), moved: Sizes::new() }
    }

    #[inline]
    pub(super) fn include(&mut self, before: &A, moved: &A) {
        self.sizes.include(before, moved);
        self.moved.include(&A::zero(), moved);
    }

    /// What distances are measured in.
    #[inline]
    pub(super) fn units(&self) -> Sizes<A> {
        let mut units = self.sizes;
        for (unit, moved) in units.entries().iter_mut().zip(self.moved.as_slice()) {
            let reached = STEPS * moved.magnitude();
            if reached > 0.0 && reached < unit.magnitude() {
                *unit = A::Real::from_f64(reached);
            }
        }
        units
    }
}

impl<A: Array> Record<A::Real> for Scales<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.sizes.record(tape);
        self.moved.record(tape);
    }
}
