//! How long the next step is, and whether it is taken.

mod attempt;
mod expansion;
mod progress;
mod refused;
mod switches;
mod way;

use crate::running::error::{Reason, StepError};
use crate::running::step_size::Bounds;
use crate::running::tolerance::is_part;
use crate::scalar::{Real, signed};
use crate::space::{Array, PerCoordinate};
#[cfg(feature = "alloc")]
use crate::space::{Record, Tape};
use crate::system::{Clear, Jets};
use crate::taylor::{self, Estimate, TaylorMethod};
use expansion::Expansion;
use progress::Progress;
use switches::NEARLY;

/// A system, and all that decides on the next step.
#[derive(Clone)]
pub(in crate::running) struct Steps<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> {
    pub(in crate::running) system: S,
    pub(in crate::running) method: M,
    pub(in crate::running) bounds: Bounds,
    pub(in crate::running) backwards: bool,
    pub(in crate::running) taken: u64,
    /// How many there were when the user gave a state.
    given: u64,
    estimate: Estimate<S::State>,
    /// The ends of the last step. The next one ends where this one began: nothing is copied, and a step that is refused changes nothing here.
    ends: [Expansion<S, M, R>; 2],
    /// Which of them is the present.
    second: bool,
    /// Whether the coefficients at the present are known.
    known: bool,
    /// The length of the last step.
    pub(in crate::running) step: f64,
    /// Whether the other end is where the last step began.
    within: bool,
    /// The steps in a row that switches have ended.
    progress: Progress,
    /// What is known of poles in time.
    clear: Clear<R>,
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Steps<S, M, R> {
    pub(in crate::running) fn new((system, method): (S, M), t: R, x: (S::Phase, S::Action)) -> Self {
        let here = Expansion::new(t, x);
        let (mut estimate, backwards) = match method.steps() {
            taylor::Steps::Tolerance(tolerance) => (Estimate::new(tolerance), false),
            taylor::Steps::Length(h) => (Estimate::of_any_accuracy(), h < 0.0),
        };
        estimate.start(&PerCoordinate::of(&here.x));
        Steps {
            system,
            method,
            bounds: Bounds::default(),
            backwards,
            taken: 0,
            given: 0,
            estimate,
            ends: [here.clone(), here],
            second: false,
            known: false,
            step: 0.0,
            within: false,
            progress: Progress::default(),
            clear: Clear::unknown(),
        }
    }

    /// Goes on from another point.
    pub(in crate::running) fn restart(&mut self, t: R, x: (S::Phase, S::Action)) {
        let unit = self.here().unit;
        let here = self.here_mut();
        *here = Expansion { unit, ..Expansion::new(t, x) };
        let x = PerCoordinate::of(&here.x);
        self.estimate.start(&x);
        // There is no last step to look into.
        (self.known, self.within, self.given) = (false, false, self.taken);
        self.progress = Progress::default();
    }

    /// Goes on from here with another system.
    pub(in crate::running) fn set_system(&mut self, system: S) {
        (self.system, self.clear) = (system, Clear::unknown());
        let (clock, x) = (self.here().clock, self.here().x);
        self.restart(self.time(), (x.z, x.s));
        self.here_mut().clock = clock;
    }

    /// Everything but the coefficients.
    #[cfg(feature = "alloc")]
    pub(super) fn record(&mut self, tape: &mut impl Tape<R>) {
        let here = self.here_mut();
        here.clock.record(tape);
        here.x.record(tape);
        here.memory.record(tape);
        tape.number(&mut here.unit);
        tape.steps(&mut self.taken);
        tape.steps(&mut self.given);
        tape.flag(&mut self.backwards);
        self.estimate.record(tape);
        tape.number(&mut self.step);
        self.progress.record(tape);
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

    /// The present.
    #[inline(always)]
    pub(in crate::running) fn here(&self) -> &Expansion<S, M, R> {
        let [first, second] = &self.ends;
        if self.second { second } else { first }
    }

    #[inline(always)]
    pub(in crate::running) fn here_mut(&mut self) -> &mut Expansion<S, M, R> {
        let [first, second] = &mut self.ends;
        if self.second { second } else { first }
    }

    /// Where the last step began, or where an attempt of the next one led.
    #[inline(always)]
    pub(in crate::running) fn start(&self) -> &Expansion<S, M, R> {
        let [first, second] = &self.ends;
        if self.second { first } else { second }
    }

    /// The coefficients at the present.
    #[inline(always)]
    fn jet(&self) -> &[PerCoordinate<S::Phase, S::Action>] {
        &self.here().jet.as_ref()[..self.order()]
    }

    pub(in crate::running) fn time(&self) -> R {
        self.here().time()
    }

    /// The length of the next step, without regard to where it leads.
    #[inline(always)]
    fn length(&self, bounds: &Bounds) -> f64 {
        if let taylor::Steps::Length(h) = self.method.steps() {
            return h.abs();
        }
        (self.here().unit * self.estimate.length(self.jet())).min(bounds.longest)
    }

    /// In how long, roughly, the state changes by itself; `None` if that is not known.
    fn pace(&self) -> Option<f64> {
        let time = self.here().unit * self.estimate.time(self.jet());
        (time > 0.0 && time < f64::INFINITY).then_some(time)
    }

    /// The same at the start of the last step, whatever has been before and after it; infinite if that is not known.
    pub(in crate::running) fn pace_before(&self) -> f64 {
        let start = self.start();
        let jet = &start.jet.as_ref()[..self.order()];
        let time = start.unit * Estimate::<S::State>::time_of(&PerCoordinate::of(&start.x), jet);
        if time > 0.0 { time } else { f64::INFINITY }
    }

    /// In how long, roughly, the state changes by itself; twice the step before, if that is more. For a polynomial, whose coefficients set
    /// no end to a step.
    #[cold]
    fn guess(&self) -> f64 {
        self.pace().unwrap_or(1.0).max(2.0 * self.step.abs()).min(f64::MAX)
    }

    /// The longest step for a wish without an end: conditions are looked for in what is not much longer than the state takes to change.
    #[cold]
    fn endless(&self) -> f64 {
        let guess = self.guess();
        if S::Switches::LEN == 0 { guess } else { self.pace().unwrap_or(guess) }
    }

    /// A step that is not longer than `left`.
    pub(in crate::running) fn take(&mut self, left: f64) -> Result<(), StepError> {
        if !self.known {
            self.begin();
        }
        let t = signed(self.time());
        let bounds = self.bounds.at(t, R::epsilon(), self.here().unit);
        let mut wish = self.length(&bounds);
        // Where the series ends within what changes time, a longer step would be wrong.
        if wish < bounds.shortest && left > wish && !self.is_fixed() {
            return Err(self.refused(t, wish, self.too_short(wish, &bounds)));
        }
        let informed = self.is_informed();
        if !informed {
            wish = wish.min(self.longest_uninformed());
        }
        // Where nothing else ends it.
        let whole = if wish < f64::INFINITY { wish } else { self.endless() };
        let most = if S::Switches::LEN > 0 || left == f64::INFINITY { whole } else { wish };
        let (searched, mut switch) = self.switch(self.towards(most.min(left)), bounds.shortest);
        let mut h = searched;
        let rounding = 0.25 * R::epsilon() * h.abs();
        let (mut ends, mut beyond) = (h, rounding);
        if let Some(switch) = switch {
            ends = switch.at * h;
            h = if switch.at == 0.0 { self.towards(beyond) } else { ends };
        }
        self.within = false;
        let mut held = None;
        loop {
            match self.attempt(h, whole, switch.is_none(), held.take()) {
                Ok(_) if h.abs() > bounds.shortest && self.has_unseen_switch() => {
                    h = self.towards((0.5 * h.abs()).max(bounds.shortest));
                    switch = None;
                }
                Ok(_) if (!informed || self.moves_far(h)) && h.abs() > bounds.shortest && !self.agrees_on_way(h) => {
                    h = self.towards((0.5 * h.abs()).max(bounds.shortest));
                    switch = None;
                }
                // Which side it is on will be decided by the value; what does not leave a zero before the next change only touches it.
                Ok(correction) => {
                    let missed = switch.filter(|switch| !self.is_behind(*switch));
                    let farthest = missed.map_or(0.0, |switch| self.next_change(searched, switch) * searched.abs());
                    if h.abs() >= farthest {
                        break;
                    }
                    h = self.towards((h.abs() + beyond).min(farthest));
                    beyond *= 2.0;
                    held = correction;
                }
                Err(reason) if self.is_fixed() || h.abs() <= bounds.shortest => {
                    return Err(self.refused(t, h.abs(), reason));
                }
                Err(_) => {
                    h = self.towards((0.5 * h.abs()).max(bounds.shortest));
                    switch = None;
                }
            }
        }
        let ended = switch.map(|switch| (switch, (h - ends).abs() + rounding));
        if S::Switches::LEN > 0 && !self.progress.include(h.abs(), ended, S::Switches::LEN) {
            return Err(self.refused(t, h.abs(), Reason::Sliding));
        }
        self.estimate.include(&PerCoordinate::of(&self.start().x));
        (self.second, self.step, self.taken, self.within) = (!self.second, h, self.taken + 1, true);
        Ok(())
    }

    /// What part of its radius of convergence a function of the state is followed for, to see where it changes sign.
    pub(in crate::running) fn part_of_radius(&self) -> f64 {
        let most = if self.is_fixed() { 0.0 } else { NEARLY * self.estimate.part_of_radius(self.order()) };
        most.max(0.5)
    }

    fn is_fixed(&self) -> bool {
        matches!(self.method.steps(), taylor::Steps::Length(_))
    }

    /// A length in the direction of the run.
    fn towards(&self, h: f64) -> f64 {
        if self.backwards { -h } else { h }
    }

    pub(in crate::running) fn check_start(&self) -> Result<(), StepError> {
        // Later states are good because the steps that led to them were. Of a saved run that is not known, nor was this method asked.
        if self.known && self.taken != self.given {
            return Ok(());
        }
        if self.order() < 2 {
            return Err(StepError::InvalidOrder { order: self.order() });
        }
        match self.method.steps() {
            taylor::Steps::Tolerance(tolerance) if !is_part(tolerance) => {
                return Err(StepError::InvalidTolerance { tolerance });
            }
            taylor::Steps::Length(h) if !(h != 0.0 && h.is_finite()) => return Err(StepError::InvalidStepSize { h }),
            _ => {}
        }
        self.bounds.check()?;
        StepError::of_parameters(&self.system)?;
        let t = signed(self.time());
        let x = &self.here().x;
        if !(t.is_finite() && x.is_finite()) {
            return Err(StepError::not_finite::<S, R>(self.time(), &x.z));
        }
        match self.system.outside_domain(self.time(), &x.z, &x.s) {
            Some(what) => Err(StepError::OutsideDomain { t, what }),
            None => Ok(()),
        }
    }
}
