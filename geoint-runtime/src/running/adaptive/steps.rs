//! Chooses the length of the next step, takes it, and updates the step size control.

use super::attempt::{Attempt, Carried, Prepared};
use super::start;
use super::way::InformativeSteps;
use crate::method::{Clock, Method, Unwatched};
use crate::running::error::{StepError, check_parameters, not_finite};
use crate::running::settle::{STEPS_BETWEEN_CHECKS, has_drift, without_drift};
use crate::running::step_size::{Bounds, Controller};
use crate::running::tolerance::{REACH, Tolerance};
use crate::running::watch::Watch;
use crate::scalar::{Real, signed, zero};
use crate::solving::Failure;
use crate::space::{DoubleWord, PerCoordinate, Snapshot, wrong_length};
use crate::system::{Clear, PhaseSpace, Rates};

/// The pace of steps whose lengths adapt to a tolerance: a system under a method, and all data that determine the next step.
#[derive(Clone)]
pub struct Controlled<S: PhaseSpace<R>, M: Method<S, R>, R: Real> {
    pub(super) system: S,
    pub(super) method: M,
    pub(super) tolerance: Tolerance<S::Phase, S::Action>,
    pub(super) bounds: Bounds,
    pub(super) controller: Controller,
    /// Expected step length divided by the time in which the state changes.
    part: f64,
    pub(super) prepared: Prepared<M::Prepared>,
    /// History of the method: for whole steps, and for their halves.
    pub(super) memory: [M::Memory; 2],
    pub(super) clock: Clock<R>,
    /// State at the start of the run. The steps conserve its invariants.
    pub(super) origin: S::Phase,
    pub(super) x: Carried<S, R>,
    pub(super) taken: u64,
    /// Value of `taken` when the user gave the state.
    pub(super) given: u64,
    pub(super) rejections: u64,
    /// Interval of time without poles, found so far.
    clear: Clear<R>,
    /// Time in which the state changes at the start of the run.
    time_of_start: f64,
    /// Recent steps whose errors are informative.
    pub(super) informative_steps: InformativeSteps,
}

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Real> Controlled<S, M, R> {
    pub(super) fn new((system, method): (S, M), tolerance: f64, t: R, x: Carried<S, R>) -> Self {
        let claims = method.claims();
        let controller = Controller::new(method.order_of_estimate().unwrap_or(claims.order));
        let mut steps = Controlled {
            system,
            method,
            tolerance: Tolerance::new(tolerance, !claims.perturbed.is_empty()),
            bounds: Bounds::default(),
            controller,
            part: controller.part(tolerance),
            prepared: Prepared::new(&system, &method, 1.0),
            memory: [M::memory(), M::memory()],
            clock: Clock::new(t, zero()),
            origin: x.z,
            x,
            taken: 0,
            given: 0,
            rejections: 0,
            clear: Clear::unknown(),
            time_of_start: 0.0,
            informative_steps: InformativeSteps::default(),
        };
        steps.start();
        steps
    }

    /// Sets the first step length from the time in which the state changes.
    fn start(&mut self) {
        let (system, t, x) = (&self.system, self.now(), PerCoordinate::of(&self.x));
        self.tolerance.start(&x);
        let time = start::time(system, t, &x, &self.tolerance.sizes);
        self.controller.start(time, self.tolerance.relative);
        self.time_of_start = time;
    }

    /// Continues from another point.
    pub(super) fn continue_from(&mut self, t: R, x: Carried<S, R>) {
        (self.clock, self.x, self.memory) = (Clock::new(t, zero()), x, [M::memory(), M::memory()]);
        (self.given, self.origin, self.informative_steps) = (self.taken, self.x.z, InformativeSteps::default());
        let backwards = self.size() < 0.0;
        self.start();
        self.controller.turn(backwards);
    }

    /// Continues from the present point with another system.
    pub(super) fn replace_system(&mut self, system: S) {
        (self.system, self.prepared, self.clear) =
            (system, Prepared::new(&system, &self.method, 1.0), Clear::unknown());
        let clock = self.clock;
        self.continue_from(self.now(), self.x);
        self.clock = clock;
    }

    pub(super) fn now(&self) -> R {
        self.clock.now(zero())
    }

    /// Returns the length of the next step, as the controller and the bounds set it.
    pub(super) fn size(&self) -> f64 {
        self.controller.step(&self.bounds.at(signed(self.now()), R::epsilon(), self.controller.pace))
    }

    /// Returns a trial step from the present point.
    fn attempt(&self) -> Attempt<'_, S, R> {
        let Self { system, clock, x, tolerance, part, time_of_start, .. } = self;
        let keeps = self.method.claims().conserves_energy;
        Attempt { system, t: self.now(), clock, x, tolerance, part: *part, time_of_start: *time_of_start, keeps }
    }

    /// Takes a step that is not longer than `left`.
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
                self.memory = [M::memory(), M::memory()];
            }
            let shorter;
            let prepared = if h == regular {
                &self.prepared
            } else {
                shorter = Prepared::new(&self.system, &self.method, h);
                &shorter
            };
            // A step of another length neither uses nor changes the history.
            let before = || if h == regular { self.memory.clone() } else { [M::memory(), M::memory()] };
            let mut memory = before();
            let attempt = self.attempt();
            let mut outcome = attempt.take(&self.method, prepared, &mut memory, &mut Unwatched);
            // Only a step with checks uses the slower search for a solution and resolves `needs_recheck`.
            if matches!(outcome, Err(Failure::NotConverged { .. })) {
                memory = before();
                let mut watch = Watch::new(&self.system, attempt.t, &self.x);
                outcome = attempt.take(&self.method, prepared, &mut memory, &mut watch);
            }
            if let Ok((x, error)) = &mut outcome
                && *error <= 1.0
            {
                // At the onset of a force, no step is short against the time in which the force grows. A step near the resolution of time must pass
                // over the onset.
                let onset = bounds.shortest.max(Real::sqrt(R::epsilon()) * t.abs());
                let growth = attempt.growth_from_rest(h, x);
                let too_long_from_rest = growth == Some(false) && h.abs() > onset;
                let informative = InformativeSteps::is_informative::<R>(*error, self.tolerance.relative);
                // Growth like a power of time has already been checked.
                let needs_check =
                    growth != Some(true) && h.abs() > bounds.shortest && !self.informative_steps.covers(h, informative);
                let least = match self.taken == self.given {
                    true => InformativeSteps::least_points_at_first(h / regular),
                    false => InformativeSteps::least_points(informative, h / regular),
                };
                if too_long_from_rest || needs_check && attempt.misses_force(h, least, x) {
                    *error = f64::INFINITY;
                }
            }
            let passed = match &outcome {
                Ok((x, error)) if *error <= 1.0 => {
                    let way = [attempt.t, attempt.end(h, x)];
                    self.clear.pole(&self.system, way)
                }
                _ => None,
            };
            if let Some(what) = passed {
                outcome = Err(Failure::OutsideDomain { what });
            }
            let (x, error) = match outcome {
                Ok((x, error)) if error <= 1.0 => (x, error),
                outcome => {
                    self.rejections += 1;
                    let refused = outcome.as_ref().err().copied();
                    self.controller.reject(h, outcome.map_or(None, |(_, error)| Some(error)));
                    if h.abs() <= bounds.shortest {
                        let outside = passed.map(|what| Failure::OutsideDomain { what });
                        let failure = outside.unwrap_or_else(|| self.failure_of_shortest(h, refused));
                        return Err(StepError::of_shortest(failure, t, h));
                    }
                    continue;
                }
            };
            if h == regular {
                self.memory = memory;
                self.controller.accept(h, error);
            }
            self.informative_steps.include(h, InformativeSteps::is_informative::<R>(error, self.tolerance.relative));
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
            return Ok(());
        }
    }

    /// At the start: accounts for the errors that tolerated errors cause in other coordinates, until the state changes or a step of length `most`
    /// ends.
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

    /// Returns why the shortest step was refused. At the edge of a domain, the shortest step may find no solution where a longer step finds the edge.
    ///
    /// If the step succeeds without the history of earlier steps, the history caused the failure. It is then `refused`.
    #[cold]
    fn failure_of_shortest(&self, h: f64, refused: Option<Failure>) -> Failure {
        match self.attempt().failure(&self.method, h) {
            Failure::Inaccurate { error } if error <= 1.0 => refused.unwrap_or(Failure::Inaccurate { error }),
            Failure::NotConverged { .. } | Failure::Singular => self.attempt().failure(&self.method, 16.0 * h),
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

    pub(super) fn check(&self) -> Result<(), StepError> {
        self.usable().map_err(|failure| {
            let h = self.controller.unusable().unwrap_or_else(|| self.controller.step(&self.bounds));
            StepError::new(failure, signed(self.now()), h)
        })
    }

    /// Checks the settings and the state before a step.
    fn usable(&self) -> Result<(), Failure> {
        if let Some(tolerance) = self.tolerance.unusable() {
            return Err(Failure::InvalidTolerance { tolerance });
        }
        self.bounds.check()?;
        if let Some(h) = self.controller.unusable() {
            return Err(Failure::InvalidStepSize { h });
        }
        if self.taken == self.given {
            check_parameters(&self.system)?;
        }
        if !(signed(self.now()).is_finite() && self.x.is_finite()) {
            return Err(not_finite::<S, R>(self.now(), &self.x.z));
        }
        // Later states need no check: each comes from a step that succeeded.
        if self.taken != self.given {
            return Ok(());
        }
        if S::State::ATTITUDES
            && let Some(length) = wrong_length::<S, R>(&self.x.z)
        {
            return Err(Failure::NotNormalised { length });
        }
        Failure::outside(self.system.outside_domain(self.now(), &self.x.z, &self.x.s))?;
        let in_range = M::is_in_range(&self.prepared.whole, &self.system, &self.x.z);
        if in_range { Ok(()) } else { Err(Failure::OutOfRange) }
    }
}
