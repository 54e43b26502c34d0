//! Chooses the length of the next step, and accepts or refuses it.

mod attempt;
mod expansion;
mod progress;
mod refused;
mod switches;
mod way;

use crate::running::error::{StepError, check_parameters, not_finite};
use crate::running::step_size::Bounds;
use crate::running::tolerance::is_part;
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::{Array, PerCoordinate};
#[cfg(feature = "alloc")]
use crate::space::{Record, Tape};
use crate::system::{Clear, Jets};
use crate::taylor::{self, Estimate, TaylorMethod};
use expansion::Expansion;
use progress::Progress;
use switches::RADIUS_MARGIN;

/// The pace of steps by Taylor series: a system, and all data that determine the next step.
#[derive(Clone)]
pub struct Series<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> {
    pub(in crate::running) system: S,
    pub(in crate::running) method: M,
    pub(in crate::running) bounds: Bounds,
    pub(in crate::running) backwards: bool,
    pub(in crate::running) taken: u64,
    /// Value of `taken` when the user gave a state.
    given: u64,
    estimate: Estimate<S::State>,
    /// Ends of the last step. A new step is written to the older end: nothing is copied, and a refused step does not change the present state.
    ends: [Expansion<S, M, R>; 2],
    /// Whether the second end is the present state.
    second: bool,
    /// Whether the coefficients at the present state are computed.
    known: bool,
    /// Length of the last step.
    pub(in crate::running) step: f64,
    /// Whether the other end is the start of the last step.
    within: bool,
    /// Detects runs that stall at a condition.
    progress: Progress,
    /// Interval of time without poles, found so far.
    clear: Clear<R>,
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Series<S, M, R> {
    pub(in crate::running) fn new((system, method): (S, M), t: R, x: (S::Phase, S::Action)) -> Self {
        let here = Expansion::new(t, x);
        let (mut estimate, backwards) = match method.steps() {
            taylor::Steps::Tolerance(tolerance) => (Estimate::new(tolerance), false),
            taylor::Steps::Length(h) => (Estimate::of_any_accuracy(), h < 0.0),
        };
        estimate.start(&PerCoordinate::of(&here.x));
        Series {
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

    /// Continues from another point.
    pub(in crate::running) fn continue_from(&mut self, t: R, x: (S::Phase, S::Action)) {
        let unit = self.here().unit;
        let here = self.here_mut();
        *here = Expansion { unit, ..Expansion::new(t, x) };
        let x = PerCoordinate::of(&here.x);
        self.estimate.start(&x);
        // There is no last step that could be evaluated.
        (self.known, self.within, self.given) = (false, false, self.taken);
        self.progress = Progress::default();
    }

    /// Continues from the present point with another system.
    pub(in crate::running) fn replace_system(&mut self, system: S) {
        (self.system, self.clear) = (system, Clear::unknown());
        let (clock, x) = (self.here().clock, self.here().x);
        self.continue_from(self.now(), (x.z, x.s));
        self.here_mut().clock = clock;
    }

    /// Returns a copy at the start of the last step, if its coefficients are known.
    pub(super) fn at_start_of_last_step(&self) -> Option<Self> {
        let start = || Series { second: !self.second, taken: self.taken - 1, within: false, ..self.clone() };
        self.within.then(start)
    }

    /// Records everything except the coefficients.
    #[cfg(feature = "alloc")]
    pub(super) fn record_steps(&mut self, tape: &mut impl Tape<R>) {
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

    /// Marks the coefficients as unknown, and the last step as not available.
    #[cfg(feature = "alloc")]
    pub(super) fn forget(&mut self) {
        (self.known, self.within) = (false, false);
    }

    /// Returns the order of the series. It is a constant if the method or the system leaves no choice.
    #[inline(always)]
    pub(in crate::running) fn terms(&self) -> usize {
        self.method.order()
    }

    /// Returns the present end.
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

    /// Returns the start of the last step, or the end of a running attempt.
    #[inline(always)]
    pub(in crate::running) fn start(&self) -> &Expansion<S, M, R> {
        let [first, second] = &self.ends;
        if self.second { first } else { second }
    }

    /// Returns the coefficients at the present state.
    #[inline(always)]
    fn jet(&self) -> &[PerCoordinate<S::Phase, S::Action>] {
        &self.here().jet.as_ref()[..self.terms()]
    }

    pub(in crate::running) fn now(&self) -> R {
        self.here().time()
    }

    /// Returns the length of the next step by the series and the bounds, before any check of its end.
    #[inline(always)]
    fn length(&self, bounds: &Bounds) -> f64 {
        if let taylor::Steps::Length(h) = self.method.steps() {
            return h.abs();
        }
        (self.here().unit * self.estimate.length(self.jet())).min(bounds.longest)
    }

    /// Estimates the time in which the state changes by itself. Returns `None` if it is not known.
    fn pace(&self) -> Option<f64> {
        let time = self.here().unit * self.estimate.time(self.jet());
        (time > 0.0 && time < f64::INFINITY).then_some(time)
    }

    /// Estimates the time of change at the start of the last step, independent of earlier and later states. Infinite if it is not known.
    pub(in crate::running) fn pace_before(&self) -> f64 {
        let start = self.start();
        let jet = &start.jet.as_ref()[..self.terms()];
        let time = start.unit * Estimate::<S::State>::time_of(&PerCoordinate::of(&start.x), jet);
        if time > 0.0 { time } else { f64::INFINITY }
    }

    /// Returns a step length for a polynomial, whose coefficients do not limit the step. This is the time in which the state changes by itself, or
    /// twice the last step if that is more.
    #[cold]
    fn guess(&self) -> f64 {
        self.pace().unwrap_or(1.0).max(2.0 * self.step.abs()).min(f64::MAX)
    }

    /// Returns the longest step if the series does not limit it. With conditions, changes are searched only within the time in which the state
    /// changes.
    #[cold]
    fn endless(&self) -> f64 {
        let guess = self.guess();
        if S::Switches::LEN == 0 { guess } else { self.pace().unwrap_or(guess) }
    }

    /// Takes a step that is not longer than `left`.
    pub(in crate::running) fn take(&mut self, left: f64) -> Result<(), StepError> {
        if !self.known {
            self.begin();
        }
        let t = signed(self.now());
        let bounds = self.bounds.at(t, R::epsilon(), self.here().unit);
        let mut wish = self.length(&bounds);
        // The series ends within the resolution of time: a longer step would be wrong.
        if wish < bounds.shortest && left > wish && !self.is_fixed() {
            return Err(self.refused(t, wish, self.too_short(wish, &bounds)));
        }
        let informed = self.is_informed();
        if !informed {
            wish = wish.min(self.longest_uninformed());
        }
        // Length of a full step, if `left` does not end it.
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
                // The sign at the end decides the side, so the step is extended until the sign has changed. A function that keeps its sign up to the
                // next change only touches zero.
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
                Err(failure) if self.is_fixed() || h.abs() <= bounds.shortest => {
                    return Err(self.refused(t, h.abs(), failure));
                }
                Err(_) => {
                    h = self.towards((0.5 * h.abs()).max(bounds.shortest));
                    switch = None;
                }
            }
        }
        let ended = switch.map(|switch| (switch, (h - ends).abs() + rounding));
        if S::Switches::LEN > 0 && !self.progress.include(h.abs(), ended, S::Switches::LEN) {
            return Err(self.refused(t, h.abs(), Failure::Sliding));
        }
        self.estimate.include(&PerCoordinate::of(&self.start().x));
        (self.second, self.step, self.taken, self.within) = (!self.second, h, self.taken + 1, true);
        Ok(())
    }

    /// Returns the fraction of its radius of convergence within which a function of the state is searched for changes of sign.
    pub(in crate::running) fn part_of_radius(&self) -> f64 {
        let most = if self.is_fixed() { 0.0 } else { RADIUS_MARGIN * self.estimate.part_of_radius(self.terms()) };
        most.max(0.5)
    }

    fn is_fixed(&self) -> bool {
        matches!(self.method.steps(), taylor::Steps::Length(_))
    }

    /// Returns a length with the sign of the direction of the run.
    fn towards(&self, h: f64) -> f64 {
        if self.backwards { -h } else { h }
    }

    pub(in crate::running) fn check(&self) -> Result<(), StepError> {
        // Later states need no check: each comes from a step that succeeded. A resumed run, and its method, must be checked.
        if self.known && self.taken != self.given {
            return Ok(());
        }
        self.usable().map_err(|failure| {
            let h = match self.method.steps() {
                taylor::Steps::Tolerance(_) => self.step,
                taylor::Steps::Length(h) => h,
            };
            StepError::new(failure, signed(self.now()), h)
        })
    }

    /// Checks the settings and the state before a step.
    fn usable(&self) -> Result<(), Failure> {
        if self.terms() < 2 {
            return Err(Failure::InvalidOrder { order: self.terms() });
        }
        match self.method.steps() {
            taylor::Steps::Tolerance(tolerance) if !is_part(tolerance) => {
                return Err(Failure::InvalidTolerance { tolerance });
            }
            taylor::Steps::Length(h) if !(h != 0.0 && h.is_finite()) => return Err(Failure::InvalidStepSize { h }),
            _ => {}
        }
        self.bounds.check()?;
        check_parameters(&self.system)?;
        let x = &self.here().x;
        if !(signed(self.now()).is_finite() && x.is_finite()) {
            return Err(not_finite::<S, R>(self.now(), &x.z));
        }
        Failure::outside(self.system.outside_domain(self.now(), &x.z, &x.s))
    }
}
