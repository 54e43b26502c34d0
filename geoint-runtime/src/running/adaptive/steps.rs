//! The data of a run with adaptive steps: its start, and the checks before a step.

use super::attempt::{Carried, Prepared, no_history};
use super::start;
use super::way::InformativeSteps;
use crate::method::{Clock, Method};
use crate::running::error::{StepError, check_parameters, not_finite};
use crate::running::step_size::{Bounds, Controller};
use crate::running::tolerance::Tolerance;
use crate::scalar::{Real, signed, zero};
use crate::solving::Failure;
use crate::space::{PerCoordinate, Snapshot, wrong_length};
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
    pub(super) part: f64,
    pub(super) prepared: Prepared<M::Prepared>,
    /// History of the method: for whole steps, and for their halves.
    pub(super) memory: [M::Memory; 2],
    pub(super) clock: Clock<R>,
    /// State at the start of the run. The steps conserve its invariants.
    pub(super) origin: S::Phase,
    pub(super) x: Carried<S, R>,
    pub(super) taken: u64,
    /// Value of `taken` when the state was last given, by the user, by an event, or with a new system.
    pub(super) given: u64,
    /// Value of `taken` when the user last gave a state.
    pub(super) set: u64,
    pub(super) rejections: u64,
    /// Interval of time without poles, found so far.
    pub(super) clear: Clear<R>,
    /// Time in which the state changes at the start of the run.
    pub(super) time_of_start: f64,
    /// Recent steps whose errors are informative.
    pub(super) informative_steps: InformativeSteps,
    /// The start of the last step. `None` if there was no step since the state was set.
    pub(super) past: Option<Past<R, Carried<S, R>>>,
}

/// The start of the last step.
#[derive(Clone, Copy)]
pub(super) struct Past<R, X> {
    pub(super) clock: Clock<R>,
    pub(super) x: X,
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
            // The first step prepares its own length.
            prepared: Prepared::new(&system, &method, 1.0),
            memory: no_history::<S, M, R>(&x.z),
            clock: Clock::new(t, zero()),
            origin: x.z,
            x,
            taken: 0,
            given: 0,
            set: 0,
            rejections: 0,
            clear: Clear::unknown(),
            time_of_start: 0.0,
            informative_steps: InformativeSteps::default(),
            past: None,
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
        (self.clock, self.x) = (Clock::new(t, zero()), x);
        (self.memory, self.past) = (no_history::<S, M, R>(&self.x.z), None);
        (self.given, self.origin, self.informative_steps) = (self.taken, self.x.z, InformativeSteps::default());
        let backwards = self.size() < 0.0;
        self.start();
        self.controller.turn(backwards);
    }

    /// Continues from the present point with another system.
    pub(super) fn replace_system(&mut self, system: S) {
        (self.system, self.prepared, self.clear) =
            (system, Prepared::new(&system, &self.method, 1.0), Clear::unknown());
        // A new clock would lose the second word of t₀, and the time that a call has requested.
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
        // A state of the user obeys constraints. Later velocities do so to the error of the method only.
        if self.taken == self.set
            && let Some(unmet) = self.system.unmet(self.now(), R::from_f64(self.size()), &self.x.z)
        {
            return Err(unmet.into());
        }
        let in_range = M::is_in_range(&self.prepared.whole, &self.system, &self.x.z);
        if in_range { Ok(()) } else { Err(Failure::OutOfRange) }
    }
}
