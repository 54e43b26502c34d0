//! Conditions of the energy that change sides within a step: it ends there.

use super::Steps;
use crate::scalar::{Real, signed};
use crate::space::Array;
use crate::system::Jets;
use crate::taylor::{self, TaylorMethod};

/// A condition that changes sides.
#[derive(Clone, Copy)]
pub(super) struct Switch {
    /// Which one.
    pub(super) place: usize,
    /// When, as a part of the step; at 0 it is on the wrong side of where it goes.
    pub(super) at: f64,
    /// What decides it has this sign afterwards.
    pub(super) sign: f64,
    /// Whether the step begins behind it, or before it, on the way there: where a step before has ended there, rates on both sides lead back.
    pub(super) back: bool,
}

/// Radii of convergence are estimates: what decides a condition has nearly that of the coordinates.
pub(super) const NEARLY: f64 = 1.25;

/// Conditions shorten no step by more than this.
const LEAST: f64 = 1.0 / (1 << 30) as f64;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Steps<S, M, R> {
    /// The first condition of the energy that changes sides within a step, and the length up to which there is no other: shorter where what
    /// decides conditions has series that end earlier than those of coordinates.
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
            let g = &g[..self.order().min(taylor::MOST)];
            let roots = taylor::roots(g, 0.0);
            let here = if g[0] == 0.0 { 0.0 } else { g[0].signum() };
            let back = g.get(1).is_some_and(|slope| slope * g[0] < 0.0);
            let at = match roots.as_slice() {
                // It is zero all along.
                _ if roots.sign == 0.0 => continue,
                // It leaves zero, or the side that it is on by rounding.
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

    /// The part of a step of length `h` at which the next change follows on this one: of the same condition, or of another one, later by more than
    /// rounding. All of it if none does.
    #[cold]
    #[inline(never)]
    pub(super) fn next_change(&self, h: f64, switch: Switch) -> f64 {
        let next = |place| {
            let after = if place == switch.place { switch.at } else { switch.at + 64.0 * R::epsilon() };
            let roots = taylor::roots(&self.condition(place, h)[..self.order().min(taylor::MOST)], 0.0);
            roots.as_slice().iter().copied().find(|root| *root > after).unwrap_or(1.0)
        };
        (0..S::Switches::LEN).map(next).fold(1.0, f64::min)
    }

    /// What decides a condition, in parts of a step.
    fn condition(&self, place: usize, h: f64) -> [f64; taylor::MOST] {
        let switches = &self.here().switches.as_ref()[..self.order()];
        taylor::in_parts(switches.iter().map(|switch| signed(switch.as_slice()[place])), self.here().in_units(h))
    }

    /// A step that is not longer than h in which all that decides conditions has the accuracy of the coordinates. Not without end shorter: behind
    /// the place at which a series ends there is another one.
    fn within_reach(&self, h: f64, shortest: f64) -> f64 {
        let count = self.order().min(taylor::MOST);
        let part = if self.is_fixed() { 0.5 } else { NEARLY * self.estimate.part_of_radius(self.order()) };
        let reach = |place| taylor::reach(&self.condition(place, h)[..count], part);
        let least = (0..S::Switches::LEN).map(reach).fold(1.0, f64::min);
        if least < 1.0 { self.towards((h.abs() * least.max(LEAST)).max(shortest.min(h.abs()))) } else { h }
    }

    /// Whether the point that was reached is on the other side of a condition that has no series here, as √q has none at q = 0: no polynomial tells
    /// where it changes.
    #[inline(always)]
    pub(super) fn has_unseen_switch(&self) -> bool {
        S::Switches::LEN > 0 && (0..S::Switches::LEN).any(|place| self.is_unseen(place))
    }

    #[inline(never)]
    fn is_unseen(&self, place: usize) -> bool {
        let [here, end] = [self.here(), self.start()].map(|end| &end.switches.as_ref()[..self.order()]);
        let [from, to] = [here, end].map(|terms| signed(terms[0].as_slice()[place]));
        from * to < 0.0 && here.iter().any(|term| !term.as_slice()[place].magnitude().is_finite())
    }

    /// Whether the point that was reached is behind a switch.
    pub(super) fn is_behind(&self, switch: Switch) -> bool {
        let value = signed(self.start().switches.as_ref()[0].as_slice()[switch.place]);
        value * switch.sign > 0.0
    }
}
