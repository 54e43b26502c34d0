//! Causes of refused steps.

use super::Series;
use crate::running::error::StepError;
use crate::running::step_size::Bounds;
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::PerCoordinate;
use crate::system::Jets;
use crate::taylor::TaylorMethod;

/// A singularity within this many of the shortest steps counts as reached.
const NEAR: f64 = 16.0;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Series<S, M, R> {
    /// Returns the failure of a step below the shortest one. The shortest step is set by the resolution of time or by the user.
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
            // The number of iterations is that of a correction, not that of the step.
            Failure::NotConverged { .. } if self.is_fixed() => Failure::Singular,
            failure => failure,
        };
        // A run that slides was not refused a step: shorter steps do not help.
        let was_shortened = !self.is_fixed() && !matches!(failure, Failure::Sliding);
        if was_shortened { StepError::of_shortest(failure, t, h) } else { StepError::new(failure, t, h) }
    }

    /// Returns the shortest step that changes the time.
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

    /// Returns the message of a power without a series where its base vanishes, if the base vanishes here or nearby. Nearby means: the base changes
    /// by at least half of itself within `NEAR` shortest steps. Steps of fixed length check the present point only, since they may lead to points
    /// where every base changes so much.
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
