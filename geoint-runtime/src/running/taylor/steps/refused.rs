//! Why there is no step.

use super::Steps;
use crate::running::error::{Reason, StepError};
use crate::running::step_size::Bounds;
use crate::scalar::{Real, signed};
use crate::space::PerCoordinate;
use crate::system::Jets;
use crate::taylor::TaylorMethod;

/// What ends a series within so many of the shortest steps has ended it.
const NEAR: f64 = 16.0;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Steps<S, M, R> {
    /// Why a step is not shorter than the shortest: that changes no time, or is what the user allows.
    #[cold]
    pub(super) fn too_short(&self, wish: f64, bounds: &Bounds) -> Reason {
        if wish < self.shortest() {
            return Reason::Diverges;
        }
        Reason::Inaccurate { error: Real::powf(bounds.shortest / wish, self.order() as f64) }
    }

    /// The error of a step that is refused.
    #[cold]
    pub(super) fn refused(&self, t: f64, h: f64, reason: Reason) -> StepError {
        let h = self.towards(h);
        let reason = match reason {
            Reason::Diverges => self.without_series(),
            reason => reason,
        };
        match reason {
            _ if !self.is_fixed() || matches!(reason, Reason::Sliding | Reason::NoRates | Reason::Diverges) => {
                StepError::StepTooSmall { t, h, reason }
            }
            Reason::OutsideDomain { what } => StepError::OutsideDomain { t, what },
            Reason::NotConverged | Reason::Singular => StepError::Singular { t },
            Reason::Rounded => StepError::Rounded { t },
            Reason::Turned { what } => StepError::Turned { t, what },
            Reason::LedAstray => StepError::LedAstray { t },
            Reason::OutOfRange => StepError::OutOfRange { t },
            _ => StepError::NonFinite { t },
        }
    }

    /// The shortest step that changes time.
    fn shortest(&self) -> f64 {
        Bounds::default().at(signed(self.time()), R::epsilon(), self.here().unit).shortest
    }

    /// Why the solution has no series here.
    fn without_series(&self) -> Reason {
        match self.vanishing() {
            Some(what) => Reason::OutsideDomain { what },
            None if !self.jet()[0].is_finite() => Reason::NoRates,
            None => Reason::Diverges,
        }
    }

    /// A power that has no series where it vanishes, and does so here or next to here: what it is a power of changes by half of itself. Steps of one
    /// length may have led to where everything does.
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
