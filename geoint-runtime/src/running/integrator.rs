//! A system under a method: the object that users step.

use super::watch::{Found, Watch};
use crate::method::{Clock, Method, Probe, Refusal};
use crate::running::error::StepError;
use crate::scalar::{Real, zero};
use crate::space::{Action, Coordinates};
use crate::space::{Compensated, Plain, Point, Summation, WithoutAction};
use crate::system::{Conformal, Hamiltonian, PhaseSpace, StateOf, singular_time};

/// Steps between two looks at whether the state is still finite. A number that is not finite stays so under every flow
/// q ← q + …, p ← p + …, so looking now and then misses nothing; the price of a look is paid once in so many steps.
const STEPS_BETWEEN_LOOKS: u64 = 1024;

/// A system under a method with a step size: a plain value, no borrow, no allocation.
///
/// Time is `t0 + n·h`, never a running sum. After an error the last good state is still there, and the next call may go
/// on, with a smaller step if [`Integrator::set_step_size`] was called.
#[derive(Clone, Copy, Debug)]
pub struct Integrator<S: PhaseSpace<R>, M: Method<S, R>, R: Real = f64, C = Plain> {
    system: S,
    method: M,
    prepared: M::Prepared,
    t0: R,
    h: R,
    /// Steps since `t0`.
    n: u64,
    /// Steps since the beginning.
    steps: u64,
    x: Point<S::Array, C, S::Action>,
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real> Integrator<S, M, R> {
    /// A system under a method, with step size `h` (negative to go back in time), from `state` on.
    ///
    /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
    pub fn new(system: S, method: M, h: R, state: StateOf<S, R>) -> Self {
        let (t0, q, p, s) = S::Action::parts(state);
        Integrator {
            system,
            method,
            prepared: method.prepare(&system, h),
            t0,
            h,
            n: 0,
            steps: 0,
            x: Point::with_action(q.into_array(), p.into_array(), s),
        }
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Array>> Integrator<S, M, R, C> {
    /// One step.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then unchanged.
    pub fn step(&mut self) -> Result<(), StepError> {
        self.advance(1)
    }

    /// `n` steps: the bare loop, with last and first flows of neighbouring steps merged where the method has such.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one.
    #[inline]
    pub fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.check_start()?;
        let mut left = n;
        while left > 0 {
            let steps = left.min(STEPS_BETWEEN_LOOKS);
            let (mut prepared, mut x) = (self.prepared, self.x);
            let outcome = M::advance(&mut prepared, &self.clock(), steps, &mut x);
            if outcome.is_ok() && self.is_good(steps, &x) && self.singular_time(steps).is_none() {
                self.accept(steps, prepared, x);
            } else {
                self.creep(steps)?;
            }
            left -= steps;
        }
        Ok(())
    }

    /// The same steps one by one, each watched, to stop at the last good state and to say why.
    #[cold]
    fn creep(&mut self, steps: u64) -> Result<(), StepError> {
        for _ in 0..steps {
            let (mut prepared, mut x) = (self.prepared, self.x);
            let mut watch = Watch::new(&self.system, self.time(), &self.x);
            let outcome = M::step(&mut prepared, self.time(), &mut x, &mut watch);
            let (t, singular) = (real(self.time()), self.singular_time(1));
            if outcome.is_ok() && self.is_good(1, &x) {
                if let Some(what) = singular {
                    return Err(StepError::OutsideDomain { t, what });
                }
                self.accept(1, prepared, x);
                continue;
            }
            watch.look(self.clock().at(1), &x.q, &x.p, &x.s);
            return Err(match (outcome, watch.reason(outcome.err())) {
                (_, Some(Found::OutsideDomain(what))) => StepError::OutsideDomain { t, what },
                (_, Some(Found::Pole(piece))) => StepError::Pole { t, piece },
                (Ok(()) | Err(Refusal::OutsideDomain { .. }), None) => StepError::NonFinite { t },
                (Err(Refusal::Singular), None) => StepError::Singular { t },
                (Err(Refusal::SingularDirection), None) => StepError::SingularDirection { t },
                (Err(Refusal::NotConverged { iterations, correction }), None) => {
                    StepError::NotConverged { t, iterations, correction }
                }
            });
        }
        Ok(())
    }

    fn check_start(&self) -> Result<(), StepError> {
        let h = self.h.magnitude();
        if !(h > 0.0 && h < f64::INFINITY) {
            return Err(StepError::InvalidStepSize { h: real(self.h) });
        }
        if !(self.t0.magnitude() < f64::INFINITY && self.x.is_finite()) {
            return Err(StepError::NonFiniteState { t: real(self.time()) });
        }
        // Later states are good because the steps that led to them were.
        if self.steps == 0
            && let Some(what) = self.system.outside_domain(self.t0, &self.x.q, &self.x.p, &self.x.s)
        {
            return Err(StepError::OutsideDomain { t: real(self.t0), what });
        }
        Ok(())
    }

    /// Whether a state is finite, and the energy defined there.
    #[inline(always)]
    fn is_good(&self, steps: u64, x: &Point<S::Array, C, S::Action>) -> bool {
        x.is_finite() && self.system.outside_domain(self.clock().at(steps) + x.ahead, &x.q, &x.p, &x.s).is_none()
    }

    /// The first coefficient, if any, that is singular at a time within one of the next steps.
    #[inline(always)]
    fn singular_time(&self, steps: u64) -> Option<&'static str> {
        singular_time(&self.system, [self.clock().at(0), self.clock().at(steps)])
    }

    #[inline(always)]
    fn accept(&mut self, steps: u64, prepared: M::Prepared, x: Point<S::Array, C, S::Action>) {
        (self.prepared, self.x) = (prepared, x);
        self.n += steps;
        self.steps += steps;
    }

    #[inline(always)]
    fn clock(&self) -> Clock<R> {
        Clock { t0: self.t0, h: self.h, first: self.n }
    }

    /// Changes the step size; time goes on from here.
    pub fn set_step_size(&mut self, h: R) {
        (self.t0, self.x.ahead) = (self.time(), zero());
        self.n = 0;
        self.h = h;
        self.prepared = self.method.prepare(&self.system, h);
    }

    /// The step size.
    pub fn step_size(&self) -> R {
        self.h
    }

    /// `t0 + n·h`.
    pub fn time(&self) -> R {
        // Without steps even an unusable step size leaves time alone.
        if self.n == 0 { self.t0 } else { self.clock().at(0) + self.x.ahead }
    }

    /// The state now.
    pub fn state(&self) -> StateOf<S, R> {
        let (q, p) = (Coordinates::from_array(self.x.q), Coordinates::from_array(self.x.p));
        S::Action::state(self.time(), q, p, if C::ACTION { self.x.s } else { S::Action::unknown() })
    }

    /// The energy now.
    pub fn energy(&self) -> R {
        let s = if C::ACTION { self.x.s } else { S::Action::unknown() };
        self.system.hamiltonian(self.time(), &self.x.q, &self.x.p, &s)
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
    /// Output never changes the step: the last state is at `t` only if `t` is a whole number of steps away.
    pub fn until(&mut self, t: R) -> Samples<'_, S, M, R, C> {
        // Counted from t₀, as time is. A whole number of steps may come out a few roundings short.
        let (from, h) = (real(self.t0), real(self.h));
        let total = (real(t) - from) / h;
        let rounding = 4.0 * R::epsilon() * (total.abs() + (real(t).abs() + from.abs()) / h.abs());
        let left = ((total + rounding) as u64).saturating_sub(self.n);
        // An unusable step size gets one attempt, to report it.
        let usable = h != 0.0 && h.is_finite();
        Samples { sim: self, stride: 1, left: if usable { left } else { 1 } }
    }

    /// The state after every `k` steps, without end. `k` = 0 counts as 1.
    pub fn sampled(&mut self, k: u64) -> Samples<'_, S, M, R, C> {
        Samples { sim: self, stride: k.max(1), left: u64::MAX }
    }
}

