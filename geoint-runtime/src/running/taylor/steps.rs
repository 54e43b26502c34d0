//! How long the next step is, where it leads, and whether it is taken.

use crate::method::Clock;
use crate::running::error::{Reason, StepError};
use crate::running::step_size::Bounds;
use crate::scalar::{Real, signed, zero};
use crate::space::{Array, Compensated, DoubleWord, PerCoordinate, Point, Snapshot};
#[cfg(feature = "alloc")]
use crate::space::{Record, Tape};
use crate::system::{Jets, StateOf};
use crate::taylor::{self, Estimate, TaylorMethod};

/// A point whose sums compensate.
type Carried<S, R> = Point<
    <S as crate::system::PhaseSpace<R>>::Phase,
    Compensated<<S as crate::system::PhaseSpace<R>>::Phase>,
    <S as crate::system::PhaseSpace<R>>::Action,
>;

/// The coefficients at a point.
#[derive(Clone, Copy, Debug)]
pub(in crate::running) struct Expansion<S: Jets<R>, M: TaylorMethod, R: Real> {
    pub(in crate::running) x: PerCoordinate<S::Phase, S::Action>,
    /// The unit of time in the coefficients, a power of two.
    pub(in crate::running) unit: f64,
    /// From order 1 on.
    pub(in crate::running) jet: M::Orders<PerCoordinate<S::Phase, S::Action>>,
    /// From order 0 on.
    pub(in crate::running) switches: M::Orders<S::Switches>,
}

/// A system, and all that decides on the next step.
#[derive(Clone, Copy)]
pub(in crate::running) struct Steps<S: Jets<R>, M: TaylorMethod, R: Real> {
    pub(in crate::running) system: S,
    pub(in crate::running) method: M,
    pub(in crate::running) order: usize,
    pub(in crate::running) bounds: Bounds,
    pub(in crate::running) backwards: bool,
    pub(in crate::running) clock: Clock<R>,
    pub(in crate::running) x: Carried<S, R>,
    pub(in crate::running) taken: u64,
    estimate: Estimate<S::Phase, S::Action>,
    /// At the start of the last step, and at the present: which of them that is changes with every step.
    expansions: [Expansion<S, M, R>; 2],
    present: usize,
    /// Whether the coefficients at the present are known.
    known: bool,
    /// When the last step started, and its length.
    last: (Clock<R>, f64),
    /// Whether the present is the end of the last step.
    within: bool,
    /// Steps in a row that a switch has ended where they began.
    stuck: u32,
}

/// A condition that changes sides.
#[derive(Clone, Copy)]
struct Switch {
    /// Which one.
    place: usize,
    /// When, as a part of the step; at 0 it is on the wrong side of where it goes.
    at: f64,
    /// What decides it has this sign afterwards.
    sign: f64,
}

/// So many steps in a row that a switch has ended where they began are no accident.
const STUCK: u32 = 16;

impl<S: Jets<R>, M: TaylorMethod, R: Real> Steps<S, M, R> {
    pub(in crate::running) fn new((system, method): (S, M), t: R, x: Carried<S, R>) -> Self {
        let here = PerCoordinate::of(&x);
        let expansion = Expansion {
            x: here,
            unit: 1.0,
            jet: M::fill(PerCoordinate::zero()),
            switches: M::fill(S::Switches::zero()),
        };
        let (tolerance, backwards) = match method.steps() {
            taylor::Steps::Tolerance(tolerance) => (tolerance, false),
            taylor::Steps::Length(h) => (0.0, h < 0.0),
        };
        let mut estimate = Estimate::new(tolerance, S::State::ALIKE);
        estimate.include(&here);
        let clock = Clock::new(t, zero());
        Steps {
            order: method.order::<S, R>(),
            system,
            method,
            bounds: Bounds::default(),
            backwards,
            clock,
            x,
            taken: 0,
            estimate,
            expansions: [expansion; 2],
            present: 0,
            known: false,
            last: (clock, 0.0),
            within: false,
            stuck: 0,
        }
    }

