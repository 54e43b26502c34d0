//! Saves and resumes a run with adaptive step size.

use super::Adaptive;
use super::attempt::Prepared;
use super::steps::Steps;
use crate::method::{Method, Name};
use crate::running::saved::{Bits, Recorded};
use crate::space::{Record, Tape};
use crate::system::{PhaseSpace, Rates};

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Bits> Recorded for Adaptive<S, M, R> {
    type Real = R;

    fn name(&self) -> Name {
        self.steps.method.name()
    }

    fn record(&mut self, tape: &mut impl Tape<R>) {
        let steps = &mut self.steps;
        steps.clock.record(tape);
        tape.steps(&mut steps.taken);
        tape.steps(&mut steps.given);
        tape.steps(&mut steps.rejections);
        if M::KEEPS {
            tape.array(&mut steps.origin);
        }
        steps.x.record(tape);
        steps.tolerance.record(tape);
        steps.controller.record(tape);
        tape.number(&mut steps.prepared.h);
        steps.informative_steps.record(tape);
        steps.memory.record(tape);
        self.reported.record(tape);
    }

    fn complete(&mut self) -> bool {
        let Steps { system, method, prepared, .. } = &mut self.steps;
        *prepared = Prepared::new(system, method, prepared.h);
        // The state may come from elsewhere: if it is outside the domain, the next step must check it like a given state.
        let steps = &mut self.steps;
        if steps.system.outside_domain(steps.time(), &steps.x.z, &steps.x.s).is_some() {
            steps.given = steps.taken;
        }
        self.steps.x.is_finite() && self.time().magnitude() < f64::INFINITY
    }
}
