//! Causes of refused steps.

use super::Series;
use crate::running::error::StepError;
use crate::running::step_size::Bounds;
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::PerCoordinate;
use crate::system::Jets;
use crate::taylor::TaylorMethod;

/// A base that changes by half of itself or more within this many shortest steps counts as vanishing nearby.
const NEAR: f64 = 16.0;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Series<S, M, R> {
    /// Returns why a step of the length `wish` is refused, which the tolerance asks for: the series diverges if `wish` is below the resolution of time. Otherwise the
    /// step that the user allows is too inaccurate: its error grows like its length to the power of the order.
    #[cold]
    pub(super) fn too_short(&self, wish: f64, bounds: &Bounds) -> Failure {
        if wish < self.shortest() {
            return Failure::Diverges;
        }
        Failure::Inaccurate { error: Real::powf(bounds.shortest / wish, self.terms() as f64) }
    }

    /// Returns the error of a refused step.
    #[cold]
    pub(super) fn refused(&self, t: f64, h: f64, failure: Failure) -> StepError {
        let h = self.towards(h);
        let failure = match failure {
            Failure::Diverges => self.without_series(),
            // The iterations are those of a correction, which mean nothing to the caller.
            Failure::NotConverged { .. } if self.is_fixed() => Failure::Singular,
            failure => failure,
        };
        // A run that slides was not refused a step: shorter steps do not help.
        let was_shortened = !self.is_fixed() && !matches!(failure, Failure::Sliding);
        if was_shortened { StepError::of_shortest(failure, t, h) } else { StepError::new(failure, t, h) }
    }

    /// Returns the shortest step without the bounds of the user.
    fn shortest(&self) -> f64 {
        Bounds::default().at(signed(self.now()), R::epsilon(), self.here().unit).shortest
    }

    /// Returns why the solution has no series here.
    fn without_series(&self) -> Failure {
        match self.vanishing() {
            Some(what) => Failure::OutsideDomain { what },
            None if !self.jet()[0].is_finite() => Failure::NoRates,
            None => Failure::Diverges,
        }
    }

    /// Looks for a power that has no Taylor series where its base vanishes. Returns its message if the base is zero here, or changes by at least half of itself
    /// within `NEAR` shortest steps. With steps of fixed length only a base that is zero here counts: a long step may have led to rates so large that every base
    /// would pass the test.
    fn vanishing(&self) -> Option<&'static str> {
        let next = if self.is_fixed() { 0.0 } else { NEAR * self.shortest() };
        let (here, h) = (self.here(), self.towards(next));
        let (t, mut there) = (here.time() + R::from_f64(h), PerCoordinate::of(&here.x));
        there.add_scaled(R::from_f64(h / here.unit), &here.jet.as_ref()[0]);
        let (mut found, mut count) = (None, 0);
        self.system.powers(here.time(), &here.x.z, &here.x.s, |what, base| {
            let mut i = 0;
            self.system.powers(t, &there.z, &there.s, |_, later| {
                if i == count && 2.0 * (later - base).magnitude() >= base.magnitude() {
                    found = found.or(Some(what));
                }
                i += 1;
            });
            count += 1;
        });
        found
    }
}
