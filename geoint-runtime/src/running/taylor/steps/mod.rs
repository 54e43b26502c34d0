//! How long the next step is, where it leads, and whether it is taken.

mod expansion;
mod switches;

use crate::method::Clock;
use crate::running::error::{Reason, StepError};
use crate::running::step_size::Bounds;
use crate::scalar::{Real, signed, zero};
use crate::space::{Array, Compensated, DoubleWord, PerCoordinate, Point};
#[cfg(feature = "alloc")]
use crate::space::{Record, Tape};
use crate::system::Jets;
use crate::taylor::{self, Estimate, TaylorMethod};
pub(in crate::running) use expansion::Expansion;
use switches::STUCK;

/// A point whose sums compensate.
type Carried<S, R> = Point<
    <S as crate::system::PhaseSpace<R>>::Phase,
    Compensated<<S as crate::system::PhaseSpace<R>>::Phase>,
    <S as crate::system::PhaseSpace<R>>::Action,
>;

/// Where a step leads, when that is, and what it hands on.
type Arrival<S, M, R> = (Carried<S, R>, Clock<R>, <M as TaylorMethod<S, R>>::Memory);

/// A system, and all that decides on the next step.
#[derive(Clone)]
pub(in crate::running) struct Steps<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> {
    pub(in crate::running) system: S,
    pub(in crate::running) method: M,
    pub(in crate::running) bounds: Bounds,
    pub(in crate::running) backwards: bool,
    pub(in crate::running) clock: Clock<R>,
    pub(in crate::running) x: Carried<S, R>,
    pub(in crate::running) taken: u64,
    /// How many there were when the user gave a state.
    given: u64,
    estimate: Estimate<S::State>,
    /// Of the method, where it puts ends of steps right.
    memory: M::Memory,
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

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Steps<S, M, R> {
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
        let mut estimate = Estimate::new(tolerance);
        estimate.include(&here);
        let clock = Clock::new(t, zero());
        Steps {
            memory: M::memory(),
            system,
            method,
            bounds: Bounds::default(),
            backwards,
            clock,
            x,
            taken: 0,
            given: 0,
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
        (self.within, self.given) = (false, self.taken);
    }

    /// Everything but the coefficients.
    #[cfg(feature = "alloc")]
    pub(super) fn record(&mut self, tape: &mut impl Tape<R>) {
        self.clock.record(tape);
        self.x.record(tape);
        tape.steps(&mut self.taken);
        tape.steps(&mut self.given);
        tape.flag(&mut self.backwards);
        self.estimate.record(tape);
        self.memory.record(tape);
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

    /// The order of the series: a constant wherever the method or the system leave no choice.
    #[inline(always)]
    pub(in crate::running) fn order(&self) -> usize {
        self.method.order()
    }

    pub(in crate::running) fn time(&self) -> R {
        self.clock.now(zero())
    }

    pub(in crate::running) fn last_step(&self) -> f64 {
        self.last.1
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
        (self.x, self.clock, self.memory) = arrival;
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
    fn attempt(&mut self, h: f64, whole: f64, compared: bool) -> Result<Arrival<S, M, R>, Reason> {
        let (mut x, mut clock, mut memory) = (self.x, self.clock, self.memory);
        let part = self.in_units(h);
        let (increment, rate) = taylor::increment_and_rate(self.jet(), part);
        x.add_everywhere(&increment);
        if !x.is_finite() {
            return Err(Reason::Diverges);
        }
        if let Some(correction) = self.method.correction(&mut memory, &self.system, &self.x.z, &x.z)? {
            x.add(&correction);
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
        if compared && !self.is_fixed() {
            let (rates, before) = ([&rate, &here], &self.jet()[0]);
            let agree = |late: PerCoordinate<_, _>| self.estimate.agree(part, rates, before, &late);
            if !agree(PerCoordinate::zero()) && !agree(self.late(t)) {
                return Err(Reason::Diverges);
            }
        }
        Ok((x, clock, memory))
    }

    /// How much rates at the end of the step may be off because the time there is rounded, in the unit of the coefficients at the present:
    /// near a pole in time.
    #[cold]
    fn late(&self, t: R) -> PerCoordinate<S::Phase, S::Action> {
        let [from, to] = [self.present, 1 - self.present].map(|place| self.expansions[place].unit);
        let mut late = self.expansions[1 - self.present].jet.as_ref()[1];
        late.times(R::from_f64(2.0 * from / to * (2.0 * R::epsilon() * t.magnitude() / to)));
        late
    }

    /// Why there is no step.
    #[cold]
    fn refused(&self, t: f64, h: f64, reason: Reason) -> StepError {
        let h = self.towards(h);
        match reason {
            _ if !self.is_fixed() => StepError::StepTooSmall { t, h, reason },
            Reason::OutsideDomain { what } => StepError::OutsideDomain { t, what },
            Reason::NotConverged | Reason::Singular => StepError::Singular { t },
            _ => StepError::NonFinite { t },
        }
    }

    pub(in crate::running) fn check_start(&self) -> Result<(), StepError> {
        // Later states are good because the steps that led to them were.
        if self.taken != self.given {
            return Ok(());
        }
        if self.order() < 2 {
            return Err(StepError::InvalidOrder { order: self.order() });
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
}
