//! A system under a method: the object that users step.

use super::error::StepError;
use super::output::{Samples, Until};
use super::trajectory::Trajectory;
use super::watch::{Found, Watch};
use crate::method::{Clock, Method, Probe, Refusal, Step, Unwatched};
use crate::scalar::{Real, signed, zero};
use crate::space::{Action, Snapshot};
use crate::space::{Compensated, DoubleWord, Plain, Point, Summation, WithoutAction};
use crate::system::{Conformal, FirstIntegrals, PhaseSpace, StateOf, VectorField, singular_time};

/// Steps between two looks at whether the state is still finite. A number that is not finite stays so under every flow
/// q ← q + …, p ← p + …, so looking now and then misses nothing; the price of a look is paid once in so many steps.
const STEPS_BETWEEN_LOOKS: u64 = 1024;

/// A system under a method with a step size: a plain value, no borrow, no allocation.
///
/// Time is `t0 + n·h`, never a running sum. After an error the last good state is still there, and the next call may go
/// on, with a smaller step if [`Integrator::set_step_size`] was called.
#[derive(Clone, Debug)]
pub struct Integrator<S: PhaseSpace<R>, M: Method<S, R>, R: Real = f64, C = Plain> {
    system: S,
    method: M,
    prepared: M::Prepared,
    memory: M::Memory,
    clock: Clock<R>,
    /// Steps since the beginning.
    steps: u64,
    x: Point<S::Phase, C, S::Action>,
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real> Integrator<S, M, R> {
    /// A system under a method, with step size `h` (negative to go back in time), from `state` on.
    ///
    /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
    pub fn new(system: S, method: M, h: R, state: StateOf<S, R>) -> Self {
        let (t0, z, s) = state.parts();
        Integrator {
            system,
            method,
            prepared: method.prepare(&system, h),
            memory: M::memory(),
            clock: Clock::new(t0, h),
            steps: 0,
            x: Point::with_action(z, s),
        }
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Integrator<S, M, R, C> {
    /// One step.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then unchanged.
    #[inline]
    pub fn step(&mut self) -> Result<(), StepError> {
        self.check_start()?;
        self.step_within(None).map(drop)
    }

    /// `n` steps: the bare loop, with last and first flows of neighbouring steps merged where the method has such.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one.
    #[inline]
    pub fn advance(&mut self, n: u64) -> Result<(), StepError> {
        if n == 1 {
            return self.step();
        }
        self.check_start()?;
        let mut left = n;
        while left > 0 {
            let steps = left.min(if S::EXAMINED { 1 } else { STEPS_BETWEEN_LOOKS });
            let (mut memory, mut x) = (self.memory.clone(), self.x);
            let outcome = M::advance(&self.prepared, &mut memory, &self.system, &self.clock, steps, &mut x);
            if outcome.is_ok() && self.is_good(steps, &x) && self.singular_time(steps).is_none() {
                (self.memory, self.x) = (memory, x);
                self.pass(steps);
            } else {
                // One by one, as single steps are taken, to stop where those do.
                for _ in 0..steps {
                    self.step_within(None)?;
                }
            }
            left -= steps;
        }
        Ok(())
    }

    /// One step, if there is one that does not end beyond the time `t` (before it, if h < 0); else `false`, and nothing changes.
    ///
    /// A step that ends at `t` up to the rounding of time ends there: [`time`](Integrator::time) is then `t`.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then unchanged. A `t` that is not a number is a step size that is none.
    #[inline]
    pub fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.check_start()?;
        let now = self.time();
        if t.magnitude().is_nan() {
            return Err(StepError::InvalidStepSize { h: signed(t - now) });
        }
        let stepped =
            (M::SCALES_STEPS || self.clock.leads_to(t, [now, self.clock.at(1)])) && self.step_within(Some(t))?;
        if stepped && self.clock.is_at(self.time(), t) {
            self.clock.name(t);
        }
        Ok(stepped)
    }

    /// Whole steps to the last one that is not beyond the time `t` (not before it, if h < 0): up to a step is left.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one. A `t` that is not finite is a step size that is none.
    pub fn advance_to(&mut self, t: R) -> Result<(), StepError> {
        self.check_start()?;
        let left = signed(t - self.time());
        if !left.is_finite() {
            return Err(StepError::InvalidStepSize { h: left });
        }
        if !M::SCALES_STEPS {
            self.advance(self.clock.steps_before(self.time(), t))?;
        }
        while self.step_towards(t)? {}
        Ok(())
    }

    /// One step that does not end beyond `limit`; else `false`.
    #[inline(always)]
    fn step_within(&mut self, limit: Option<R>) -> Result<bool, StepError> {
        // In place: one copy, for steps that are refused, in place of two.
        let (t, memory, start) = (self.time(), self.memory.clone(), self.x);
        let step = Step { system: &self.system, t, x: &mut self.x, probe: &mut Unwatched };
        let good = M::step(&self.prepared, &mut self.memory, step).is_ok()
            && self.is_good(1, &self.x)
            && self.singular_time(1).is_none();
        if good && self.ends_within(limit, &self.x, t) {
            self.pass(1);
            return Ok(true);
        }
        (self.x, self.memory) = (start, memory);
        if good { Ok(false) } else { self.step_watched(limit) }
    }

    /// The same step watched, to say why it is refused, if it is.
    #[cold]
    fn step_watched(&mut self, limit: Option<R>) -> Result<bool, StepError> {
        let (mut memory, mut x) = (self.memory.clone(), self.x);
        let mut watch = Watch::new(&self.system, self.time(), &self.x);
        let step = Step { system: &self.system, t: self.time(), x: &mut x, probe: &mut watch };
        let outcome = M::step(&self.prepared, &mut memory, step);
        let (t, singular) = (signed(self.time()), self.singular_time(1));
        if outcome.is_ok() && self.is_good(1, &x) {
            if let Some(what) = singular {
                return Err(StepError::OutsideDomain { t, what });
            }
            if !self.ends_within(limit, &x, self.time()) {
                return Ok(false);
            }
            (self.memory, self.x) = (memory, x);
            self.pass(1);
            return Ok(true);
        }
        watch.visit(self.clock.at(1), &x.z, &x.s);
        Err(match (outcome, watch.reason(outcome.err())) {
            (_, Some(Found::OutsideDomain(what))) => StepError::OutsideDomain { t, what },
            (_, Some(Found::Pole(piece))) => StepError::Pole { t, piece },
            (Ok(()) | Err(Refusal::OutsideDomain { .. }), None) => StepError::NonFinite { t },
            (Err(Refusal::Singular), None) => StepError::Singular { t },
            (Err(Refusal::SingularDirection), None) => StepError::SingularDirection { t },
            (Err(Refusal::NotConverged { iterations, correction }), None) => {
                StepError::NotConverged { t, iterations, correction }
            }
        })
    }

    #[inline(always)]
    fn check_start(&self) -> Result<(), StepError> {
        let h = self.step_size().magnitude();
        if !(h > 0.0 && h < f64::INFINITY) {
            return Err(StepError::InvalidStepSize { h: signed(self.step_size()) });
        }
        // Later states are good because the steps that led to them were.
        if self.steps == 0 { self.check_state() } else { Ok(()) }
    }

    #[cold]
    fn check_state(&self) -> Result<(), StepError> {
        let t = signed(self.time());
        if !(t.is_finite() && self.x.is_finite()) {
            return Err(StepError::NonFiniteState { t });
        }
        match self.system.outside_domain(self.time(), &self.x.z, &self.x.s) {
            Some(what) => Err(StepError::OutsideDomain { t, what }),
            None => Ok(()),
        }
    }

    /// Whether a state is finite, and the energy defined there.
    #[inline(always)]
    fn is_good(&self, steps: u64, x: &Point<S::Phase, C, S::Action>) -> bool {
        x.is_finite() && self.system.outside_domain(self.end(steps, x), &x.z, &x.s).is_none()
    }

    /// When steps end that led to `x`.
    #[inline(always)]
    fn end(&self, steps: u64, x: &Point<S::Phase, C, S::Action>) -> R {
        self.clock.at(steps) + x.ahead.value()
    }

    /// Whether a step from time `start` to `x` does not end beyond `limit`.
    #[inline(always)]
    fn ends_within(&self, limit: Option<R>, x: &Point<S::Phase, C, S::Action>, start: R) -> bool {
        limit.is_none_or(|t| !M::SCALES_STEPS || self.clock.leads_to(t, [start, self.end(1, x)]))
    }

    /// The first coefficient, if any, that is singular at a time within one of the next steps.
    #[inline(always)]
    fn singular_time(&self, steps: u64) -> Option<&'static str> {
        singular_time(&self.system, [self.clock.at(0), self.clock.at(steps)])
    }

    #[inline(always)]
    fn pass(&mut self, steps: u64) {
        self.clock.pass(steps);
        self.steps += steps;
    }

    /// Changes the step size; time goes on from here.
    pub fn set_step_size(&mut self, h: R) {
        self.clock.set_step_size(h, self.x.ahead);
        self.x.ahead = DoubleWord::new(zero());
        self.prepared = self.method.prepare(&self.system, h);
        self.memory = M::memory();
    }

    /// The step size.
    #[inline(always)]
    pub fn step_size(&self) -> R {
        self.clock.step_size()
    }

    /// `t0 + n·h`.
    #[inline(always)]
    pub fn time(&self) -> R {
        self.clock.now(self.x.ahead.value())
    }

    /// The state now.
    #[inline]
    pub fn state(&self) -> StateOf<S, R> {
        S::State::of(self.time(), self.x.z, if C::ACTION { self.x.s } else { S::Action::unknown() })
    }

    /// The energy now.
    pub fn energy(&self) -> R {
        let s = if C::ACTION { self.x.s } else { S::Action::unknown() };
        self.system.hamiltonian(self.time(), &self.x.z, &s)
    }

    /// The first integrals now, in the order in which they were named.
    pub fn integrals(&self) -> S::Values
    where
        S: FirstIntegrals<R>,
    {
        self.system.integrals(self.time(), &self.x.z)
    }

    /// The number of steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The system with its parameters.
    pub fn system(&self) -> &S {
        &self.system
    }

    /// The method.
    pub fn method(&self) -> &M {
        &self.method
    }

    /// The state after every step up to the last one that is not after `t` (not before, if h < 0).
    ///
    /// Output never changes the step: the last state is at `t` only if `t` is a whole number of steps away, up to the rounding of
    /// time. An infinite `t` is never reached.
    pub fn until(&mut self, t: R) -> Until<'_, Self> {
        Until::new(self, t)
    }

