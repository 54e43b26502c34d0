//! A run of steps of one length that is saved, and goes on.

use super::Integrator;
use crate::method::{Method, Name};
use crate::running::saved::{self, Bits, Recorded, ResumeError, Saved};
use crate::space::{Record, Summation, Tape};
use crate::system::PhaseSpace;

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Bits, C: Summation<S::Phase>> Integrator<S, M, R, C> {
    /// The run now, to go on from later: [`Saved`] says what it holds.
    ///
    /// ```
    /// use geoint_runtime::prelude::*;
    ///
    /// #[hamiltonian]
    /// fn pendulum(q: f64, p: f64, g: f64) -> f64 {
    ///     p * p / 2.0 - g * q.cos()
    /// }
    ///
    /// let start = || Pendulum { g: 9.81 }.integrator(DiscreteGradient, 0.01, State::new(1.0, 0.0));
    /// let mut sim = start();
    /// sim.advance(1000)?;
    /// let saved = sim.saved();
    /// sim.advance(1000)?;
    ///
    /// let mut other = start();
    /// other.resume(&saved).expect("the same method, and the same system");
    /// other.advance(1000)?;
    /// assert_eq!(other.state(), sim.state());
    /// # Ok::<(), StepError>(())
    /// ```
    pub fn saved(&self) -> Saved {
        saved::saved(self)
    }

    /// Goes on from what was saved of a run of the same system under the same method, with the same kind of sums. Time and the step size are
    /// those of that run.
    ///
    /// # Errors
    /// If this is another kind of run; nothing has changed then.
    pub fn resume(&mut self, saved: &Saved) -> Result<(), ResumeError> {
        saved::resume(self, saved)
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Bits, C: Summation<S::Phase>> Recorded for Integrator<S, M, R, C> {
    type Real = R;

    fn name(&self) -> Name {
        self.steps.method.name()
    }

    fn record(&mut self, tape: &mut impl Tape<R>) {
        let steps = &mut self.steps;
        steps.clock.record(tape);
        tape.steps(&mut steps.taken);
        tape.steps(&mut steps.given);
        tape.flag(&mut steps.inside);
        if M::KEEPS {
            tape.array(&mut steps.origin);
        }
        steps.x.record(tape);
        steps.memory.record(tape);
    }

    fn complete(&mut self) -> bool {
        let steps = &mut self.steps;
        steps.prepared = steps.method.prepare(&steps.system, steps.clock.step_size());
        steps.examine_if_outside();
        steps.x.is_finite() && steps.time().magnitude() < f64::INFINITY
    }
}
