//! Takes steps of fixed length in blocks of up to 1024. A block that fails is repeated in single steps. A single step that fails is repeated with all checks: it
//! succeeds, or the checks give the reason.

use crate::method::{Clock, Method, Probe, Step, Unwatched};
use crate::running::error::{StepError, check_parameters, not_finite};
use crate::running::settle::{STEPS_BETWEEN_CHECKS, has_drift, without_drift};
use crate::running::watch::Watch;
use crate::scalar::{Real, signed, zero};
use crate::solving::Failure;
use crate::space::{Action, Array, PerCoordinate, Point, Snapshot, Summation, wrong_length};
use crate::system::{Clear, PhaseSpace, jump_on_way};

/// The pace of steps of one length: a system under a method, and the present point.
#[derive(Clone)]
pub struct Fixed<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C> {
    pub(super) system: S,
    pub(super) method: M,
    pub(super) prepared: M::Prepared,
    pub(super) memory: M::Memory,
    pub(super) clock: Clock<R>,
    /// Number of steps since the start.
    pub(super) taken: u64,
    /// The next step checks the state if `taken` has this value: after a start, a given state or a new system, but not after an event.
    pub(super) given: u64,
    /// Value of `taken` when the state was set, by the user or at an event, but not at a new system.
    pub(super) set: u64,
    /// State at the last start, event or change of the system. The steps conserve its invariants.
    pub(super) origin: S::Phase,
    /// Present point. For methods that move an inner point (see [`Handling`](crate::method::Handling)), it is the inner point from the first step on.
    pub(super) x: Point<S::Phase, C, S::Action>,
    /// Whether `x` is the inner point. Not read for methods without one.
    pub(super) inside: bool,
    /// Interval of time without poles, found so far.
    pub(super) clear: Clear<R>,
    /// The point before the steps that were taken last.
    pub(super) past: Past<Point<S::Phase, C, S::Action>, R>,
}

/// The point before the last steps, at most [`STEPS_BETWEEN_CHECKS`] of them. A state within the last step is computed from it.
#[derive(Clone, Copy)]
pub(super) struct Past<X, R> {
    pub(super) x: X,
    pub(super) clock: Clock<R>,
    /// Whether `x` is an inner point.
    pub(super) inside: bool,
    /// Number of steps since then. Zero if the point is not known.
    pub(super) steps: u64,
}

