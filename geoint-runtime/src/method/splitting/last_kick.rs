//! What a step may take over from the one before: steps end with the kick that the next ones begin with.

use crate::method::open::Open;
use crate::space::{Action, Array, Record, Tape};

/// The kick that ended a step: where, and what it added to the momenta.
#[derive(Clone, Copy, Debug)]
pub struct LastKick<A> {
    pub(super) known: bool,
    pub(super) q: A,
    pub(super) impulse: A,
}

impl<A: Array> LastKick<A> {
    /// There was none yet.
    pub(super) fn unknown() -> Self {
        LastKick { known: false, q: A::zero(), impulse: A::zero() }
    }

    /// Whether there was one from this place.
    #[inline(always)]
    pub(super) fn is_from(&self, q: &A) -> bool {
        self.known & self.q.is_same(q)
    }
}

impl<A: Array> Record<A::Real> for LastKick<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        tape.flag(&mut self.known);
        tape.array(&mut self.q);
        tape.array(&mut self.impulse);
    }
}

/// What a table with an estimate of its errors hands on: plain steps what they leave open, steps that tell their kicks the last one.
#[derive(Clone, Copy, Debug)]
pub struct Told<A: Array, S> {
    pub(super) open: Open<[A; 2], S>,
    pub(super) kick: LastKick<A>,
}

impl<A: Array, S: Action<A::Real>> Record<A::Real> for Told<A, S> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.open.record(tape);
        self.kick.record(tape);
    }
}
