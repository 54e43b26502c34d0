//! Splittings of contact systems with constraints: RATTLE between two dampings.

use super::step::{ConstrainedMethod, MultiplierStep};
use crate::implicit_method;
use crate::method::composition::substeps;
use crate::method::contact::ContactLeapfrog;
use crate::method::flows::pieces::ContactSplitting;
use crate::method::implicit::ImplicitMethod;
use crate::method::{Claims, Name};
use crate::scalar::Real;
use crate::system::ConstrainedStep;

/// The splitting `M` for systems with constraints g(q, t) = 0: D₁ ∘ [`Rattle`](crate::Rattle) ∘ D₀ for H = H₀(q, p, t) + γ(t)·s.
///
/// RATTLE solves H₀. It adds p̄·(q₁ − q₀) − h/2 (H₀(q₀, p̄, t₀) + H₀(q₁, p̄, t₁)) to the action, with the momenta p̄ in its middle. D₀ and D₁ multiply p and
/// s by a factor:
///
/// - [`ContactSplitting`]: e^(−hγ/2) both, with γ in the middle of the step, the flow of γs for h/2.
/// - [`ContactLeapfrog`]: 1 − hγ₀/2 and 1/(1 + hγ₁/2), with γ at the start and at the end. A step is refused unless both are positive.
///
/// Order 2, symmetric, a contact map of the states on the constraints. If H₀ and the constraints have a linear symmetry, its momentum is multiplied by the
/// product of both factors, to rounding. The projection of the momenta comes last, because D₁ turns tangent momenta away from moving constraints. Positions
/// keep their constraints and momenta are tangent, as those of RATTLE.
///
/// M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206, without constraints.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DampedRattle<M>(
    /// The splitting.
    pub M,
);

impl ConstrainedMethod for ContactSplitting {
    // The momenta at the end are projected.
    const KEEPS_ENERGY: bool = false;
}

impl ConstrainedMethod for ContactLeapfrog {
    const KEEPS_ENERGY: bool = false;
}

/// Implements the method for a splitting, under the name of the splitting. The claim `symplectic` means a contact map for systems with an action.
macro_rules! damped {
    ($($splitting:ident)*) => { $(
        implicit_method!(
            DampedRattle<$splitting>,
            |_| Name::new(stringify!($splitting)),
            Claims::of_order(2).symmetric().symplectic()
        );
        substeps!([] DampedRattle<$splitting>);

        impl From<$splitting> for DampedRattle<$splitting> {
            fn from(splitting: $splitting) -> Self {
                DampedRattle(splitting)
            }
        }

        impl<S: ConstrainedStep<$splitting, R>, R: Real> ImplicitMethod<S, R> for DampedRattle<$splitting> {
            type Proof = <S as ConstrainedStep<$splitting, R>>::Proof;
            type Step = MultiplierStep<$splitting>;

            fn step(self) -> Self::Step {
                MultiplierStep(self.0)
            }
        }
    )* };
}

damped!(ContactSplitting ContactLeapfrog);
