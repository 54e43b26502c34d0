//! Takes one trial step of a given length and estimates its error.

use super::start::grows;
use crate::method::{Clock, Method, Probe, Step, outer_step};
use crate::running::tolerance::{Judged, Tolerance};
use crate::running::watch::Watch;
use crate::scalar::Real;
use crate::solving::Failure;
use crate::space::{Compensated, PerCoordinate, Point};
use crate::system::{PhaseSpace, Rates, jump_on_way};

/// A point with compensated sums. The sums remain valid when the step size changes.
pub(super) type Carried<S, R> =
    Point<<S as PhaseSpace<R>>::Phase, Compensated<<S as PhaseSpace<R>>::Phase>, <S as PhaseSpace<R>>::Action>;

/// One number for each coordinate of a system.
type Coordinates<S, R> = PerCoordinate<<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action>;

/// Failure of a step that is marked `needs_recheck`.
const NEEDS_RECHECK: Failure = Failure::NotConverged { iterations: 0, correction: f64::INFINITY };

/// Coefficients of the method for the whole step. Also for half the step, if the error is estimated by step halving.
#[derive(Clone, Debug)]
pub(super) struct Prepared<P> {
    pub(super) h: f64,
    pub(super) whole: P,
    half: Option<P>,
}

impl<P> Prepared<P> {
    pub(super) fn new<S: PhaseSpace<R>, M: Method<S, R, Prepared = P>, R: Real>(
        system: &S,
        method: &M,
        h: f64,
    ) -> Self {
        let prepare = |h: f64| method.prepare(system, R::from_f64(h));
        let halved = method.order_of_estimate().is_none();
        Prepared { h, whole: prepare(h), half: halved.then(|| prepare(0.5 * h)) }
    }

    /// Recomputes the coefficients for step length `h`, in place. They may be large, so they are not copied.
    pub(super) fn prepare<S: PhaseSpace<R>, M: Method<S, R, Prepared = P>, R: Real>(
        &mut self,
        system: &S,
        method: &M,
        h: f64,
    ) {
        self.h = h;
        self.whole = method.prepare(system, R::from_f64(h));
        if let Some(half) = &mut self.half {
            *half = method.prepare(system, R::from_f64(0.5 * h));
        }
    }
}

/// Returns the history before the first step from the point `z`: for whole steps, and for their halves.
pub(super) fn no_history<S: PhaseSpace<R>, M: Method<S, R>, R: Real>(z: &S::Phase) -> [M::Memory; 2] {
    [M::memory(z), M::memory(z)]
}

/// The end of a trial step.
pub(super) struct Trial<S: PhaseSpace<R>, R: Real> {
    pub(super) x: Carried<S, R>,
    /// Estimated error in units of the tolerance.
    pub(super) error: f64,
}

/// Start of a trial step, and the data needed to judge its error.
pub(super) struct Attempt<'a, S: PhaseSpace<R>, R: Real> {
    pub(super) system: &'a S,
    pub(super) t: R,
    pub(super) clock: &'a Clock<R>,
    pub(super) x: &'a Carried<S, R>,
    pub(super) tolerance: &'a Tolerance<S::Phase, S::Action>,
    /// Expected step length divided by the time in which the state changes.
    pub(super) part: f64,
    /// Time in which the state changes at the start of the run.
    pub(super) time_of_start: f64,
    /// Whether the method conserves the energy, also across a jump of the energy.
    pub(super) keeps: bool,
}

