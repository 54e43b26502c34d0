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
}

/// So many steps in a row that a switch has ended where they began are no accident.
pub(super) const STUCK: u32 = 16;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Steps<S, M, R> {
    /// The first condition of the energy that changes sides within a step.
    #[inline(always)]
    pub(super) fn switch(&self, h: f64) -> Option<Switch> {
        if S::Switches::LEN == 0 { None } else { self.first_switch(h) }
    }

    #[inline(never)]
    fn first_switch(&self, h: f64) -> Option<Switch> {
        let switches = &self.here().switches.as_ref()[..self.order()];
        let h = self.here().in_units(h);
        let mut first: Option<Switch> = None;
        for place in 0..S::Switches::LEN {
            let g = taylor::in_parts(switches.iter().map(|switch| signed(switch.as_slice()[place])), h);
            let roots = taylor::roots(&g[..self.order().min(taylor::MOST)], 0.0);
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
    pub(super) fn is_behind(&self, switch: Switch) -> bool {
        let value = signed(self.start().switches.as_ref()[0].as_slice()[switch.place]);
        value * switch.sign > 0.0
    }
}
