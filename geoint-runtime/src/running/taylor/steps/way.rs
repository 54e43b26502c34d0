//! What lies on the way of a step of which the series says nothing?
//!
//! Far from a barrier, or long before a pulse, the force is zero to rounding. Then the coefficients do not tell how long it stays so, and the step is
//! uninformed: it looks at the rates at points on its way.

use super::Steps;
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate};
use crate::system::Jets;
use crate::taylor::{self, TaylorMethod};

/// Points in the time in which the state changes by its size, and the fewest points in a step. A barrier wider than their distance is seen.
const POINTS: f64 = 64.0;

/// An uninformed step is at most this many of these times long.
const LONGEST: f64 = 16.0;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Steps<S, M, R> {
    /// Returns whether steps never look at their way. Those of given length do not. Those of energies with conditions do not, either: beyond a condition
    /// the rates differ from the series, and conditions are found in another way. A narrow barrier of such an energy may be missed.
    #[inline(always)]
    fn never_looks(&self) -> bool {
        S::Switches::LEN > 0 || self.is_fixed()
    }

    /// Returns whether the length of the step follows from a series that converges.
    #[inline(always)]
    pub(super) fn is_informed(&self) -> bool {
        self.never_looks() || self.estimate.converges(self.jet())
    }

    /// Returns whether the state moves by more than its size in a step of length `h`. A series converges over such a step only if the force is nearly
    /// constant.
    #[inline(always)]
    pub(super) fn moves_far(&self, h: f64) -> bool {
        !self.never_looks() && self.estimate.moves_far(self.here().in_units(h), &self.jet()[0])
    }

    /// Returns the length of the longest uninformed step.
    #[cold]
    pub(super) fn longest_uninformed(&self) -> f64 {
        self.pace().map_or(f64::INFINITY, |time| LONGEST * time)
    }

    /// Returns whether the rates at points on the way of a step of length `h` are those of its polynomial.
    #[cold]
    #[inline(never)]
    pub(super) fn agrees_on_way(&self, h: f64) -> bool {
        let here = self.here();
        let time = self.pace().unwrap_or(h.abs());
        // For a coordinate that begins at zero the time may be far too long.
        let points = libm::ceil(POINTS * (h.abs() / time).clamp(1.0, LONGEST));
        (1..points as u32).all(|point| {
            let after = h * (f64::from(point) / points);
            let part = here.in_units(after);
            let mut x = taylor::increment(self.jet(), part);
            x.add_scaled(R::from_f64(1.0), &PerCoordinate::of(&here.x));
            let (mut jet, mut switches) = ([PerCoordinate::zero(); 2], [S::Switches::zero(); 2]);
            let [unit, after] = [here.unit, after].map(R::from_f64);
            self.system.jet::<2>(unit, here.time() + after, &x.z, &x.s, &mut jet, &mut switches);
            let polynomial = taylor::rate(self.jet(), part);
            // Rates that are not finite are left to the check of domains at the end of the step.
            !jet[0].is_finite()
                || self.estimate.agree(here.in_units(h), [&polynomial, &jet[0]], &self.jet()[0], &PerCoordinate::zero())
        })
    }
}
