//! Integration with a fixed step size.

mod steps;

use crate::method::{Clock, Method};
use crate::running::error::StepError;
use crate::running::pace::{Coordinates, Pace, PartialSteps};
use crate::running::run::Run;
use crate::scalar::{Real, signed, zero};
use crate::space::{
    Action, Compensated, DoubleWord, NEVER, PerCoordinate, Plain, Point, Snapshot, Summation, WithoutAction,
};
use crate::system::{Clear, Conformal, PhaseSpace, StateOf};
#[cfg(feature = "alloc")]
use crate::{method::Name, space::Record, space::Tape};
use core::fmt::{self, Debug, Formatter};
pub use steps::Fixed;
use steps::Past;

/// A run with a method and a fixed step size.
///
/// The time is `t0 + n·h`, never a running sum. After an error, the last good state is still available. The next call may continue, for example with
/// a smaller step set by [`set_step_size`](Run::set_step_size).
#[doc(alias = "fixed step")]
pub type Integrator<S, M, R = f64, C = Plain> = Run<Fixed<S, M, R, C>>;

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real> Run<Fixed<S, M, R, Plain>> {
    /// Integrates a system with step size `h`, from `state` on. A negative `h` goes back in time.
    ///
    /// Nothing is checked yet: the first step reports an unusable `h` or state.
    pub fn new(system: S, method: M, h: R, state: StateOf<S, R>) -> Self {
        let (t0, z, s) = state.parts();
        Run::of(Fixed {
            system,
            method,
            prepared: method.prepare(&system, h),
            memory: M::memory(&z),
            clock: Clock::new(t0, h),
            taken: 0,
            given: 0,
            set: 0,
            origin: z,
            x: Point::with_action(z, s),
            inside: false,
            clear: Clear::unknown(),
            past: Past::none(),
        })
    }

    /// Uses compensated sums: the rounding error of adding an increment to a coordinate is carried to the next step. Rounding errors then grow much
    /// more slowly with the number of steps. A step costs a few more additions for each coordinate.
    ///
    /// Some flows of contact systems do more than add. They compute their increments by separate formulas.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn compensated(self) -> Integrator<S, M, R, Compensated<S::Phase>> {
        self.with_sums()
    }

    /// Omits the action, which does not affect positions and momenta. Splittings then skip it, and all values that only it needs, such as the
    /// potential. States contain NaN in its place.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn without_action(self) -> Integrator<S, M, R, WithoutAction>
    where
        S: Conformal<R>,
    {
        self.with_sums()
    }

    fn with_sums<D: Summation<S::Phase>>(self) -> Integrator<S, M, R, D> {
        let Fixed { system, method, prepared, memory, clock, taken, given, set, origin, x, inside, clear, .. } =
            self.pace;
        let (x, past) = (x.with_sums(), Past::none());
        let pace = Fixed { system, method, prepared, memory, clock, taken, given, set, origin, x, inside, clear, past };
        Run { reported: self.reported, ..Run::of(pace) }
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Run<Fixed<S, M, R, C>> {
    /// Changes the step size. The time continues from the present value.
    pub fn set_step_size(&mut self, h: R) {
        self.pace.set_step_size(h);
    }

    /// Returns the step size h of all steps.
    #[inline(always)]
    pub fn step_size(&self) -> R {
        self.pace.clock.step_size()
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Fixed<S, M, R, C> {
    fn set_step_size(&mut self, h: R) {
        self.leave();
        self.past = Past::none();
        self.clock.set_step_size(h, self.x.ahead);
        self.x.ahead = DoubleWord::new(zero());
        self.prepared = self.method.prepare(&self.system, h);
        self.memory = M::memory(&self.x.z);
    }

    /// Takes up to four steps to the time `t`, and keeps the changed step size, so that a copy computes its coefficients once.
    fn shorten_to(&mut self, t: R) -> Result<(), StepError> {
        // Methods that scale their steps end near `t`. The next step leads from there to `t`.
        for _ in 0..4 {
            if Pace::time(self) == t {
                break;
            }
            self.set_step_size(t - Pace::time(self));
            if !self.step_towards(t)? {
                Pace::step(self)?;
            }
        }
        Ok(())
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Pace for Fixed<S, M, R, C> {
    type Real = R;
    type System = S;
    type Method = M;

    fn system(&self) -> &S {
        &self.system
    }
    fn method(&self) -> &M {
        &self.method
    }
    fn taken(&self) -> u64 {
        self.taken
    }
    #[inline(always)]
    fn time(&self) -> R {
        self.now()
    }
    #[inline(always)]
    fn point(&self) -> Coordinates<Self> {
        let s = if C::ACTION { self.x.s } else { S::Action::of(R::from_f64(f64::NAN)) };
        PerCoordinate { z: self.state_point().z, s }
    }
    fn steps_backwards(&self) -> bool {
        self.clock.step_size().any_below(0.0)
    }
    fn is_fresh(&self) -> bool {
        self.taken == self.set
    }

    fn check_start(&self) -> Result<(), StepError> {
        self.check()
    }
    #[inline(always)]
    fn step(&mut self) -> Result<(), StepError> {
        self.check()?;
        self.step_within(None).map(drop)
    }
    #[inline]
    fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.advance_in_blocks(n)
    }
    #[inline]
    fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.check()?;
        let (now, next) = (self.now(), self.clock.at(1));
        if t.magnitude().is_nan() {
            return Err(StepError::of_step_size(signed(now), signed(t - now)));
        }
        let stepped = (M::HANDLING.scales_steps || self.clock.leads_to(t, [now, next])) && self.step_within(Some(t))?;
        let end = if M::HANDLING.scales_steps { self.now() } else { next };
        if stepped && self.clock.is_at(end, t) {
            self.clock.name(t);
        }
        Ok(stepped)
    }
    fn advance_to(&mut self, t: R, _: u64) -> Result<(), StepError> {
        self.check()?;
        let left = signed(t - self.now());
        if !left.is_finite() {
            return Err(StepError::of_step_size(signed(self.now()), left));
        }
        if !M::HANDLING.scales_steps {
            self.advance_in_blocks(self.clock.steps_before(self.now(), t))?;
        }
        while self.step_towards(t)? {}
        Ok(())
    }

    fn restart(&mut self, state: StateOf<S, R>) {
        let (t, z, s) = state.parts();
        // If the action is not computed, states contain NaN in its place.
        let s = if C::ACTION { s } else { self.x.s };
        (self.x, self.inside, self.memory) = (Point::with_action(z, s), false, M::memory(&z));
        (self.clock, self.past) = (Clock::new(t, self.clock.step_size()), Past::none());
        (self.given, self.set, self.origin) = (self.taken, self.taken, z);
    }
    /// The next step does not check the state: its momenta may be off a constraint.
    fn restart_within(&mut self, state: StateOf<S, R>) {
        self.restart(state);
        self.given = NEVER;
    }
    fn set_system(&mut self, system: S) {
        self.leave();
        (self.system, self.past) = (system, Past::none());
        self.prepared = self.method.prepare(&system, self.clock.step_size());
        self.memory = M::memory(&self.x.z);
        // Other parameters may have other domains, poles and values of invariants.
        (self.given, self.origin, self.clear) = (self.taken, self.x.z, Clear::unknown());
    }

    fn end_at(&mut self, t: R, _: u64) -> Result<(), StepError> {
        let h = self.clock.step_size();
        let outcome = self.shorten_to(t);
        // Restore the step size after an error, too.
        self.set_step_size(h);
        outcome
    }
    /// Repeats all but the last one of the steps since the kept point. Without the history of earlier steps, the last bits may differ.
    fn before(&self) -> Option<Self> {
        let Past { x, clock, inside, steps } = self.past;
        let repeated = steps.checked_sub(1)?;
        let mut run = self.clone();
        (run.x, run.clock, run.inside) = (x, clock, inside);
        (run.memory, run.past) = (M::memory(&x.z), Past::none());
        run.taken -= steps;
        run.advance_in_blocks(repeated).ok()?;
        Some(run)
    }
    /// A very short step amplifies the rounding errors of rough momenta. The partial step then starts from the farther end.
    fn between(before: &Self, after: &Self, t: R) -> Result<StateOf<S, R>, StepError> {
        let nearer = signed(t - before.now()).abs() < signed(t - after.now()).abs();
        let mut copy = if M::HANDLING.is_rough_if_short && nearer { after.clone() } else { before.clone() };
        copy.shorten_to(t)?;
        Ok(copy.state())
    }

    #[cfg(feature = "alloc")]
    fn name(&self) -> Name {
        self.method.name()
    }
    #[cfg(feature = "alloc")]
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.clock.record(tape);
        tape.steps(&mut self.taken);
        tape.steps(&mut self.given);
        tape.steps(&mut self.set);
        tape.flag(&mut self.inside);
        if M::HANDLING.keeps_invariants {
            tape.array(&mut self.origin);
        }
        self.x.record(tape);
        self.memory.record(tape);
    }
    #[cfg(feature = "alloc")]
    fn complete(&mut self) -> bool {
        self.prepared = self.method.prepare(&self.system, self.clock.step_size());
        self.past = Past::none();
        self.examine_if_outside();
        self.x.is_finite() && self.now().magnitude() < f64::INFINITY
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> PartialSteps for Fixed<S, M, R, C> {
    fn order(&self) -> u32 {
        self.method.claims().order
    }
}

impl<S: PhaseSpace<R> + Debug, M: Method<S, R> + Debug, R: Real, C: Summation<S::Phase> + Debug> Debug
    for Fixed<S, M, R, C>
{
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut run = f.debug_struct("Integrator");
        run.field("system", &self.system).field("method", &self.method).field("clock", &self.clock);
        run.field("x", &self.state_point()).field("steps", &self.taken).finish_non_exhaustive()
    }
}
