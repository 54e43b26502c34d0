//! An end of a step: the point, and the coefficients of the solution there; and the states between two of them that these give.

use super::Steps;
use crate::method::Clock;
use crate::scalar::{Real, zero};
use crate::space::{Array, Compensated, PerCoordinate, Point, Snapshot};
use crate::system::{Jets, PhaseSpace, StateOf};
use crate::taylor::{self, TaylorMethod};

/// Units of time in which coefficients tell how fast a state changes that tells nothing in its own: all of them overflow there, or vanish.
const FAR: [f64; 3] = [1.0 / (1_u128 << 100) as f64, (1_u128 << 100) as f64, 1.0];

/// Of order 20 a radius of convergence has so many steps, about.
const STEPS_PER_RADIUS: f64 = 8.0;

/// A point whose sums compensate.
pub(super) type Carried<S, R> =
    Point<<S as PhaseSpace<R>>::Phase, Compensated<<S as PhaseSpace<R>>::Phase>, <S as PhaseSpace<R>>::Action>;

/// A point at a time, and the coefficients of the solution there.
#[derive(Clone, Debug)]
pub(in crate::running) struct Expansion<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> {
    pub(in crate::running) x: Carried<S, R>,
    pub(in crate::running) clock: Clock<R>,
    /// Of the method, where it puts ends of steps right.
    pub(super) memory: M::Memory,
    /// The unit of time in the coefficients, a power of two.
    pub(in crate::running) unit: f64,
    /// From order 1 on.
    pub(in crate::running) jet: M::Orders<PerCoordinate<S::Phase, S::Action>>,
    /// From order 0 on.
    pub(super) switches: M::Orders<S::Switches>,
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Expansion<S, M, R> {
    /// A point whose coefficients are not known yet.
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

    /// The coordinate `i`, the action last.
    pub(in crate::running) fn coordinate(&self, i: usize) -> R {
        PerCoordinate::of(&self.x).at(i)
    }

    /// The coefficients, for steps of about this length. In a unit near the radius of convergence none of them is much smaller than the state.
    #[inline(always)]
    pub(super) fn expand(&mut self, order: usize, system: &S, h: f64) {
        let radius = STEPS_PER_RADIUS * h;
        self.unit = power_of_two(if radius < f64::INFINITY { radius } else { h });
        let (start, x) = ([R::from_f64(self.unit), self.time()], (&self.x.z, &self.x.s));
        M::jet(order, system, start, x, &mut self.jet, &mut self.switches);
    }

    /// A length in the unit of the coefficients. Nothing waits for the quotient, which is exact, as the product is.
    #[inline(always)]
    pub(super) fn in_units(&self, h: f64) -> f64 {
        h * (1.0 / self.unit)
    }

    /// Rates in the unit of other coefficients.
    #[inline(always)]
    pub(super) fn rates(&self, unit: f64) -> PerCoordinate<S::Phase, S::Action> {
        let mut rates = self.jet.as_ref()[0];
        rates.times(R::from_f64(unit / self.unit));
        rates
    }
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Steps<S, M, R> {
    /// The coefficients at a state that the user gave, in a unit of time in which none of them overflows, or where a run goes on, in the unit
    /// before.
    #[cold]
    pub(super) fn begin(&mut self) {
        let (order, system, unit) = (self.order(), self.system, self.here().unit);
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

    /// The state at a time within the last step.
    pub(in crate::running) fn at(&self, t: R) -> Option<StateOf<S, R>> {
        let (after, before, h) = (self.start().clock.left(t), self.here().clock.left(t), self.step);
        if !self.within {
            return None;
        }
        // The clock has digits that the time of an end does not show.
        if let Some(end) = [self.here(), self.start()].into_iter().find(|end| t == end.time()) {
            return Some(S::State::of(t, end.x.z, end.x.s));
        }
        // Between the ends, in the direction of the step.
        (after * h >= 0.0 && before * h <= 0.0 && h != 0.0).then(|| self.inside(after, t))
    }

    /// The state so long after the start of the last step, which is at the time `t`.
    pub(in crate::running) fn inside(&self, after: f64, t: R) -> StateOf<S, R> {
        let start = self.start();
        let mut x = taylor::increment(&start.jet.as_ref()[..self.order()], after / start.unit);
        x.add_scaled(R::from_f64(1.0), &PerCoordinate::of(&start.x));
        S::State::of(t, x.z, x.s)
    }
}

/// The largest power of two that a length is not below, 1 where there is none: to multiply with it and to divide by it is exact.
#[inline(always)]
fn power_of_two(h: f64) -> f64 {
    let power = f64::from_bits(h.to_bits() & f64::INFINITY.to_bits());
    if power > 0.0 && power < f64::INFINITY { power } else { 1.0 }
}
