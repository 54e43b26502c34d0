//! The two points of a step with merged flows: the state, and the point from which the next step continues.
//!
//! The last flow of a step and the first flow of the next one are applied as one flow. The next step therefore continues from the point before the last flow.

use super::kicks::Coordinates;
use super::moving::Moving;
use crate::method::open::Open;
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate, Point, Summation};
use crate::system::Cotangent;

/// Largest number of positions for which a step moves a copy of the point. The copy avoids stalls of vector loads that follow scalar stores.
const MAX_COPIED: usize = 32;

/// The points of a step in progress.
///
/// In small systems the flows move the state, which is copied to the point of the next step. In large systems the flows move the point of the next step,
/// which is copied to the state at the end. This needs two copies fewer.
#[derive(Debug)]
pub struct Between<'a, S: Cotangent<R>, R: Real, C> {
    pub(super) system: &'a S,
    /// The point from which the next step continues.
    pub(super) from: &'a mut Coordinates<S, R>,
    /// The compensation of sums at `from`.
    compensation: &'a mut Coordinates<S, R>,
    /// The state, and the sums of the moving point.
    pub(super) x: &'a mut Point<S::Phase, C, S::Action>,
}

impl<'a, S: Cotangent<R>, R: Real, C: Summation<S::Phase>> Between<'a, S, R, C> {
    /// Whether the system has more than [`MAX_COPIED`] positions.
    pub(super) const MANY: bool = S::Array::LEN > MAX_COPIED;

    /// Returns the points of a step that starts at `x`, or at the point in `open`.
    #[inline(always)]
    pub(super) fn of(
        system: &'a S,
        Open { from, compensation, .. }: &'a mut Open<S::Phase, S::Action>,
        x: &'a mut Point<S::Phase, C, S::Action>,
    ) -> Self {
        Between { system, from, compensation, x }
    }

    /// Sets the moving point to the start of the step. This is the state, or `from` if the step continues the step before.
    #[inline(always)]
    pub(super) fn enter(&mut self, continues: bool) {
        match continues {
            false if Self::MANY => *self.from = PerCoordinate::of(self.x),
            true if !Self::MANY => (self.x.z, self.x.s) = (self.from.z, self.from.s),
            _ => {}
        }
    }

    /// Returns the point that flows move until [`show`](Self::show) is called.
    #[inline(always)]
    pub(super) fn moving(&mut self) -> Moving<'_, S, R, C> {
        if Self::MANY { self.beyond() } else { Moving::of(self.system, self.x) }
    }

    /// Copies the moving point, so that the state and `from` are equal.
    #[inline(always)]
    pub(super) fn show(&mut self) {
        if Self::MANY {
            (self.x.z, self.x.s) = (self.from.z, self.from.s);
        } else {
            *self.from = PerCoordinate::of(self.x);
        }
    }

    /// Returns the point from which the next step continues, for flows that move it.
    #[inline(always)]
    pub(super) fn beyond(&mut self) -> Moving<'_, S, R, C> {
        let (PerCoordinate { z: [q, p], s }, x) = (&mut *self.from, &mut *self.x);
        Moving { system: self.system, q, p, s, sums: &mut x.sums, compensation: &mut x.compensation }
    }

    /// Stores the present compensation of sums for the next step.
    #[inline(always)]
    pub(super) fn leave(&mut self) {
        self.x.lost_to(self.compensation);
    }
}
