//! Steps as long as their error allows.
//!
//! What a method keeps for every h it keeps here as well: the energy under a discrete gradient, a projection, a relaxation.
//! What rests on equal steps is lost: a symplectic method drifts like any other.

use super::watch::{Found, Watch};
use crate::method::corrected::invariants::plus;
use crate::method::{Clock, Method, Probe, Step, Unwatched};
use crate::running::error::{Reason, StepError};
use crate::running::output::{Samples, Until};
use crate::running::step_size::{Bounds, Controller};
use crate::running::tolerance::{Judged, Tolerance};
use crate::running::trajectory::Trajectory;
use crate::scalar::{Real, signed, zero};
use crate::space::Array;
use crate::space::Snapshot;
use crate::space::{Compensated, DoubleWord, Point};
use crate::system::{StateOf, VectorField};

/// A point whose sums outlive a change of the step size.
type Carried<A> = Point<A, Compensated<A>>;

/// A system under a method whose steps adapt to a tolerance: a plain value, no borrow, no allocation.
///
/// Every step is done in two halves, which are kept, and once as a whole. Their difference in every coordinate may be as large as
/// `tolerance` times the largest magnitude that this coordinate has had so far, and as an absolute error beside that
/// ([`absolute`](Self::absolute)): lengths and angles, large and small motions are each followed with the same relative accuracy,
/// in any units. A coordinate at rest at zero is measured by what it becomes. What the tolerated errors of other coordinates cause
/// in a coordinate within the time in which the state changes is tolerated there as well, so that a wave that has not arrived, or a
/// node that is rounding, does not hold up the others; this is measured in the first steps, while they become longer.
///
/// The difference is the error of the whole step; for a method of order p the error of the halves is a 2ᵖ-th part of it, which is
/// not counted on, because it holds for short steps only. A step that is too inaccurate, or that the method refuses, is repeated
/// with a shorter one; after an error the last good state is still there.
///
/// Steps come in lengths 2^(k/4), so that most have the length of the one before: coefficients are then at hand, and implicit
/// methods know how to guess. Sums of coordinates and of time are compensated.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Planar pendulum; q in rad, p in kg m²/s.
/// #[hamiltonian]
/// fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
///     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
/// }
///
/// let system = Pendulum { m: 0.7, l: 1.2, g: 9.81 };
/// let mut sim = system.adaptive(DOP853, 1e-10, State::new(3.1, 0.0));
/// // Almost upside down it takes long steps, and short ones on the way down.
/// sim.advance_to(10.0)?;
/// assert_eq!(sim.time(), 10.0);
/// # Ok::<(), StepError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Adaptive<S: VectorField<R>, M: Method<S, R>, R: Real = f64> {
    system: S,
    method: M,
    tolerance: Tolerance<S::Phase>,
    /// Steps on the way to a time.
    most_steps: u64,
    bounds: Bounds,
    controller: Controller,
    prepared: Prepared<M::Prepared>,
    /// Of steps as a whole, and of their halves.
    memory: [M::Memory; 2],
    clock: Clock<R>,
    x: Carried<S::Phase>,
    steps: u64,
    rejections: u64,
}

/// Coefficients of a step as a whole, and of its halves.
#[derive(Clone, Debug)]
struct Prepared<P> {
    h: f64,
    whole: P,
    half: P,
}

impl<S: VectorField<R>, M: Method<S, R>, R: Real> Adaptive<S, M, R> {
    /// A system under a method, with steps as long as the tolerance of a step's error allows, from `state` on.
    ///
    /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
    pub fn new(system: S, method: M, tolerance: f64, state: StateOf<S, R>) -> Self {
        let (t, z, ()) = state.parts();
        let x = Carried::new(z);
        let controller = Controller::new(method.claims().order);
        let mut sim = Adaptive {
            system,
            method,
            tolerance: Tolerance::new(tolerance, &x.z),
            most_steps: u64::MAX,
            bounds: Bounds::default(),
            controller,
            prepared: prepare(&system, &method, 1.0),
            memory: [M::memory(), M::memory()],
            clock: Clock::new(t, zero()),
            x,
            steps: 0,
            rejections: 0,
        };
        sim.controller.start(sim.guess(), tolerance);
        sim
    }

    /// Steps between two lengths only. Without bounds the shortest is what changes time at all.
    ///
    /// The last step on the way to a given time may be shorter.
    pub fn steps_between(mut self, shortest: f64, longest: f64) -> Self {
        self.bounds = Bounds { shortest: shortest.abs(), longest: longest.abs() };
        self
    }

    /// The first step; negative to go back in time. Without it one is guessed, forwards.
    pub fn first_step(mut self, h: f64) -> Self {
        self.controller.set(h);
        self
    }

    /// Errors that are tolerated beside those relative to coordinates: one for each coordinate, in its unit, written as a state is.
    /// Without this they are zero.
    pub fn absolute(mut self, errors: StateOf<S, R>) -> Self {
        let (_, z, ()) = errors.parts();
        self.tolerance.absolute(z);
        self
    }