    /// The state after every `k` steps, without end. `k` = 0 counts as 1.
    pub fn sampled(&mut self, k: u64) -> Samples<'_, Self> {
        Samples::new(self, k)
    }

    fn with_sums<D: Summation<S::Phase>>(self) -> Integrator<S, M, R, D> {
        let Integrator { system, method, prepared, memory, clock, steps, x } = self;
        Integrator { system, method, prepared, memory, clock, steps, x: x.with_sums() }
    }
}

impl<S: VectorField<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Integrator<S, M, R, C> {
    /// The same with compensated sums: what adding an increment to a coordinate rounds off is carried to the next step. The
    /// error of rounding grows with the number of steps many times more slowly; a step costs a few additions a coordinate more.
    pub fn compensated(self) -> Integrator<S, M, R, Compensated<S::Phase>> {
        self.with_sums()
    }
}

impl<S: Conformal<R>, M: Method<S, R>, R: Real> Integrator<S, M, R> {
    /// The same without the action, which does not act back on positions and momenta: splittings do not compute it, nor what only
    /// it needs, such as the value of the potential. In states it is not a number.
    pub fn without_action(self) -> Integrator<S, M, R, WithoutAction> {
        self.with_sums()
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Trajectory for Integrator<S, M, R, C> {
    type State = StateOf<S, R>;

    #[inline]
    fn step(&mut self) -> Result<(), StepError> {
        self.step()
    }
    #[inline]
    fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.advance(n)
    }
    #[inline]
    fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.step_towards(t)
    }
    fn advance_to(&mut self, t: R) -> Result<(), StepError> {
        self.advance_to(t)
    }
    #[inline]
    fn time(&self) -> R {
        self.time()
    }
    #[inline]
    fn state(&self) -> StateOf<S, R> {
        self.state()
    }
    fn energy(&self) -> R {
        self.energy()
    }
    fn steps(&self) -> u64 {
        self.steps
    }
}
