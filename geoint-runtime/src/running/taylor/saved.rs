//! Saves and resumes a run with Taylor series.

use super::TaylorIntegrator;
use crate::method::Name;
use crate::running::saved::{Bits, Recorded};
use crate::space::{Record, Tape};
use crate::system::Jets;
use crate::taylor::TaylorMethod;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Bits> Recorded for TaylorIntegrator<S, M, R> {
    type Real = R;

    fn name(&self) -> Name {
        Name::new("Taylor")
    }

    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.steps.record(tape);
        self.reported.record(tape);
    }

    fn complete(&mut self) -> bool {
        self.steps.forget();
        self.steps.here().x.is_finite() && self.steps.time().magnitude() < f64::INFINITY
    }
}