impl<S: Hamiltonian<R>, M: Method<S, R>, R: Real, C: Summation<S::Array>> Integrator<S, M, R, C> {
    /// The same with compensated sums: what adding an increment to a coordinate rounds off is carried to the next step. The
    /// error of rounding grows with the number of steps many times more slowly; a step costs a few additions a coordinate more.
    pub fn compensated(self) -> Integrator<S, M, R, Compensated<S::Array>> {
        let Integrator { system, method, prepared, t0, h, n, steps, x } = self;
        Integrator { system, method, prepared, t0, h, n, steps, x: x.with_sums() }
    }
}

impl<S: Conformal<R>, M: Method<S, R>, R: Real> Integrator<S, M, R> {
    /// The same without the action, which does not act back on positions and momenta: splittings do not compute it, nor what only
    /// it needs, such as the value of the potential. In states it is not a number.
    pub fn without_action(self) -> Integrator<S, M, R, WithoutAction> {
        let Integrator { system, method, prepared, t0, h, n, steps, x } = self;
        Integrator { system, method, prepared, t0, h, n, steps, x: x.with_sums() }
    }
}

/// A scalar as a plain number, with its sign.
pub(crate) fn real<R: Real>(x: R) -> f64 {
    if x.any_below(0.0) { -x.magnitude() } else { x.magnitude() }
}

/// States along a trajectory; ends after the first error.
pub struct Samples<'a, S: PhaseSpace<R>, M: Method<S, R>, R: Real, C = Plain> {
    sim: &'a mut Integrator<S, M, R, C>,
    stride: u64,
    left: u64,
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Array>> Iterator for Samples<'_, S, M, R, C> {
    type Item = Result<StateOf<S, R>, StepError>;

    fn next(&mut self) -> Option<Self::Item> {
        self.left = self.left.checked_sub(1)?;
        let outcome = self.sim.advance(self.stride);
        if outcome.is_err() {
            self.left = 0;
        }
        Some(outcome.map(|()| self.sim.state()))
    }
}
