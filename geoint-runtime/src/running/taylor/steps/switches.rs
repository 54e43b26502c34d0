//! Ends a step where a condition of the energy changes.

use super::Series;
use crate::scalar::{Real, signed};
use crate::space::Array;
use crate::system::Jets;
use crate::taylor::{self, TaylorMethod};

/// A condition that changes within a step. Its deciding function changes sign there.
#[derive(Clone, Copy)]
pub(super) struct Switch {
    /// Index of the condition.
    pub(super) place: usize,
    /// Time of the change as a fraction of the step. 0 if the function starts with the wrong sign.
    pub(super) at: f64,
    /// Sign of the deciding function after the change.
    pub(super) sign: f64,
    /// Whether the function starts towards zero. If the step before has ended at this condition, the rates on both sides then lead back to it.
    pub(super) back: bool,
}

/// Accepted ratio of the radii of convergence of the coordinates and of a deciding function. Radii are only estimates, so small differences do not
/// shorten a step.
pub(super) const RADIUS_MARGIN: f64 = 1.25;

/// Largest reduction of a step by conditions.
const LEAST_PART: f64 = 1.0 / (1 << 30) as f64;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Series<S, M, R> {
    /// Returns the first change of a condition within a step, and the length that was searched. The search is shorter than `h` if the series of a
    /// deciding function ends earlier than those of the coordinates.
    #[inline(always)]
    pub(super) fn switch(&self, h: f64, shortest: f64) -> (f64, Option<Switch>) {
        if S::Switches::LEN == 0 { (h, None) } else { self.first_switch(h, shortest) }
    }

    #[inline(never)]
    fn first_switch(&self, h: f64, shortest: f64) -> (f64, Option<Switch>) {
        let h = self.within_reach(h, shortest);
        let mut first: Option<Switch> = None;
        for place in 0..S::Switches::LEN {
            let g = self.condition(place, h);
            let g = &g[..self.terms().min(taylor::MOST)];
            let roots = taylor::roots(g, 0.0);
            let here = if g[0] == 0.0 { 0.0 } else { g[0].signum() };
            let back = g.get(1).is_some_and(|slope| slope * g[0] < 0.0);
            let at = match roots.as_slice() {
                // Identically zero.
                _ if roots.sign == 0.0 => continue,
                // The function leaves zero, or a side on which it is by rounding only.
                _ if here != roots.sign => Switch { place, at: 0.0, sign: roots.sign, back },
                [] => continue,
                [at, ..] => Switch { place, at: *at, sign: -roots.sign, back },
            };
            if first.is_none_or(|first| at.at < first.at) {
                first = Some(at);
            }
        }
        (h, first)
    }

    /// Returns the fraction of a step of length `h` at which the next change after `switch` follows. This is another change of the same condition, or
    /// one of another condition, later by more than rounding. Returns 1 if there is none.
    #[cold]
    #[inline(never)]
    pub(super) fn next_change(&self, h: f64, switch: Switch) -> f64 {
        let next = |place| {
            let after = if place == switch.place { switch.at } else { switch.at + 64.0 * R::epsilon() };
            let roots = taylor::roots(&self.condition(place, h)[..self.terms().min(taylor::MOST)], 0.0);
            roots.as_slice().iter().copied().find(|root| *root > after).unwrap_or(1.0)
        };
        (0..S::Switches::LEN).map(next).fold(1.0, f64::min)
    }

    /// Returns the coefficients of the deciding function of a condition, with time as a fraction of a step of length `h`.
    fn condition(&self, place: usize, h: f64) -> [f64; taylor::MOST] {
        let switches = &self.here().switches.as_ref()[..self.terms()];
        taylor::in_parts(switches.iter().map(|switch| signed(switch.as_slice()[place])), self.here().in_units(h))
    }

    /// Returns a step, not longer than `h`, in which all deciding functions have the accuracy of the coordinates. `LEAST_PART` limits the reduction:
    /// otherwise a run could never pass a singularity of such a function.
    fn within_reach(&self, h: f64, shortest: f64) -> f64 {
        let count = self.terms().min(taylor::MOST);
        let part = if self.is_fixed() { 0.5 } else { RADIUS_MARGIN * self.estimate.part_of_radius(self.terms()) };
        let reach = |place| taylor::reach(&self.condition(place, h)[..count], part);
        let least = (0..S::Switches::LEN).map(reach).fold(1.0, f64::min);
        if least < 1.0 { self.towards((h.abs() * least.max(LEAST_PART)).max(shortest.min(h.abs()))) } else { h }
    }

    /// Returns whether the end of the attempt is on the other side of a condition that has no series here, as √q at q = 0. No polynomial then gives
    /// the time of the change.
    #[inline(always)]
    pub(super) fn has_unseen_switch(&self) -> bool {
        S::Switches::LEN > 0 && (0..S::Switches::LEN).any(|place| self.is_unseen(place))
    }

    #[inline(never)]
    fn is_unseen(&self, place: usize) -> bool {
        let [here, end] = [self.here(), self.start()].map(|end| &end.switches.as_ref()[..self.terms()]);
        let [from, to] = [here, end].map(|terms| signed(terms[0].as_slice()[place]));
        from * to < 0.0 && here.iter().any(|term| !term.as_slice()[place].magnitude().is_finite())
    }

    /// Returns whether the end of the attempt is beyond a change.
    pub(super) fn is_behind(&self, switch: Switch) -> bool {
        let value = signed(self.start().switches.as_ref()[0].as_slice()[switch.place]);
        value * switch.sign > 0.0
    }
}