impl<A: Array, C: Summation<A>, B: Action<A::Real>> Past<Point<A, C, B>, A::Real> {
    pub(super) fn none() -> Self {
        let x = Point::with_action(A::zero(), B::zero());
        Past { x, clock: Clock::new(zero(), zero()), inside: false, steps: 0 }
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Fixed<S, M, R, C> {
    /// Takes `n` steps in blocks, and checks the end of each block. Repeats a failed block in single steps.
    #[inline]
    pub(super) fn advance_in_blocks(&mut self, n: u64) -> Result<(), StepError> {
        self.check()?;
        if M::HANDLING.is_faster_singly && n == 1 {
            return self.single();
        }
        let (mut left, mut singly) = (n, 0);
        while left > 0 {
            let steps = if singly > 0 { 1 } else { left.min(self.steps_to_check()) };
            let (mut memory, mut x) = (self.memory.clone(), self.x);
            self.enter(&mut x);
            if self.run(steps, &mut memory, &mut x) && self.pole_in_time(steps, &x).is_none() {
                let past = Past { x: self.x, clock: self.clock, inside: self.inside, steps };
                (self.memory, self.x) = (memory, x);
                self.pass(past);
            } else if steps > 1 {
                // Repeat with single steps, to stop where they would stop. Doing so in this loop keeps only one copy of the code of a step.
                singly = steps;
                continue;
            } else {
                self.step_anew(None)?;
            }
            left -= steps;
            singly = singly.saturating_sub(1);
        }
        Ok(())
    }

    /// Takes one step, for a method that needs less work for a single step.
    #[inline(never)]
    fn single(&mut self) -> Result<(), StepError> {
        self.step_within(None).map(drop)
    }

    /// Takes `steps` steps from `x` on. Returns whether they are good. Every end is checked if the system requires it; otherwise the last end shows
    /// whether all are good.
    ///
    /// Not inlined: the loop is then optimised independently of the caller.
    #[inline(never)]
    fn run(&self, steps: u64, memory: &mut M::Memory, x: &mut Point<S::Phase, C, S::Action>) -> bool {
        let (mut clock, mut taken) = (self.clock, 0);
        // Local copies stay in registers; data behind a reference would be written to memory in each step.
        let (target_memory, target) = (memory, x);
        let (mut memory, mut x) = (target_memory.clone(), *target);
        let at_once = if S::EXAMINED || !S::CONTINUOUS { 1 } else { steps };
        while taken < steps {
            let before = x;
            let outcome = M::advance(&self.prepared, &mut memory, &self.system, &clock, at_once, &mut x);
            taken += at_once;
            clock.pass(at_once);
            if outcome.is_err() || !self.is_good(taken, &x) || self.jump(taken, [&before, &x]).is_some() {
                return false;
            }
        }
        (*target_memory, *target) = (memory, x);
        true
    }

    /// Returns the number of steps until the next check. The state at a check is kept, because a block that fails starts again there.
    #[inline(always)]
    fn steps_to_check(&self) -> u64 {
        if const { has_drift::<S, M, R>() } {
            // Drift is removed after the same steps, independent of how many steps a call takes.
            STEPS_BETWEEN_CHECKS - self.taken % STEPS_BETWEEN_CHECKS
        } else {
            STEPS_BETWEEN_CHECKS
        }
    }

    /// Takes one step. Returns `false`, and takes none, if the method scales its steps and the step would end beyond `limit`. Callers compare the ends of other
    /// steps with their limit.
    #[inline(always)]
    pub(super) fn step_within(&mut self, limit: Option<R>) -> Result<bool, StepError> {
        // In place: this needs one copy of the state instead of two. Only methods that scale their steps need a copy of the history, which may be large.
        let ([t, end], start) = (self.clock.ends(0, self.x.ahead.value()), self.x);
        let memory = (M::HANDLING.scales_steps && limit.is_some()).then(|| self.memory.clone());
        if M::HANDLING.moves_inner_point {
            let mut x = start;
            self.enter(&mut x);
            self.x = x;
        }
        let begun = self.x;
        let step = Step { system: &self.system, t, end, x: &mut self.x, probe: &mut Unwatched };
        let good = M::step(&self.prepared, &mut self.memory, step).is_ok()
            && self.is_good(1, &self.x)
            && self.clear.pole(&self.system, [t, self.end(1, &self.x)]).is_none()
            && self.jump(1, [&begun, &self.x]).is_none();
        if good && self.ends_within(limit, &self.x, t) {
            self.pass(Past { x: start, clock: self.clock, inside: self.inside, steps: 1 });
            return Ok(true);
        }
        self.x = start;
        match memory {
            Some(memory) if good => {
                self.memory = memory;
                Ok(false)
            }
            _ => self.step_anew(limit),
        }
    }

    /// Repeats a refused step without history and with checks of every evaluation. If it is refused again, the checks give the reason.
    #[cold]
    fn step_anew(&mut self, limit: Option<R>) -> Result<bool, StepError> {
        self.memory = M::memory(&self.x.z);
        let (mut memory, mut x) = (self.memory.clone(), self.x);
        let mut watch = Watch::new(&self.system, self.now(), &self.state_point());
        self.enter(&mut x);
        let begun = x;
        let [t, end] = self.clock.ends(0, x.ahead.value());
        let step = Step { system: &self.system, t, end, x: &mut x, probe: &mut watch };
        let outcome = M::step(&self.prepared, &mut memory, step);
        if outcome.is_ok() && self.is_good(1, &x) {
            if let Some(what) = self.pole_in_time(1, &x).or_else(|| self.jump(1, [&begun, &x])) {
                return Err(self.error(Failure::OutsideDomain { what }));
            }
            if !self.ends_within(limit, &x, self.now()) {
                return Ok(false);
            }
            let past = Past { x: self.x, clock: self.clock, inside: self.inside, steps: 1 };
            (self.memory, self.x) = (memory, x);
            self.pass(past);
            return Ok(true);
        }
        let end = self.state_point_of(&x, self.clock.at(1));
        watch.visit(self.clock.at(1), &end, &x.s);
        Err(self.error(watch.seen().failure(outcome.err())))
    }

    /// Returns a failure as the error of a step from the present time.
    fn error(&self, failure: Failure) -> StepError {
        StepError::new(failure, signed(self.now()), signed(self.clock.step_size()))
    }

    #[inline(always)]
    pub(super) fn check(&self) -> Result<(), StepError> {
        let h = self.clock.step_size().magnitude();
        if !(h > 0.0 && h < f64::INFINITY) {
            return Err(self.error(Failure::InvalidStepSize { h: signed(self.clock.step_size()) }));
        }
        // Later states need no check: each comes from a step that succeeded.
        if self.taken == self.given { self.check_state().map_err(|failure| self.error(failure)) } else { Ok(()) }
    }

    /// Marks a resumed state outside of the domain as given, so that the next step checks it. The saved number of steps may be wrong.
    #[cfg(feature = "alloc")]
    pub(super) fn examine_if_outside(&mut self) {
        if self.system.outside_domain(self.now(), &self.state_point().z, &self.x.s).is_some() {
            self.given = self.taken;
        }
    }

    #[cold]
    fn check_state(&self) -> Result<(), Failure> {
        check_parameters(&self.system)?;
        if !(signed(self.now()).is_finite() && self.x.is_finite()) {
            return Err(not_finite::<S, R>(self.now(), &self.x.z));
        }
        if S::State::ATTITUDES
            && let Some(length) = wrong_length::<S, R>(&self.x.z)
        {
            return Err(Failure::NotNormalised { length });
        }
        Failure::outside(self.system.outside_domain(self.now(), &self.state_point().z, &self.x.s))?;
        if !M::is_in_range(&self.prepared, &self.system, &self.x.z) {
            return Err(Failure::OutOfRange);
        }
        // The momenta of a run whose system was replaced result from a step. `DiscreteGradient` may leave them O(h²) off, so only positions are checked.
        // Rates are not checked with a step of length 0.
        let h_of_rates = if self.taken == self.set { self.clock.step_size() } else { zero() };
        self.system.unmet(self.now(), h_of_rates, &self.x.z).map_or(Ok(()), |unmet| Err(unmet.into()))
    }

    /// Returns whether a point and its time are finite, and the energy is defined there. A finite time after the last step implies finite times
    /// before.
    #[inline(always)]
    fn is_good(&self, steps: u64, x: &Point<S::Phase, C, S::Action>) -> bool {
        x.is_finite()
            && ((!M::HANDLING.moves_inner_point && M::shows_domain(&self.prepared)) || self.is_defined(steps, x))
            && self.end(steps, x).magnitude() < f64::INFINITY
    }

    /// Returns whether the state is finite and in the domain. The map from the inner point to the state may have no finite result.
    #[inline(always)]
    fn is_defined(&self, steps: u64, x: &Point<S::Phase, C, S::Action>) -> bool {
        let t = self.end(steps, x);
        let z = self.state_point_of(x, t);
        (!M::HANDLING.moves_inner_point || Array::is_finite(&z)) && self.system.outside_domain(t, &z, &x.s).is_none()
    }

    /// Maps the point of a state to the inner point, unless `x` is the inner point already.
    #[inline(always)]
    fn enter(&self, x: &mut Point<S::Phase, C, S::Action>) {
        if M::HANDLING.moves_inner_point && !self.inside {
            M::enter(&self.prepared, &self.system, self.now(), &mut x.z);
        }
    }

    /// Returns the point of the state at time `t` that belongs to the inner point `x`.
    #[inline(always)]
    fn state_point_of(&self, x: &Point<S::Phase, C, S::Action>, t: R) -> S::Phase {
        let mut z = x.z;
        if M::HANDLING.moves_inner_point {
            M::leave(&self.prepared, &self.system, t, &mut z);
        }
        z
    }

    /// Returns the point of the present state.
    #[inline(always)]
    pub(super) fn state_point(&self) -> Point<S::Phase, C, S::Action> {
        let mut x = self.x;
        if M::HANDLING.moves_inner_point && self.inside {
            x.z = self.state_point_of(&x, self.now());
        }
        x
    }

    /// Replaces the inner point by the point of the state. The next step maps it to an inner point again, possibly with other coefficients.
    pub(super) fn leave(&mut self) {
        if M::HANDLING.moves_inner_point && self.inside {
            // The rounding errors of the sums belong to the inner point, so they are dropped.
            let (ahead, x) = (self.x.ahead, self.state_point());
            self.x = Point { ahead, ..Point::with_action(x.z, x.s) };
            self.inside = false;
        }
    }

    /// Returns the time at the end of `steps` steps to `x`.
    #[inline(always)]
    fn end(&self, steps: u64, x: &Point<S::Phase, C, S::Action>) -> R {
        self.clock.at(steps) + x.ahead.value()
    }

    /// Returns whether a step from time `start` to `x` does not end beyond `limit`, for methods that scale their steps. True for other methods.
    #[inline(always)]
    fn ends_within(&self, limit: Option<R>, x: &Point<S::Phase, C, S::Action>, start: R) -> bool {
        limit.is_none_or(|t| !M::HANDLING.scales_steps || self.clock.leads_to(t, [start, self.end(1, x)]))
    }

    /// Returns the first pole in time, if any, within the next steps, which lead to `x`.
    #[inline(always)]
    fn pole_in_time(&mut self, steps: u64, x: &Point<S::Phase, C, S::Action>) -> Option<&'static str> {
        let way = [self.end(0, &self.x), self.end(steps, x)];
        self.clear.pole(&self.system, way)
    }

    /// Returns a jump of the energy within the last of `steps` steps, between two points of the method. A method that conserves the energy also does
    /// so across a jump.
    #[inline(always)]
    fn jump(&self, steps: u64, ends: [&Point<S::Phase, C, S::Action>; 2]) -> Option<&'static str> {
        if S::CONTINUOUS || self.method.claims().conserves_energy {
            return None;
        }
        let moment = |steps: u64, x: &Point<S::Phase, C, S::Action>| {
            let t = self.end(steps, x);
            (t, PerCoordinate { z: self.state_point_of(x, t), s: x.s })
        };
        jump_on_way(&self.system, &[moment(steps - 1, ends[0]), moment(steps, ends[1])], 0.0)
    }

    /// Records steps that led from a point to the present one: advances clock and count, and removes the drift when that is due.
    #[inline(always)]
    fn pass(&mut self, past: Past<Point<S::Phase, C, S::Action>, R>) {
        self.clock.pass(past.steps);
        self.taken += past.steps;
        (self.inside, self.past) = (true, past);
        if const { has_drift::<S, M, R>() } && self.taken.is_multiple_of(STEPS_BETWEEN_CHECKS) {
            self.remove_drift();
        }
    }

    /// Removes the drift by rounding over many steps, if the corrected point is good.
    #[cold]
    #[inline(never)]
    fn remove_drift(&mut self) {
        let x = without_drift::<S, M, R, C>((&self.system, &self.prepared), &self.origin, &self.x);
        if self.is_good(0, &x) {
            self.x = x;
        }
    }

    /// Returns the present time: t₀ + n·h and what scaled steps are ahead, or the time that a call has requested.
    #[inline(always)]
    pub(super) fn now(&self) -> R {
        self.clock.now(self.x.ahead.value())
    }
}
