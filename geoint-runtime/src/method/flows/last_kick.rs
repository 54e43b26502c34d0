//! The last kick of a step. If its positions are those at which the next step begins, the next step reuses its impulse.

use super::open::Open;
use crate::space::{Action, Array, Record, Tape};

/// The last kick of a step.
#[derive(Clone, Copy, Debug)]
pub struct LastKick<A> {
    /// False before the first kick.
    pub(super) known: bool,
    /// The positions of the kick.
    pub(super) q: A,
    /// The increment of the momenta.
    pub(super) impulse: A,
}

impl<A: Array> LastKick<A> {
    /// Returns the value before the first kick.
    pub(super) fn unknown() -> Self {
        LastKick { known: false, q: A::zero(), impulse: A::zero() }
    }

    /// Returns the impulse of the last kick, if it was at the positions `q`.
    #[inline(always)]
    pub(super) fn impulse_at(&self, q: &A) -> Option<A> {
        (self.known & self.q.is_same(q)).then_some(self.impulse)
    }
}

impl<A: Array> Record<A::Real> for LastKick<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        tape.flag(&mut self.known);
        tape.array(&mut self.q);
        tape.array(&mut self.impulse);
    }
}

/// History of a table with an error estimate. Plain steps use `open`, steps with an estimate use `kick`.
#[derive(Clone, Copy, Debug)]
pub struct History<A: Array, S> {
    pub(super) open: Open<[A; 2], S>,
    pub(super) kick: LastKick<A>,
}

impl<A: Array, S: Action<A::Real>> Record<A::Real> for History<A, S> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.open.record(tape);
        self.kick.record(tape);
    }
}
