//! An end of a step with the coefficients of the solution there, and the states between two ends.

use super::Series;
use crate::method::Clock;
use crate::scalar::{Real, zero};
use crate::space::{Array, Compensated, PerCoordinate, Point, Snapshot};
use crate::system::{Jets, PhaseSpace, StateOf};
use crate::taylor::{self, TaylorMethod};

/// Units of time, tried in this order if the first coefficients give no time of change because they overflow or vanish.
const FAR: [f64; 3] = [1.0 / (1_u128 << 100) as f64, (1_u128 << 100) as f64, 1.0];

/// Approximate number of steps in a radius of convergence, at order 20.
const STEPS_PER_RADIUS: f64 = 8.0;

/// A point with compensated sums.
pub(super) type Carried<S, R> =
    Point<<S as PhaseSpace<R>>::Phase, Compensated<<S as PhaseSpace<R>>::Phase>, <S as PhaseSpace<R>>::Action>;

/// A point at a time, with the coefficients of the solution there.
#[derive(Clone, Debug)]
pub(in crate::running) struct Expansion<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> {
    pub(in crate::running) x: Carried<S, R>,
    pub(in crate::running) clock: Clock<R>,
    /// History of the method, if it corrects the ends of steps.
    pub(super) memory: M::Memory,
    /// Unit of time of the coefficients, a power of two.
    pub(in crate::running) unit: f64,
    /// Coefficients of the state, from order 1 on.
    pub(in crate::running) jet: M::Orders<PerCoordinate<S::Phase, S::Action>>,
    /// Coefficients of the functions that decide conditions, from order 0 on.
    pub(super) switches: M::Orders<S::Switches>,
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Expansion<S, M, R> {
    /// Returns a point whose coefficients are not computed yet.
    pub(super) fn new(t: R, (z, s): (S::Phase, S::Action)) -> Self {
        Expansion {
            x: Point::with_action(z, s),
            clock: Clock::new(t, zero()),
            memory: M::memory(&z),
            unit: 1.0,
            jet: M::fill(PerCoordinate::zero()),
            switches: M::fill(S::Switches::zero()),
        }
    }

    pub(in crate::running) fn time(&self) -> R {
        self.clock.now(zero())
    }

    /// Returns coordinate `i`; the action is the last one.
    pub(in crate::running) fn coordinate(&self, i: usize) -> R {
        PerCoordinate::of(&self.x).at(i)
    }

    /// Computes the coefficients for steps of length about `h`. The unit of time is near the radius of convergence: no coefficient is then much
    /// smaller than the state.
    #[inline(always)]
    pub(super) fn expand(&mut self, order: usize, system: &S, h: f64) {
        let radius = STEPS_PER_RADIUS * h;
        self.unit = power_of_two(if radius < f64::INFINITY { radius } else { h });
        let (start, x) = ([R::from_f64(self.unit), self.time()], (&self.x.z, &self.x.s));
        M::jet(order, system, start, x, &mut self.jet, &mut self.switches);
    }

    /// Returns a length in the unit of the coefficients. The conversion is exact, because the unit is a power of two.
    #[inline(always)]
    pub(super) fn in_units(&self, h: f64) -> f64 {
        h * (1.0 / self.unit)
    }

    /// Returns the rates in another unit of time.
    #[inline(always)]
    pub(super) fn rates(&self, unit: f64) -> PerCoordinate<S::Phase, S::Action> {
        let mut rates = self.jet.as_ref()[0];
        rates.times(R::from_f64(unit / self.unit));
        rates
    }
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Series<S, M, R> {
    /// Computes the coefficients at the start of a run. At a state given by the user, they are computed in a unit in which none of them overflows. A
    /// resumed run uses the unit that it had before.
    #[cold]
    pub(super) fn begin(&mut self) {
        let (order, system, unit) = (self.terms(), self.system, self.here().unit);
        self.here_mut().expand(order, &system, unit / STEPS_PER_RADIUS);
        if self.taken == self.given {
            for unit in FAR {
                if self.pace().is_some() {
                    break;
                }
                self.here_mut().expand(order, &system, unit);
            }
            let h = self.guess();
            self.here_mut().expand(order, &system, h);
        }
        self.known = true;
    }

    /// Returns the state at a time within the last step.
    pub(in crate::running) fn state_within(&self, t: R) -> Option<StateOf<S, R>> {
        let (after, before, h) = (self.start().clock.left(t), self.here().clock.left(t), self.step);
        if !self.within {
            return None;
        }
        // The clock is more accurate than the time of an end, so compare with this time first.
        if let Some(end) = [self.here(), self.start()].into_iter().find(|end| t == end.time()) {
            return Some(S::State::of(t, end.x.z, end.x.s));
        }
        // Between the ends, in the direction of the step.
        (after * h >= 0.0 && before * h <= 0.0 && h != 0.0).then(|| self.inside(after, t))
    }

    /// Returns the state at the time `t`, which is `after` from the start of the last step.
    pub(in crate::running) fn inside(&self, after: f64, t: R) -> StateOf<S, R> {
        let start = self.start();
        let mut x = taylor::increment(&start.jet.as_ref()[..self.terms()], after / start.unit);
        x.add_scaled(R::from_f64(1.0), &PerCoordinate::of(&start.x));
        S::State::of(t, x.z, x.s)
    }
}

/// Returns the largest power of two not above a length; 1 if there is none. Products and quotients with it are exact.
#[inline(always)]
fn power_of_two(h: f64) -> f64 {
    let power = f64::from_bits(h.to_bits() & f64::INFINITY.to_bits());
    if power > 0.0 && power < f64::INFINITY { power } else { 1.0 }
}
