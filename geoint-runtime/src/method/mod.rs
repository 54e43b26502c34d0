//! What a method is: coefficients prepared once for a step size, and a step in place. The families of methods, a module each.

pub mod composition;
pub mod contact;
pub mod corrected;
pub mod discrete_gradient;
pub mod explicit;
mod field;
pub mod gauss;
pub mod kahan;
mod probe;
pub mod splitting;
pub mod tableau;
pub mod tables;

pub use field::{gradient_kick, modified_verlet};
pub use probe::{Probe, Unwatched};
pub(crate) use probe::{check_end, check_poles, start};

pub use crate::solving::Refusal;

use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::PhaseSpace;

/// What a method promises where nothing is damped; the tests run over the list of all methods and hold each to it.
///
/// Damping leaves order and symmetry as they are. The step is then no symplectic map, and the energy falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Claims {
    /// Global error O(hᵖ).
    pub order: u32,
    /// Φ(−h) ∘ Φ(h) is the identity.
    pub symmetric: bool,
    /// The step is a symplectic map; of a contact system a contact map, which multiplies the form ds − p dq by a positive factor.
    pub symplectic: bool,
    /// The step keeps H of an autonomous system to rounding; of a contact system it keeps the law of its decay, as that of
    /// [`ContactDiscreteGradient`](crate::ContactDiscreteGradient), H₁ = H₀ exp(−h g_s).
    pub conserves_energy: bool,
}

/// A one-step method for the system `S`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a method for `{S}`",
    note = "a composition becomes a method with the map that it composes: `Yoshida4.of(StormerVerlet)`",
    note = "`Gauss` has 1 to 6 stages"
)]
pub trait Method<S: PhaseSpace<R>, R: Real = f64>: Copy {
    /// Everything that depends on the method, the parameters and h; and what implicit methods remember of earlier steps to
    /// guess the next one.
    type Prepared: Copy;

    /// What the method promises.
    fn claims(&self) -> Claims;

    /// Coefficients for steps of length `h`.
    fn prepare(&self, system: &S, h: R) -> Self::Prepared;

    /// One step from time `t`, in place.
    ///
    /// Every point at which the energy is looked at is shown to `probe`.
    fn step<C: Summation<S::Array>, P: Probe<S, R>>(
        prepared: &mut Self::Prepared,
        t: R,
        x: &mut Point<S::Array, C, S::Action>,
        probe: &mut P,
    ) -> Result<(), Refusal>;

    /// `steps` steps, of which the `i`-th starts at `clock.at(i)`.
    #[inline(always)]
    fn advance<C: Summation<S::Array>>(
        prepared: &mut Self::Prepared,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Array, C, S::Action>,
    ) -> Result<(), Refusal> {
        for i in 0..steps {
            let t = clock.at(i) + x.ahead;
            Self::step(prepared, t, x, &mut Unwatched)?;
        }
        Ok(())
    }
}

/// The times at which steps start.
#[derive(Clone, Copy, Debug)]
pub struct Clock<R> {
    pub(crate) t0: R,
    pub(crate) h: R,
    pub(crate) first: u64,
}

impl<R: Real> Clock<R> {
    /// The time at which step `i` starts: t₀ + (n + i)·h.
    #[inline(always)]
    pub fn at(&self, i: u64) -> R {
        R::time(self.t0, self.first + i, self.h)
    }
}
