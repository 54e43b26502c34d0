//! A step between its flows: the state, and the point from which the next step goes on.

use super::kicks::Coordinates;
use super::moving::Moving;
use crate::method::open::Open;
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate, Point, Summation};
use crate::system::Cotangent;

/// Up to so many coordinates a step moves a copy of the point. In place, what the step before has left in memory number by number is read as
/// vectors, which waits until it is there: a third of Verlet's step of a pendulum.
const LOCAL: usize = 32;

/// A step between its flows.
///
/// Few coordinates move as the state, and are left for the next step. Many move where the next step goes on, and are copied to the state where the
/// step ends: two copies less, of the five that a step of a chain of 64 spent as much time on as on its forces.
#[derive(Debug)]
pub struct Between<'a, S: Cotangent<R>, R: Real, C> {
    pub(super) system: &'a S,
    /// From here the next step goes on.
    pub(super) from: &'a mut Coordinates<S, R>,
    /// What sums have lost there.
    lost: &'a mut Coordinates<S, R>,
    /// The state, and the sums of what moves.
    pub(super) x: &'a mut Point<S::Phase, C, S::Action>,
}

impl<'a, S: Cotangent<R>, R: Real, C: Summation<S::Phase>> Between<'a, S, R, C> {
    /// Whether coordinates are many.
    pub(super) const MANY: bool = S::Array::LEN > LOCAL;

    /// A step from `x` on, or from where the one before has left it.
    #[inline(always)]
    pub(super) fn of(
        system: &'a S,
        Open { from, lost, .. }: &'a mut Open<S::Phase, S::Action>,
        x: &'a mut Point<S::Phase, C, S::Action>,
    ) -> Self {
        Between { system, from, lost, x }
    }

    /// To the point from which flows move: the state, unless the step goes on from the one before.
    #[inline(always)]
    pub(super) fn enter(&mut self, goes_on: bool) {
        match goes_on {
            false if Self::MANY => *self.from = PerCoordinate::of(self.x),
            true if !Self::MANY => (self.x.z, self.x.s) = (self.from.z, self.from.s),
            _ => {}
        }
    }

    /// The point that flows move until the step [shows](Self::show) where it ends.
    #[inline(always)]
    pub(super) fn moving(&mut self) -> Moving<'_, S, R, C> {
        if Self::MANY { self.beyond() } else { Moving::of(self.system, self.x) }
    }

    /// State and next step are where flows have led to.
    #[inline(always)]
    pub(super) fn show(&mut self) {
        if Self::MANY {
            (self.x.z, self.x.s) = (self.from.z, self.from.s);
        } else {
            *self.from = PerCoordinate::of(self.x);
        }
    }

    /// The point from which the next step goes on.
    #[inline(always)]
    pub(super) fn beyond(&mut self) -> Moving<'_, S, R, C> {
        let (PerCoordinate { z: [q, p], s }, x) = (&mut *self.from, &mut *self.x);
        Moving { system: self.system, q, p, s, sums: &mut x.sums, compensation: &mut x.compensation }
    }

    /// The next step goes on with what sums have lost now.
    #[inline(always)]
    pub(super) fn leave(&mut self) {
        self.x.lost_to(self.lost);
    }
}