    /// Goes on from another point.
    pub(in crate::running) fn restart(&mut self, t: R, x: Carried<S, R>) {
        let clock = Clock::new(t, zero());
        (self.clock, self.x, self.known, self.last) = (clock, x, false, (clock, self.last.1));
        self.estimate.include(&PerCoordinate::of(&x));
        // There is no last step to look into.
        self.within = false;
    }

    /// Everything but the coefficients.
    #[cfg(feature = "alloc")]
    pub(super) fn record(&mut self, tape: &mut impl Tape<R>) {
        self.clock.record(tape);
        self.x.record(tape);
        tape.steps(&mut self.taken);
        tape.flag(&mut self.backwards);
        self.estimate.record(tape);
        tape.number(&mut self.last.1);
        tape.number(&mut self.expansions[self.present].unit);
        let mut stuck = u64::from(self.stuck);
        tape.count(&mut stuck);
        self.stuck = stuck.min(u64::from(STUCK)) as u32;
    }

    /// The coefficients are to be computed anew, and there is no last step to look into.
    #[cfg(feature = "alloc")]
    pub(super) fn forget(&mut self) {
        (self.known, self.within) = (false, false);
    }

    pub(in crate::running) fn time(&self) -> R {
        self.clock.now(zero())
    }

    pub(in crate::running) fn last_step(&self) -> f64 {
        self.last.1
    }

    /// The coefficients at a point into a place, for steps of about this length.
    #[inline(always)]
    fn expand(&mut self, place: usize, h: f64, t: R, x: PerCoordinate<S::Phase, S::Action>) {
        let expansion = &mut self.expansions[place];
        let unit = power_of_two(h);
        (expansion.x, expansion.unit) = (x, unit);
        let start = [R::from_f64(unit), t];
        M::jet(self.order, &self.system, start, (&x.z, &x.s), &mut expansion.jet, &mut expansion.switches);
    }

    /// The coefficients where a run starts, in a unit of time in which none of them overflows, or goes on, in the unit before.
    #[cold]
    fn begin(&mut self) {
        let (t, x) = (self.time(), PerCoordinate::of(&self.x));
        self.expand(self.present, self.expansions[self.present].unit, t, x);
        if self.taken == 0 {
            self.expand(self.present, self.guess(), t, x);
        }
        self.known = true;
    }

    /// The coefficients at the present.
    fn jet(&self) -> &[PerCoordinate<S::Phase, S::Action>] {
        &self.expansions[self.present].jet.as_ref()[..self.order]
    }

    /// A length in the unit of the coefficients at the present.
    #[inline(always)]
    fn in_units(&self, h: f64) -> f64 {
        h / self.expansions[self.present].unit
    }

    /// The length of the next step, without regard to where it leads.
    #[inline(always)]
    fn length(&self, bounds: &Bounds) -> f64 {
        if let taylor::Steps::Length(h) = self.method.steps() {
            return h.abs();
        }
        (self.expansions[self.present].unit * self.estimate.length(self.jet())).min(bounds.longest)
    }

    /// In how long, roughly, the state changes by itself; twice the step before, if that is more. For a polynomial, whose coefficients set
    /// no end to a step.
    #[cold]
    fn guess(&self) -> f64 {
        let time = self.expansions[self.present].unit * self.estimate.time(&self.jet()[0]);
        let time = if time > 0.0 && time < f64::INFINITY { time } else { 1.0 };
        time.max(2.0 * self.last.1.abs())
    }