impl<S: PhaseSpace<R> + Rates<R>, R: Real> Attempt<'_, S, R> {
    /// Takes a step, with the `history` of earlier steps: for whole steps, and for their halves. It is changed in place, because it may be large.
    ///
    /// # Errors
    /// Fails if the step has no result. Also fails if the energy jumps within the step and the method does not conserve it.
    #[inline(always)]
    pub(super) fn take<M: Method<S, R>, P: Probe<S, R>>(
        &self,
        method: &M,
        prepared: &Prepared<M::Prepared>,
        history: &mut [M::Memory; 2],
        probe: &mut P,
    ) -> Result<Trial<S, R>, Failure> {
        let trial = self.estimated(method, prepared, history, probe)?;
        if !self.keeps {
            let x = &trial.x;
            let ends = [(self.t, PerCoordinate::of(self.x)), (self.end(prepared.h, x), PerCoordinate::of(x))];
            Failure::outside(jump_on_way(self.system, &ends, self.tolerance.relative))?;
        }
        Ok(trial)
    }

    /// Returns the time at the end of a step of length `h` that ends at `x`.
    pub(super) fn end(&self, h: f64, x: &Carried<S, R>) -> R {
        self.clock.after(R::from_f64(h)) + x.ahead.value()
    }

    /// Checks coordinates that start at rest at zero and begin to move in this step. Their errors are not measured.
    ///
    /// Returns `Some(true)` if forces that depend on time alone drive them like a power of time throughout the step. Otherwise the step is too long
    /// to give even their order of magnitude, and the result is `Some(false)`. Returns `None` if no coordinate moves for the first time, or if time
    /// alone drives none.
    pub(super) fn growth_from_rest(&self, h: f64, x: &Carried<S, R>) -> Option<bool> {
        let [before, after] = [self.x, x].map(PerCoordinate::of);
        if !self.tolerance.is_first_motion(&after) {
            return None;
        }
        grows(self.system, self.t, &before, h / self.part)
    }

    /// Takes a step. The error comes from the method's own estimate, or else from step halving.
    fn estimated<M: Method<S, R>, P: Probe<S, R>>(
        &self,
        method: &M,
        prepared: &Prepared<M::Prepared>,
        memory: &mut [M::Memory; 2],
        probe: &mut P,
    ) -> Result<Trial<S, R>, Failure> {
        let mut x = *self.x;
        let end = self.clock.after(R::from_f64(prepared.h));
        let step = Step { system: self.system, t: self.t, end, x: &mut x, probe };
        match M::estimated::<_, P>(&prepared.whole, &mut memory[0], step) {
            None => self.halved(method, prepared, memory, probe),
            Some(estimate) => {
                let estimates = estimate?;
                self.check(R::from_f64(prepared.h), &x)?;
                let [before, after] = [self.x, &x].map(PerCoordinate::of);
                let [higher, lower] = self.judge(&before, &after, &estimates);
                // The quotient is formed first: squares of the errors may overflow.
                let ratio = if higher > 0.0 && higher < f64::INFINITY { lower / higher } else { 0.0 };
                let error = higher / Real::sqrt(1.0 + 0.01 * ratio * ratio);
                if error.is_nan() { Err(Failure::NonFinite) } else { Ok(Trial { x, error }) }
            }
        }
    }

    /// Checks the end of a step or of its first half, at time `h` after the start. The point and the time must be finite, and the point must lie in
    /// the domain of the energy.
    ///
    /// A step marked `needs_recheck` counts as not converged. Shorter steps may be marked as well.
    pub(super) fn check(&self, h: R, x: &Carried<S, R>) -> Result<(), Failure> {
        let t = self.t + h + x.ahead.value();
        if x.needs_recheck {
            return Err(NEEDS_RECHECK);
        }
        if !(x.is_finite() && t.magnitude() < f64::INFINITY) {
            return Err(Failure::NonFinite);
        }
        Failure::outside(self.system.outside_domain(t, &x.z, &x.s))
    }

    /// Returns estimated errors in units of the tolerance.
    fn judge<const N: usize>(
        &self,
        before: &Coordinates<S, R>,
        after: &Coordinates<S, R>,
        estimates: &[Coordinates<S, R>; N],
    ) -> [f64; N] {
        let step = Judged { part: self.part, before, after };
        self.tolerance.errors(&step, estimates, |x| self.system.rates(self.t, x))
    }

    /// Takes a step as two halves. The error is their difference from one whole step.
    fn halved<M: Method<S, R>, P: Probe<S, R>>(
        &self,
        method: &M,
        prepared: &Prepared<M::Prepared>,
        [memory_of_whole, memory_of_halves]: &mut [M::Memory; 2],
        probe: &mut P,
    ) -> Result<Trial<S, R>, Failure> {
        let (system, t, half) = (self.system, self.t, R::from_f64(0.5 * prepared.h));
        // A method may report an order for its estimate and still return no estimate.
        let unforeseen;
        let prepared_half = match &prepared.half {
            Some(prepared_half) => prepared_half,
            None => {
                unforeseen = method.prepare(system, half);
                &unforeseen
            }
        };
        let (mut x, mut whole) = (*self.x, *self.x);
        let [middle, end] = [half, half + half].map(|h| self.clock.after(h));
        let step = Step { system, t, end, x: &mut whole, probe };
        outer_step::<S, R, M, _, P>(&prepared.whole, memory_of_whole, step)?;
        for (h, [t, end]) in [(half, [t, middle]), (half + half, [middle, end])] {
            let [t, end] = [t, end].map(|t| t + x.ahead.value());
            let step = Step { system, t, end, x: &mut x, probe };
            outer_step::<S, R, M, _, P>(prepared_half, memory_of_halves, step)?;
            self.check(h, &x)?;
        }
        let [before, after] = [self.x, &x].map(PerCoordinate::of);
        let mut gap = after;
        gap.add_scaled(R::from_f64(-1.0), &PerCoordinate::of(&whole));
        // Methods that scale their steps may end the whole step and the two halves at different times. Compare both at the same time.
        let late = x.ahead.value() - whole.ahead.value();
        if late.magnitude() != 0.0 {
            gap.add_scaled(-late, &system.rates(t, &after));
        }
        // The whole step may have ended at a point that is not finite.
        if !gap.is_finite() {
            return Err(Failure::NonFinite);
        }
        let [error] = self.judge(&before, &after, &[gap]);
        Ok(Trial { x, error })
    }

    /// Repeats a refused step with checks of every evaluation, and returns why it is refused.
    #[cold]
    pub(super) fn failure<M: Method<S, R>>(&self, method: &M, h: f64) -> Failure {
        let mut watch = Watch::new(self.system, self.t, self.x);
        let prepared = Prepared::new(self.system, method, h);
        match self.take(method, &prepared, &mut no_history::<S, M, R>(&self.x.z), &mut watch) {
            Ok(Trial { error, .. }) => Failure::Inaccurate { error },
            Err(failure @ Failure::OutsideDomain { .. }) => failure,
            Err(failure) => watch.seen().cause().unwrap_or(failure),
        }
    }
}
