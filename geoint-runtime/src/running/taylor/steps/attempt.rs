//! Takes one trial step, and checks that the series is valid up to its end.

use super::Series;
use super::expansion::Carried;
use crate::scalar::{Real, zero};
use crate::solving::Failure;
use crate::space::{Array, PerCoordinate};
use crate::system::{Evaluations, Jets, Poles, jump_on_way};
use crate::taylor::{self, TaylorMethod};

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Series<S, M, R> {
    /// Whether the energy has singular points at real times: poles, powers with a vanishing base, conditions. A step of fixed length beyond such a
    /// point would end at finite but wrong numbers, so its rates are compared, too.
    const SERIES_END: bool = S::Switches::LEN > 0 || S::POWERS || !S::POLES.is_empty();

    /// Tries a step of length `h`; `start()` is then its end. Evaluates the polynomial and computes the coefficients at the end, in a unit for full
    /// steps of length `whole`. If `compared`, the rates there must agree with those of the polynomial.
    ///
    /// Returns the correction of the method. `held` is the correction of an attempt of nearly the same length, and is used again. A new one might
    /// lead back over the condition at which the step ends.
    #[inline(always)]
    pub(super) fn attempt(
        &mut self,
        h: f64,
        whole: f64,
        compared: bool,
        held: Option<S::Phase>,
    ) -> Result<Option<S::Phase>, Failure> {
        let (order, [first, second]) = (self.method.order(), &mut self.ends);
        let (from, to) = if self.second { (second, first) } else { (first, second) };
        let (mut x, mut clock) = (from.x, from.clock);
        let part = from.in_units(h);
        for increment in taylor::increments(&from.jet.as_ref()[..order], part) {
            x.add_everywhere(&increment);
        }
        if !x.is_finite() {
            return Err(Failure::Diverges);
        }
        let end = x;
        let correction = if held.is_some() {
            held
        } else {
            to.memory = from.memory;
            let time = [from.time(), R::from_f64(h)];
            self.method.correction(&mut to.memory, &self.system, time, [&from.x.z, &x.z])?
        };
        if let Some(correction) = &correction {
            x.add(correction);
        }
        clock.pass_length(R::from_f64(h));
        if clock.now(zero()).magnitude().is_nan() || clock.now(zero()).magnitude() == f64::INFINITY {
            return Err(Failure::NonFinite);
        }
        (to.x, to.clock) = (x, clock);
        to.expand(order, &self.system, whole);
        let here = to.rates(from.unit);
        if S::EXAMINED
            && let Some(what) = self.outside_domain()
        {
            return Err(Failure::OutsideDomain { what });
        }
        // The series end before the poles of the field. An invariant may have further poles, and a correction must not lead across one.
        let uncorrected = correction.map(|_| end);
        let times = [self.here().time(), self.start().time()];
        let pole = self.clear.pole(&self.system, times).or_else(|| uncorrected.and_then(|_| self.pole()));
        if let Some(what) = pole.or_else(|| self.jump()) {
            return Err(Failure::OutsideDomain { what });
        }
        if !here.is_finite() {
            return Err(self.outside_domain().map_or(Failure::Diverges, |what| Failure::OutsideDomain { what }));
        }
        let compared = compared && (!self.is_fixed() || (Self::SERIES_END && !self.has_unseen_switch()));
        let agrees = !compared || self.agrees(part, &here) || self.agrees_late(part, &here);
        if agrees || uncorrected.is_some_and(|end| self.agrees_before(end, part, whole)) {
            Ok(correction)
        } else {
            Err(Failure::Diverges)
        }
    }

    /// Returns a message if the energy is not defined at the end of the attempt.
    fn outside_domain(&self) -> Option<&'static str> {
        let end = self.start();
        self.system.outside_domain(end.time(), &end.x.z, &end.x.s)
    }

    /// Returns a message if a pole may lie between the ends of the attempt.
    #[inline(always)]
    fn pole(&self) -> Option<&'static str> {
        let [from, to] = [self.here(), self.start()];
        let way = ([from.time(), to.time()], [&from.x.z, &to.x.z], [&from.x.s, &to.x.s]);
        Poles::of(&self.system).between(&self.system, Evaluations::AtPoints, way)
    }

    /// Returns a message if the energy jumps between the ends of the attempt. Series do not show jumps.
    #[inline(always)]
    fn jump(&self) -> Option<&'static str> {
        let ends = [self.here(), self.start()].map(|end| (end.time(), PerCoordinate::of(&end.x)));
        let part = match self.method.steps() {
            taylor::Steps::Tolerance(tolerance) => tolerance,
            taylor::Steps::Length(_) => 0.0,
        };
        jump_on_way(&self.system, &ends, part)
    }

    /// Returns whether the rates at the end of the attempt agree with those of the polynomial, in the unit of the present coefficients.
    ///
    /// Not inlined: together with other sums of the same coefficients, this sum is not vectorised well.
    #[inline(never)]
    fn agrees(&self, part: f64, rates: &PerCoordinate<S::Phase, S::Action>) -> bool {
        let polynomial = taylor::rate(self.jet(), part);
        self.estimate.agree(part, [&polynomial, rates], &self.jet()[0], &PerCoordinate::zero())
    }

    /// Compares the rates at the uncorrected end of the series. The correction shifts a small coordinate by the rounding of the invariants, which may
    /// exceed the error of the series.
    #[cold]
    #[inline(never)]
    fn agrees_before(&mut self, end: Carried<S, R>, part: f64, whole: f64) -> bool {
        let order = self.method.order();
        let [first, second] = &mut self.ends;
        let (from, to) = if self.second { (second, first) } else { (first, second) };
        let corrected = core::mem::replace(&mut to.x, end);
        to.expand(order, &self.system, whole);
        let rates = to.rates(from.unit);
        to.x = corrected;
        to.expand(order, &self.system, whole);
        self.agrees(part, &rates)
    }

    /// Compares the rates near a pole in time. The time of the end is rounded, and the rates may differ by the effect of this rounding.
    #[cold]
    fn agrees_late(&self, part: f64, rates: &PerCoordinate<S::Phase, S::Action>) -> bool {
        let (polynomial, [from, end]) = (taylor::rate(self.jet(), part), [self.here(), self.start()]);
        let mut late = end.jet.as_ref()[1];
        late.times(R::from_f64(2.0 * from.unit / end.unit * (2.0 * R::epsilon() * end.time().magnitude() / end.unit)));
        self.estimate.agree(part, [&polynomial, rates], &self.jet()[0], &late)
    }
}