    /// At most so many steps in one [`advance_to`](Self::advance_to). Without this there is no limit.
    pub fn steps_at_most(mut self, steps: u64) -> Self {
        self.most_steps = steps;
        self
    }

    /// In how long, roughly, the state changes by itself: the shortest of |x|/|x'| over all coordinates that move.
    fn guess(&self) -> f64 {
        let time = |(x, rate): (&R, &R)| {
            if x.magnitude() > 0.0 { x.magnitude() / rate.magnitude() } else { f64::INFINITY }
        };
        let rates = self.rate(&self.x.z);
        self.x.z.as_slice().iter().zip(rates.as_slice()).map(time).fold(f64::INFINITY, f64::min)
    }

    fn rate(&self, z: &S::Phase) -> S::Phase {
        let mut rate = S::Phase::zero();
        self.system.rate(self.time(), z, &mut rate);
        rate
    }

    /// What part of the time in which the state changes a step takes.
    fn part(&self) -> f64 {
        self.controller.part(self.tolerance.relative)
    }

    /// One step, of whatever length the tolerance allows.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then unchanged.
    pub fn step(&mut self) -> Result<(), StepError> {
        self.check_start()?;
        self.step_within(f64::INFINITY)
    }

    /// Steps to the time `t`, before or after now: the last one ends there.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one.
    pub fn advance_to(&mut self, t: R) -> Result<(), StepError> {
        let left = self.clock.left(t);
        if left.is_infinite() {
            return Err(StepError::InvalidStepSize { h: left });
        }
        let last = self.steps.saturating_add(self.most_steps);
        while self.time() != t {
            if self.steps >= last {
                return Err(StepError::TooManySteps { t: signed(self.time()), steps: self.most_steps });
            }
            self.step_towards(t)?;
        }
        Ok(())
    }