    /// A step that is not longer than `left`.
    pub(in crate::running) fn take(&mut self, left: f64) -> Result<(), StepError> {
        if !self.known {
            self.begin();
        }
        let t = signed(self.time());
        let bounds = self.bounds.at(t, R::epsilon());
        let wish = self.length(&bounds);
        // Where the series ends within what changes time, a longer step would be wrong.
        if wish < bounds.shortest && left > wish && !self.is_fixed() {
            return Err(self.refused(t, wish, Reason::Diverges));
        }
        // Where nothing else ends it.
        let whole = if wish < f64::INFINITY { wish } else { self.guess() };
        let mut h = self.towards(if left < f64::INFINITY { wish.min(left) } else { whole });
        let mut switch = self.switch(h);
        let mut beyond = 0.25 * R::epsilon() * h.abs();
        if let Some(switch) = switch {
            h = if switch.at == 0.0 { self.towards(beyond) } else { switch.at * h };
        }
        let arrival = loop {
            match self.attempt(h, whole, switch.is_none()) {
                // Which side it is on will be decided by the value.
                Ok(_) if switch.is_some_and(|switch| !self.is_behind(switch)) && beyond < wish => {
                    h += self.towards(beyond);
                    beyond *= 2.0;
                }
                Ok(arrival) => break arrival,
                Err(reason) if self.is_fixed() || h.abs() <= bounds.shortest => {
                    return Err(self.refused(t, h.abs(), reason));
                }
                Err(_) => {
                    h *= 0.5;
                    switch = None;
                }
            }
        };
        self.stuck = if switch.is_some_and(|switch| switch.at == 0.0) { self.stuck + 1 } else { 0 };
        if self.stuck > STUCK {
            return Err(self.refused(t, h.abs(), Reason::Sliding));
        }
        self.last = (self.clock, h);
        (self.x, self.clock) = arrival;
        self.present = 1 - self.present;
        self.estimate.include(&PerCoordinate::of(&self.x));
        (self.taken, self.within) = (self.taken + 1, true);
        Ok(())
    }

    fn is_fixed(&self) -> bool {
        matches!(self.method.steps(), taylor::Steps::Length(_))
    }

    /// A length in the direction of the run.
    fn towards(&self, h: f64) -> f64 {
        if self.backwards { -h } else { h }
    }

    /// Where a step of length h, in place of a whole one, leads, and when that is. The coefficients there are computed, and, if `compared`,
    /// their first order with that of the polynomial.
    #[inline(always)]
    fn attempt(&mut self, h: f64, whole: f64, compared: bool) -> Result<(Carried<S, R>, Clock<R>), Reason> {
        let (mut x, mut clock) = (self.x, self.clock);
        let part = self.in_units(h);
        let (increment, rate) = taylor::increment_and_rate(self.jet(), part);
        x.add_everywhere(&increment);
        if !x.is_finite() {
            return Err(Reason::Diverges);
        }
        clock.pass_step(R::from_f64(h), DoubleWord::new(zero()));
        let t = clock.now(zero());
        self.expand(1 - self.present, whole, t, PerCoordinate::of(&x));
        if S::EXAMINED
            && let Some(what) = self.system.outside_domain(t, &x.z, &x.s)
        {
            return Err(Reason::OutsideDomain { what });
        }
        let [from, to] = [self.present, 1 - self.present].map(|place| self.expansions[place].unit);
        let mut here = self.expansions[1 - self.present].jet.as_ref()[0];
        here.times(R::from_f64(from / to));
        if !here.is_finite() {
            let what = self.system.outside_domain(t, &x.z, &x.s);
            return Err(what.map_or(Reason::Diverges, |what| Reason::OutsideDomain { what }));
        }
        if compared && !self.is_fixed() && !self.estimate.agree(part, [&rate, &here], &self.jet()[0]) {
            return Err(Reason::Diverges);
        }
        Ok((x, clock))
    }

    /// The first condition of the energy that changes sides within a step.
    #[inline(always)]
    fn switch(&self, h: f64) -> Option<Switch> {
        if S::Switches::LEN == 0 { None } else { self.first_switch(h) }
    }

