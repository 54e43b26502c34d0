//! A run of steps by Taylor series that is saved, and goes on.

use super::TaylorIntegrator;
use crate::method::Name;
use crate::running::saved::{self, Bits, Recorded, ResumeError, Saved};
use crate::space::Tape;
use crate::system::Jets;
use crate::taylor::TaylorMethod;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Bits> TaylorIntegrator<S, M, R> {
    /// The run now, to go on from later: [`Saved`] says what it holds.
    pub fn saved(&self) -> Saved {
        saved::saved(self)
    }

    /// Goes on from what was saved of a run of the same system. Order, tolerance and bounds are those of this run. It knows no last step to
    /// look into.
    ///
    /// # Errors
    /// If this is another kind of run; nothing has changed then.
    pub fn resume(&mut self, saved: &Saved) -> Result<(), ResumeError> {
        saved::resume(self, saved)
    }
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Bits> Recorded for TaylorIntegrator<S, M, R> {
    type Real = R;

    fn name(&self) -> Name {
        Name::new("Taylor")
    }

    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.steps.record(tape);
    }

    fn complete(&mut self) -> bool {
        self.steps.forget();
        self.steps.here().x.is_finite() && self.steps.time().magnitude() < f64::INFINITY
    }
}
