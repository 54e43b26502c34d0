//! Takes a step: trial steps of shorter and shorter length, until one is accepted.
//!
//! The error of a step is the estimate of the method, or the difference between one whole step and two halves; see `attempt.rs`.

use super::attempt::{Attempt, Prepared, Trial, no_history};
use super::steps::{Controlled, Past};
use super::way::InformativeSteps;
use crate::method::{Method, Unwatched};
use crate::running::error::StepError;
use crate::running::settle::{STEPS_BETWEEN_CHECKS, has_drift, without_drift};
use crate::running::tolerance::REACH;
use crate::running::watch::Watch;
use crate::scalar::{Real, signed, zero};
use crate::solving::Failure;
use crate::space::{DoubleWord, PerCoordinate};
use crate::system::{PhaseSpace, Rates};

/// The shortest step is often at the resolution of time, where rounding hides the edge of a domain. A step of this many times its length finds the edge.
const EDGE_SEARCH: f64 = 16.0;

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Real> Controlled<S, M, R> {
    /// Takes a step that is not longer than `left`.
    ///
    /// A trial step is refused if it has no result, if its error exceeds the tolerance, if [`is_trusted`](Self::is_trusted) does not trust its error, or if it
    /// passes a pole in time. It is then repeated with a shorter length, down to the shortest one.
    pub(super) fn take(&mut self, left: f64) -> Result<(), StepError> {
        let t = signed(self.now());
        let bounds = self.bounds.at(t, R::epsilon(), self.controller.pace);
        if self.taken == self.given {
            self.tolerate_causes(left.min(bounds.longest));
        }
        loop {
            let regular = self.controller.step(&bounds);
            let h = if regular.abs() < left { regular } else { left.copysign(regular) };
            if h == regular && h != self.prepared.h {
                self.prepared.prepare(&self.system, &self.method, h);
                self.memory = no_history::<S, M, R>(&self.x.z);
            }
            let shorter;
            let prepared = if h == regular {
                &self.prepared
            } else {
                shorter = Prepared::new(&self.system, &self.method, h);
                &shorter
            };
            let mut history = self.history_for(h, regular);
            let mut trial = self.trial(prepared, &mut history, regular, bounds.shortest);
            let accepted = trial.as_ref().ok().filter(|trial| trial.error <= 1.0);
            let way = accepted.map(|trial| [self.now(), self.attempt().end(h, &trial.x)]);
            let pole = way.and_then(|way| self.clear.pole(&self.system, way));
            if let Some(what) = pole {
                trial = Err(Failure::OutsideDomain { what });
            }
            match trial {
                Ok(trial) if trial.error <= 1.0 => {
                    if h == regular {
                        self.memory = history;
                        self.controller.accept(h, trial.error);
                    }
                    self.accept(h, trial);
                    return Ok(());
                }
                refused => {
                    self.rejections += 1;
                    self.controller.reject(h, refused.as_ref().ok().map(|trial| trial.error));
                    if h.abs() <= bounds.shortest {
                        let failure = match refused {
                            Err(failure) if pole.is_some() => failure,
                            refused => self.failure_of_shortest(h, refused.err()),
                        };
                        return Err(StepError::of_shortest(failure, t, h));
                    }
                }
            }
        }
    }

    /// Returns the start of a trial step, with the data that judge its error.
    fn attempt(&self) -> Attempt<'_, S, R> {
        let Self { system, clock, x, tolerance, part, time_of_start, .. } = self;
        let keeps = self.method.claims().conserves_energy;
        Attempt { system, t: self.now(), clock, x, tolerance, part: *part, time_of_start: *time_of_start, keeps }
    }

    /// Returns the history before a trial step of length `h`. A step of another length than the `regular` one neither uses nor changes the history of the run.
    fn history_for(&self, h: f64, regular: f64) -> [M::Memory; 2] {
        if h == regular { self.memory.clone() } else { no_history::<S, M, R>(&self.x.z) }
    }

    /// Takes a trial step from the present point. Its error is infinite if it is not trusted. `regular` is the length that the controller has chosen.
    #[inline(always)]
    fn trial(
        &self,
        prepared: &Prepared<M::Prepared>,
        history: &mut [M::Memory; 2],
        regular: f64,
        shortest: f64,
    ) -> Result<Trial<S, R>, Failure> {
        let attempt = self.attempt();
        let mut trial = attempt.take(&self.method, prepared, history, &mut Unwatched);
        // Only a step with checks uses the slower search for a solution and resolves `needs_recheck`, which arrives here as `NotConverged`.
        if matches!(trial, Err(Failure::NotConverged { .. })) {
            let mut watch = Watch::new(&self.system, attempt.t, &self.x);
            *history = self.history_for(prepared.h, regular);
            trial = attempt.take(&self.method, prepared, history, &mut watch);
        }
        let mut trial = trial?;
        if trial.error <= 1.0_f64 && !self.is_trusted(&attempt, &trial, prepared.h, regular, shortest) {
            trial.error = f64::INFINITY;
        }
        Ok(trial)
    }

    /// Returns whether the error of a trial step of length `h` counts: the step is short enough for coordinates that leave rest, and samples of the field between
    /// its ends show no force that it has missed. Steps like earlier informative ones are not sampled.
    #[inline(always)]
    fn is_trusted(
        &self,
        attempt: &Attempt<'_, S, R>,
        Trial { x, error, .. }: &Trial<S, R>,
        h: f64,
        regular: f64,
        shortest: f64,
    ) -> bool {
        // At the onset of a force, no step is short against the time in which the force grows. Steps up to √ε |t| may therefore pass over it.
        let onset = shortest.max(Real::sqrt(R::epsilon()) * signed(attempt.t).abs());
        let growth = attempt.growth_from_rest(h, x);
        if growth == Some(false) && h.abs() > onset {
            return false;
        }
        let informative = InformativeSteps::is_informative::<R>(*error, self.tolerance.relative);
        // Growth like a power of time has already been checked.
        if growth == Some(true) || h.abs() <= shortest || self.informative_steps.covers(h, informative) {
            return true;
        }
        let least = match self.taken == self.given {
            true => InformativeSteps::least_points_at_first(h / regular),
            false => InformativeSteps::least_points(informative, h / regular),
        };
        !attempt.misses_force(h, least, x)
    }

    /// Continues from the end of a trial step.
    #[inline(always)]
    fn accept(&mut self, h: f64, Trial { x, error }: Trial<S, R>) {
        self.informative_steps.include(h, InformativeSteps::is_informative::<R>(error, self.tolerance.relative));
        self.past = Some(Past { clock: self.clock, x: self.x });
        self.clock.pass_step(R::from_f64(h), x.ahead);
        let (part, ends) = (self.part, [&self.x, &x].map(PerCoordinate::of));
        let (system, t) = (&self.system, self.clock.now(zero()));
        self.tolerance.include(ends.each_ref(), h, part, |x| system.rates(t, x));
        self.x = x;
        self.x.ahead = DoubleWord::new(zero());
        self.taken += 1;
        if const { has_drift::<S, M, R>() } && self.taken.is_multiple_of(STEPS_BETWEEN_CHECKS) {
            self.remove_drift();
        }
    }

    /// At the start: tolerates, in each coordinate, the errors that tolerated errors of other coordinates cause until the state changes or a step of length
    /// `most` ends. A coordinate at rest then does not force tiny steps.
    #[cold]
    fn tolerate_causes(&mut self, most: f64) {
        // No time of change is known for a state at rest.
        if !self.time_of_start.is_finite() {
            return;
        }
        let (system, t, x) = (&self.system, self.now(), PerCoordinate::of(&self.x));
        let time = (REACH * self.time_of_start).min(most / self.part);
        self.tolerance.changes_in(time, &x, |x| system.rates(t, x));
    }

    /// Returns why the shortest step was refused. At the edge of a domain, the shortest step may find no solution where a step of [`EDGE_SEARCH`] times its
    /// length finds the edge.
    ///
    /// If the step succeeds without the history of earlier steps, the history caused the failure. The result is then the first reason, `refused`.
    #[cold]
    fn failure_of_shortest(&self, h: f64, refused: Option<Failure>) -> Failure {
        match self.attempt().failure(&self.method, h) {
            Failure::Inaccurate { error } if error <= 1.0 => refused.unwrap_or(Failure::Inaccurate { error }),
            Failure::NotConverged { .. } | Failure::Singular => self.attempt().failure(&self.method, EDGE_SEARCH * h),
            failure => failure,
        }
    }

    /// Removes the drift by rounding over many steps, if the corrected point is in the domain.
    #[cold]
    #[inline(never)]
    fn remove_drift(&mut self) {
        let x = without_drift::<S, M, R, _>((&self.system, &self.prepared.whole), &self.origin, &self.x);
        if self.attempt().check(zero(), &x).is_ok() {
            self.x = x;
        }
    }
}
