//! Checks the rates between the ends of a step whose series is uninformative.
//!
//! Far from a barrier, or long before a pulse, the force is zero up to rounding. The coefficients then do not show how long it remains zero. Such a
//! step is called uninformed. The rates are compared at points within it.

use super::Series;
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate};
use crate::system::Jets;
use crate::taylor::{self, TaylorMethod};

/// Number of points in the time in which the state changes by its size, and minimum number in a step. A barrier wider than their distance is
/// detected.
const POINTS: f64 = 64.0;

/// Maximum length of an uninformed step, in times in which the state changes by its size.
const LONGEST: f64 = 16.0;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Series<S, M, R> {
    /// Returns whether steps are never checked between their ends. Steps of fixed length are not. Steps of an energy with conditions are not, either:
    /// beyond a condition the rates differ from the series, and changes of conditions are found in another way. A narrow barrier of such an energy
    /// may be missed.
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

    /// Returns whether the rates at points within a step of length `h` agree with those of its polynomial.
    #[cold]
    #[inline(never)]
    pub(super) fn agrees_on_way(&self, h: f64) -> bool {
        let here = self.here();
        let time = self.pace().unwrap_or(h.abs());
        // The time of change may be far too long for a coordinate that starts at zero.
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