    /// One step to the time `t`, before or after now, or towards it; `false` if that is now.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then unchanged. A `t` that is not a number is a step size that is none.
    pub fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        if self.time() == t {
            return Ok(false);
        }
        self.check_start()?;
        let left = self.clock.left(t);
        if left.is_nan() {
            return Err(StepError::InvalidStepSize { h: left });
        }
        self.controller.turn(left < 0.0);
        self.step_within(left.abs())?;
        // Methods that scale their steps end a little beside it, and take another one.
        if self.clock.left(t).abs() <= R::epsilon() * (signed(t).abs() + self.step_size().abs()) {
            self.clock = Clock::new(t, zero());
        }
        Ok(true)
    }

    /// The state after every step to the time `t`, before or after now: the last one is there.
    pub fn until(&mut self, t: R) -> Until<'_, Self> {
        Until::new(self, t)
    }

    /// The state after every `k` steps, without end. `k` = 0 counts as 1.
    pub fn sampled(&mut self, k: u64) -> Samples<'_, Self> {
        Samples::new(self, k)
    }

    /// `n` steps, of whatever lengths the tolerance allows.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one.
    pub fn advance(&mut self, n: u64) -> Result<(), StepError> {
        (0..n).try_for_each(|_| self.step())
    }

    /// A step that is not longer than `left`.
    fn step_within(&mut self, left: f64) -> Result<(), StepError> {
        let t = signed(self.time());
        let bounds = self.bounds.at(t, R::epsilon());
        loop {
            let regular = self.controller.step(&bounds);
            let h = if regular.abs() < left { regular } else { left.copysign(regular) };
            if h == regular && h != self.prepared.h {
                self.prepared = prepare(&self.system, &self.method, h);
                self.memory = [M::memory(), M::memory()];
            }
            let shorter;
            let (prepared, before) = if h == regular {
                (&self.prepared, self.memory.clone())
            } else {
                shorter = prepare(&self.system, &self.method, h);
                (&shorter, [M::memory(), M::memory()])
            };
            let mut memory = before.clone();
            let mut outcome = self.attempt(prepared, &mut memory, &mut Unwatched);
            // Only a watched step searches for a solution that is hard to find.
            if matches!(outcome, Err(Reason::NotConverged)) {
                memory = before;
                outcome = self.attempt(prepared, &mut memory, &mut Watch::new(&self.system, self.time(), &self.x));
            }
            let (x, error) = match outcome {
                Ok((x, error)) if error <= 1.0 => (x, error),
                outcome => {
                    self.rejections += 1;
                    self.controller.reject(h, outcome.map_or(None, |(_, error)| Some(error)));
                    if h.abs() <= bounds.shortest {
                        // At the edge of a domain the shortest step may find no solution where longer ones find the edge.
                        let reason = match self.reason(h) {
                            Reason::NotConverged | Reason::Singular => self.reason(16.0 * h),
                            reason => reason,
                        };
                        return Err(StepError::StepTooSmall { t, h, reason });
                    }
                    continue;
                }
            };
            if h == regular {
                self.memory = memory;
                self.controller.accept(h, error);
            }
            self.clock.pass_step(R::from_f64(h), x.ahead);
            let (mut tolerance, part) = (self.tolerance, self.part());
            tolerance.include([&self.x.z, &x.z], h, part, |z| self.rate(z));
            self.tolerance = tolerance;
            self.x = x;
            self.x.ahead = DoubleWord::new(zero());
            self.steps += 1;
            return Ok(());
        }
    }

    /// A step in two halves, and its estimated error in units of what is tolerated.
    fn attempt<P: Probe<S, R>>(
        &self,
        prepared: &Prepared<M::Prepared>,
        [memory_of_whole, memory_of_halves]: &mut [M::Memory; 2],
        probe: &mut P,
    ) -> Result<(Carried<S::Phase>, f64), Reason> {
        let half = R::from_f64(0.5 * prepared.h);
        let (mut x, mut whole) = (self.x, self.x);
        let system = &self.system;
        M::step(&prepared.whole, memory_of_whole, Step { system, t: self.time(), x: &mut whole, probe })?;
        for end in [half, half + half] {
            let start = self.time() + (end - half) + x.ahead.value();
            M::step(&prepared.half, memory_of_halves, Step { system, t: start, x: &mut x, probe })?;
            if !x.is_finite() {
                return Err(Reason::NonFinite);
            }
            if let Some(what) = self.system.outside_domain(self.time() + end + x.ahead.value(), &x.z, &()) {
                return Err(Reason::OutsideDomain { what });
            }
        }
        let mut gap = plus(x.z, -1.0, &whole.z);
        // Where a method scales its steps, the two are at different times.
        let late = x.ahead.value() - whole.ahead.value();
        if late.magnitude() != 0.0 {
            gap.add_scaled(-late, &self.rate(&x.z));
        }
        // The step as a whole may have led to what is not a number.
        if !gap.is_finite() {
            return Err(Reason::NonFinite);
        }
        let step = Judged { part: self.part(), before: &self.x.z, after: &x.z, gap: &gap };
        let error = self.tolerance.error(&step, |z| self.rate(z));
        Ok((x, error))
    }

    /// Why a step is refused: once more, watched.
    #[cold]
    fn reason(&self, h: f64) -> Reason {
        let mut watch = Watch::new(&self.system, self.time(), &self.x);
        let outcome =
            self.attempt(&prepare(&self.system, &self.method, h), &mut [M::memory(), M::memory()], &mut watch);
        match outcome {
            Ok((_, error)) => Reason::Inaccurate { error },
            Err(reason @ Reason::OutsideDomain { .. }) => reason,
            Err(reason) => match watch.reason(None) {
                Some(Found::OutsideDomain(what)) => Reason::OutsideDomain { what },
                Some(Found::Pole(piece)) => Reason::Pole { piece },
                None => reason,
            },
        }
    }

    fn check_start(&self) -> Result<(), StepError> {
        if let Some(tolerance) = self.tolerance.unusable() {
            return Err(StepError::InvalidTolerance { tolerance });
        }
        if let Some(h) = self.bounds.unusable().or(self.controller.unusable()) {
            return Err(StepError::InvalidStepSize { h });
        }
        let t = signed(self.time());
        if !(t.is_finite() && self.x.is_finite()) {
            return Err(StepError::NonFiniteState { t });
        }
        // Later states are good because the steps that led to them were.
        match self.system.outside_domain(self.time(), &self.x.z, &()) {
            Some(what) if self.steps == 0 => Err(StepError::OutsideDomain { t, what }),
            _ => Ok(()),
        }
    }

    /// Time now.
    pub fn time(&self) -> R {
        self.clock.now(zero())
    }

    /// The state now.
    pub fn state(&self) -> StateOf<S, R> {
        S::State::of(self.time(), self.x.z, ())
    }

    /// The energy now.
    pub fn energy(&self) -> R {
        self.system.hamiltonian(self.time(), &self.x.z, &())
    }

    /// The length of the next step, if the tolerance allows it and no time to end at is nearer.
    pub fn step_size(&self) -> f64 {
        self.controller.step(&self.bounds.at(signed(self.time()), R::epsilon()))
    }

    /// The number of steps taken, each in two halves.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The number of steps that were tried and not taken.
    pub fn rejections(&self) -> u64 {
        self.rejections
    }

    /// The system with its parameters.
    pub fn system(&self) -> &S {
        &self.system
    }

    /// The method.
    pub fn method(&self) -> &M {
        &self.method
    }
}

fn prepare<S: VectorField<R>, M: Method<S, R>, R: Real>(system: &S, method: &M, h: f64) -> Prepared<M::Prepared> {
    let prepare = |h: f64| method.prepare(system, R::from_f64(h));
    Prepared { h, whole: prepare(h), half: prepare(0.5 * h) }
}

impl<S: VectorField<R>, M: Method<S, R>, R: Real> Trajectory for Adaptive<S, M, R> {
    type State = StateOf<S, R>;

    fn step(&mut self) -> Result<(), StepError> {
        self.step()
    }
    fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.advance(n)
    }
    fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.step_towards(t)
    }
    fn advance_to(&mut self, t: R) -> Result<(), StepError> {
        self.advance_to(t)
    }
    fn time(&self) -> R {
        self.time()
    }
    fn state(&self) -> Self::State {
        self.state()
    }
    fn energy(&self) -> R {
        self.energy()
    }
    fn steps(&self) -> u64 {
        self.steps
    }
}
