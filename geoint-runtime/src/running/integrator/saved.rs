//! Saves and resumes a run with fixed step size.

use super::Integrator;
use crate::method::{Method, Name};
use crate::running::saved::{Bits, Recorded};
use crate::space::{Record, Summation, Tape};
use crate::system::PhaseSpace;

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
        tape.steps(&mut steps.set);
        tape.flag(&mut steps.inside);
        if M::KEEPS {
            tape.array(&mut steps.origin);
        }
        steps.x.record(tape);
        steps.memory.record(tape);
        self.reported.record(tape);
    }

    fn complete(&mut self) -> bool {
        let steps = &mut self.steps;
        steps.prepared = steps.method.prepare(&steps.system, steps.clock.step_size());
        steps.examine_if_outside();
        steps.x.is_finite() && steps.time().magnitude() < f64::INFINITY
    }
}
