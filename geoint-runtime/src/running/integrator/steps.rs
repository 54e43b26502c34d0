//! How a step of fixed length goes, whether its end is good, and why it is refused.

use crate::method::{Clock, Method, Probe, Step, Unwatched};
use crate::running::error::StepError;
use crate::running::settle::{STEPS_BETWEEN_LOOKS, settled, settles};
use crate::running::watch::Watch;
use crate::scalar::{Real, signed, zero};
use crate::space::{Array, PerCoordinate, Point, Snapshot, Summation, wrong_length};
use crate::system::{Clear, PhaseSpace, Unmet, jump_on_way};

/// A system under a method, and where it is.
#[derive(Clone)]
pub(super) struct Steps<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C> {
    pub(super) system: S,
    pub(super) method: M,
    pub(super) prepared: M::Prepared,
    pub(super) memory: M::Memory,
    pub(super) clock: Clock<R>,
    /// Steps since the beginning.
    pub(super) taken: u64,
    /// How many there were when the user gave a state.
    pub(super) given: u64,
    /// How many there were when the state was set, by the user or at an event.
    pub(super) set: u64,
    /// The state that the user gave, whose invariants the steps keep.
    pub(super) origin: S::Phase,
    /// The point of a state, or where there is another one that the method moves, that one from the first step on.
    pub(super) x: Point<S::Phase, C, S::Action>,
    /// Whether it is the one that the method moves.
    pub(super) inside: bool,
    /// What is known of poles in time.
    pub(super) clear: Clear<R>,
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Steps<S, M, R, C> {
    /// One step.
    #[inline(always)]
    pub(super) fn step(&mut self) -> Result<(), StepError> {
        self.check_start()?;
        self.step_within(None).map(drop)
    }

    /// `n` steps: the bare loop.
    #[inline]
    pub(super) fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.check_start()?;
        if M::SINGLY && n == 1 {
            return self.single();
        }
        let (mut left, mut singly) = (n, 0);
        while left > 0 {
            let steps = if singly > 0 { 1 } else { left.min(self.steps_to_look()) };
            let (mut memory, mut x) = (self.memory.clone(), self.x);
            self.enter(&mut x);
            if self.run(steps, &mut memory, &mut x) && self.pole_in_time(steps, &x).is_none() {
                (self.memory, self.x, self.inside) = (memory, x, true);
                self.pass(steps);
            } else if steps > 1 {
                // To stop where single steps do: here, because a step may be long, and stands once then.
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

    /// One step, of a method that takes it with less work than many.
    #[inline(never)]
    fn single(&mut self) -> Result<(), StepError> {
        self.step_within(None).map(drop)
    }

    /// So many steps from `x` on; whether they are good. Where one has to be examined that is every one, else the last end shows it. In a function of
    /// its own, whatever the caller does: there loops are arranged as in a program with this system and method alone.
    #[inline(never)]
    fn run(&self, steps: u64, memory: &mut M::Memory, x: &mut Point<S::Phase, C, S::Action>) -> bool {
        let (mut clock, mut taken) = (self.clock, 0);
        // Copies in local variables: what a pointer leads to would be in memory in each step.
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

    /// Steps until the state is kept, to go back to.
    #[inline(always)]
    fn steps_to_look(&self) -> u64 {
        if const { settles::<S, M, R>() } {
            // It is settled after the same steps, in whatever numbers those are asked for.
            STEPS_BETWEEN_LOOKS - self.taken % STEPS_BETWEEN_LOOKS
        } else {
            STEPS_BETWEEN_LOOKS
        }
    }

    /// One step that does not end beyond `limit`; else `false`.
    #[inline(always)]
    pub(super) fn step_within(&mut self, limit: Option<R>) -> Result<bool, StepError> {
        // In place: one copy of the state, for steps that are refused, in place of two, and none of what the method remembers, which may be much.
        let ([t, end], start) = (self.clock.ends(0, self.x.ahead.value()), self.x);
        let memory = (M::SCALES_STEPS && limit.is_some()).then(|| self.memory.clone());
        if M::INNER {
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
            self.inside = true;
            self.pass(1);
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

    /// A step that was refused, without what the method remembers of those before it, and watched, to say why it is refused, if it is again.
    #[cold]
    fn step_anew(&mut self, limit: Option<R>) -> Result<bool, StepError> {
        self.memory = M::memory();
        let (mut memory, mut x) = (M::memory(), self.x);
        let mut watch = Watch::new(&self.system, self.time(), &self.seen());
        self.enter(&mut x);
        let begun = x;
        let [t, end] = self.clock.ends(0, x.ahead.value());
        let step = Step { system: &self.system, t, end, x: &mut x, probe: &mut watch };
        let outcome = M::step(&self.prepared, &mut memory, step);
        let t = signed(self.time());
        if outcome.is_ok() && self.is_good(1, &x) {
            if let Some(what) = self.pole_in_time(1, &x).or_else(|| self.jump(1, [&begun, &x])) {
                return Err(StepError::OutsideDomain { t, what });
            }
            if !self.ends_within(limit, &x, self.time()) {
                return Ok(false);
            }
            (self.memory, self.x, self.inside) = (memory, x, true);
            self.pass(1);
            return Ok(true);
        }
        let end = self.seen_as(&x, self.clock.at(1));
        watch.visit(self.clock.at(1), &end, &x.s);
        Err(watch.seen().error(outcome, t))
    }

    #[inline(always)]
    pub(super) fn check_start(&self) -> Result<(), StepError> {
        let h = self.clock.step_size().magnitude();
        if !(h > 0.0 && h < f64::INFINITY) {
            return Err(StepError::InvalidStepSize { h: signed(self.clock.step_size()) });
        }
        // Later states are good because the steps that led to them were.
        if self.taken == self.given { self.check_state() } else { Ok(()) }
    }

    /// The next step examines a state to which no step has led: in what was saved the number of steps may be wrong, and all else.
    #[cfg(feature = "alloc")]
    pub(super) fn examine_if_outside(&mut self) {
        if self.system.outside_domain(self.time(), &self.seen().z, &self.x.s).is_some() {
            self.given = self.taken;
        }
    }

    #[cold]
    fn check_state(&self) -> Result<(), StepError> {
        StepError::of_parameters(&self.system)?;
        let t = signed(self.time());
        if !(t.is_finite() && self.x.is_finite()) {
            return Err(StepError::not_finite::<S, R>(self.time(), &self.x.z));
        }
        if S::State::ATTITUDES
            && let Some(length) = wrong_length::<S, R>(&self.x.z)
        {
            return Err(StepError::NotNormalised { t, length });
        }
        if let Some(what) = self.system.outside_domain(self.time(), &self.seen().z, &self.x.s) {
            return Err(StepError::OutsideDomain { t, what });
        }
        if !M::is_in_range(&self.prepared, &self.system, &self.x.z) {
            return Err(StepError::OutOfRange { t });
        }
        // A step led to the momenta of a run whose system was replaced. `DiscreteGradient` leaves them O(h²) off, so only positions are checked.
        let h_of_rates = if self.taken == self.set { self.clock.step_size() } else { zero() };
        match self.system.unmet(self.time(), h_of_rates, &self.x.z) {
            Some(Unmet::Off(what)) => Err(StepError::OffConstraint { t, what }),
            Some(Unmet::Dependent(what)) => Err(StepError::DependentConstraints { t, what }),
            None => Ok(()),
        }
    }

    /// Whether a state is finite, its time too, and the energy defined there. Where time is a number after the last step it was after all others.
    #[inline(always)]
    fn is_good(&self, steps: u64, x: &Point<S::Phase, C, S::Action>) -> bool {
        x.is_finite()
            && ((!M::INNER && M::shows(&self.prepared)) || self.is_defined(steps, x))
            && self.end(steps, x).magnitude() < f64::INFINITY
    }

    /// The same of what the user sees: the way out of the method's coordinates may lead to no finite point.
    #[inline(always)]
    fn is_defined(&self, steps: u64, x: &Point<S::Phase, C, S::Action>) -> bool {
        let t = self.end(steps, x);
        let z = self.seen_as(x, t);
        (!M::INNER || Array::is_finite(&z)) && self.system.outside_domain(t, &z, &x.s).is_none()
    }

    /// From the point of a state to the one that the method moves, if it is not there yet.
    #[inline(always)]
    fn enter(&self, x: &mut Point<S::Phase, C, S::Action>) {
        if M::INNER && !self.inside {
            M::enter(&self.prepared, &self.system, self.time(), &mut x.z);
        }
    }

    /// The point of the state at time `t` that the method has as `x`.
    #[inline(always)]
    fn seen_as(&self, x: &Point<S::Phase, C, S::Action>, t: R) -> S::Phase {
        let mut z = x.z;
        if M::INNER {
            M::leave(&self.prepared, &self.system, t, &mut z);
        }
        z
    }

    /// The point of the state now.
    #[inline(always)]
    pub(super) fn seen(&self) -> Point<S::Phase, C, S::Action> {
        let mut x = self.x;
        if M::INNER && self.inside {
            x.z = self.seen_as(&x, self.time());
        }
        x
    }

    /// The same, and the next step enters again: with other coefficients, perhaps.
    pub(super) fn leave(&mut self) {
        if M::INNER && self.inside {
            // What the method's coordinates were rounded by is none of these.
            let (ahead, x) = (self.x.ahead, self.seen());
            self.x = Point { ahead, ..Point::with_action(x.z, x.s) };
            self.inside = false;
        }
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

    /// The first pole, if any, at a time within one of the next steps, which lead to `x`.
    #[inline(always)]
    fn pole_in_time(&mut self, steps: u64, x: &Point<S::Phase, C, S::Action>) -> Option<&'static str> {
        let way = [self.end(0, &self.x), self.end(steps, x)];
        self.clear.pole(&self.system, way)
    }

    /// A jump of the energy on the way of the last of so many steps, between two points of the method; one that keeps the energy takes it along.
    #[inline(always)]
    fn jump(&self, steps: u64, ends: [&Point<S::Phase, C, S::Action>; 2]) -> Option<&'static str> {
        if S::CONTINUOUS || self.method.claims().conserves_energy {
            return None;
        }
        let moment = |steps: u64, x: &Point<S::Phase, C, S::Action>| {
            let t = self.end(steps, x);
            (t, PerCoordinate { z: self.seen_as(x, t), s: x.s })
        };
        jump_on_way(&self.system, &[moment(steps - 1, ends[0]), moment(steps, ends[1])], 0.0)
    }

    #[inline(always)]
    fn pass(&mut self, steps: u64) {
        self.clock.pass(steps);
        self.taken += steps;
        if const { settles::<S, M, R>() } && self.taken.is_multiple_of(STEPS_BETWEEN_LOOKS) {
            self.settle();
        }
    }

    /// Takes away what rounding has changed over many steps, if that leads to a point of the domain.
    #[cold]
    #[inline(never)]
    fn settle(&mut self) {
        let x = settled::<S, M, R, C>((&self.system, &self.prepared), &self.origin, &self.x);
        if self.is_good(0, &x) {
            self.x = x;
        }
    }

    /// `t0 + n·h`.
    #[inline(always)]
    pub(super) fn time(&self) -> R {
        self.clock.now(self.x.ahead.value())
    }
}
