//! What lies on the way of a step of which the series says nothing?

use super::Steps;
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate};
use crate::system::Jets;
use crate::taylor::{self, TaylorMethod};

/// Points per time in which the state changes. A barrier wider than their distance is seen.
const POINTS: f64 = 64.0;

/// A step of which the series says nothing is at most so many of these times long.
const LONGEST: f64 = 16.0;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Steps<S, M, R> {
    /// Whether the length of steps follows from a series that is known to converge. Where a force is constant to rounding, as far from a barrier or
    /// long before a pulse, the coefficients do not tell how far that lasts.
    #[inline(always)]
    pub(super) fn is_informed(&self) -> bool {
        self.is_fixed() || self.estimate.converges(self.jet())
    }

    /// Whether the state moves by more than its size in a step of length `h`. A series converges over such a step only if its force is nearly constant.
    #[inline(always)]
    pub(super) fn moves_far(&self, h: f64) -> bool {
        !self.is_fixed() && self.estimate.moves_far(self.here().in_units(h), &self.jet()[0])
    }

    /// The longest step of which the series says nothing.
    #[cold]
    pub(super) fn longest_uninformed(&self) -> f64 {
        self.pace().map_or(f64::INFINITY, |time| LONGEST * time)
    }

    /// Whether the rates at points on the way of a step of length `h` are those of its polynomial.
    #[cold]
    #[inline(never)]
    pub(super) fn agrees_on_way(&self, h: f64) -> bool {
        let here = self.here();
        let time = self.pace().unwrap_or(h.abs());
        let points = libm::ceil(POINTS * (h.abs() / time).min(LONGEST));
        (1..points as u32).all(|point| {
            let after = h * (f64::from(point) / points);
            let part = here.in_units(after);
            let mut x = taylor::increment(self.jet(), part);
            x.add_scaled(R::from_f64(1.0), &PerCoordinate::of(&here.x));
            let (mut jet, mut switches) = ([PerCoordinate::zero(); 2], [S::Switches::zero(); 2]);
            let [unit, after] = [here.unit, after].map(R::from_f64);
            self.system.jet::<2>(unit, here.time() + after, &x.z, &x.s, &mut jet, &mut switches);
            let polynomial = taylor::rate(self.jet(), part);
            // Where there are no rates is a matter of domains.
            !jet[0].is_finite()
                || self.estimate.agree(here.in_units(h), [&polynomial, &jet[0]], &self.jet()[0], &PerCoordinate::zero())
        })
    }
}