    #[inline(never)]
    fn first_switch(&self, h: f64) -> Option<Switch> {
        let switches = &self.expansions[self.present].switches.as_ref()[..self.order];
        let h = self.in_units(h);
        let mut first: Option<Switch> = None;
        for place in 0..S::Switches::LEN {
            let g = taylor::in_parts(switches.iter().map(|switch| signed(switch.as_slice()[place])), h);
            let roots = taylor::roots(&g[..self.order.min(taylor::MOST)]);
            let here = if g[0] == 0.0 { 0.0 } else { g[0].signum() };
            let at = match roots.as_slice() {
                // It is zero all along.
                _ if roots.sign == 0.0 => continue,
                // It leaves zero, or the side that it is on by rounding.
                _ if here != roots.sign => Switch { place, at: 0.0, sign: roots.sign },
                [] => continue,
                [at, ..] => Switch { place, at: *at, sign: -roots.sign },
            };
            if first.is_none_or(|first| at.at < first.at) {
                first = Some(at);
            }
        }
        first
    }

    /// Whether the point that was reached is behind a switch.
    fn is_behind(&self, switch: Switch) -> bool {
        let value = signed(self.expansions[1 - self.present].switches.as_ref()[0].as_slice()[switch.place]);
        value * switch.sign > 0.0
    }

    /// Why there is no step.
    #[cold]
    fn refused(&self, t: f64, h: f64, reason: Reason) -> StepError {
        let h = self.towards(h);
        match reason {
            _ if !self.is_fixed() => StepError::StepTooSmall { t, h, reason },
            Reason::OutsideDomain { what } => StepError::OutsideDomain { t, what },
            // Nothing else is wrong with a step that is not compared.
            _ => StepError::NonFinite { t },
        }
    }

    pub(in crate::running) fn check_start(&self) -> Result<(), StepError> {
        if self.taken > 0 {
            return Ok(());
        }
        if self.order < 2 {
            return Err(StepError::InvalidOrder { order: self.order });
        }
        match self.method.steps() {
            taylor::Steps::Tolerance(tolerance) if !(tolerance > 0.0 && tolerance < f64::INFINITY) => {
                return Err(StepError::InvalidTolerance { tolerance });
            }
            taylor::Steps::Length(h) if !(h != 0.0 && h.is_finite()) => return Err(StepError::InvalidStepSize { h }),
            _ => {}
        }
        if let Some(h) = self.bounds.unusable() {
            return Err(StepError::InvalidStepSize { h });
        }
        let t = signed(self.time());
        if !(t.is_finite() && self.x.is_finite()) {
            return Err(StepError::NonFiniteState { t });
        }
        match self.system.outside_domain(self.time(), &self.x.z, &self.x.s) {
            Some(what) => Err(StepError::OutsideDomain { t, what }),
            None => Ok(()),
        }
    }

    /// The state at a time within the last step.
    pub(in crate::running) fn at(&self, t: R) -> Option<StateOf<S, R>> {
        let (start, h) = &self.last;
        let (after, before) = (start.left(t), self.clock.left(t));
        if !self.within {
            return None;
        }
        if t == self.time() {
            return Some(S::State::of(t, self.x.z, self.x.s));
        }
        // Between the ends, in the direction of the step.
        (after * h >= 0.0 && before * h <= 0.0 && *h != 0.0).then(|| self.inside(after, t))
    }

    /// The expansion of the last step, its start and its length.
    pub(in crate::running) fn last_expansion(&self) -> (&Expansion<S, M, R>, R, f64) {
        (&self.expansions[1 - self.present], self.last.0.now(zero()), self.last.1)
    }

    /// The state so long after the start of the last step, which is at the time `t`.
    pub(in crate::running) fn inside(&self, after: f64, t: R) -> StateOf<S, R> {
        let expansion = &self.expansions[1 - self.present];
        let mut x = taylor::increment(&expansion.jet.as_ref()[..self.order], after / expansion.unit);
        x.add_scaled(R::from_f64(1.0), &expansion.x);
        S::State::of(t, x.z, x.s)
    }
}

/// The largest power of two that a length is not below, 1 where there is none: to multiply with it and to divide by it is exact.
#[inline(always)]
fn power_of_two(h: f64) -> f64 {
    let power = f64::from_bits(h.to_bits() & f64::INFINITY.to_bits());
    if power > 0.0 && power < f64::INFINITY { power } else { 1.0 }
}
