//! A run of steps that adapt that is saved, and goes on.

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
        steps.told.record(tape);
        steps.memory.record(tape);
        self.reported.record(tape);
    }

    fn complete(&mut self) -> bool {
        let Steps { system, method, prepared, .. } = &mut self.steps;
        *prepared = Prepared::new(system, method, prepared.h);
        // To which no step has led: the next one examines it, whatever the number of steps says.
        let steps = &mut self.steps;
        if steps.system.outside_domain(steps.time(), &steps.x.z, &steps.x.s).is_some() {
            steps.given = steps.taken;
        }
        self.steps.x.is_finite() && self.time().magnitude() < f64::INFINITY
    }
}
