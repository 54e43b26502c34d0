//! The method RATTLE for systems with constraints.

use super::step::{ConstrainedMethod, MultiplierStep};
use crate::implicit_method;
use crate::method::composition::substeps;
use crate::method::implicit::ImplicitMethod;
use crate::method::{Claims, Name};
use crate::scalar::Real;
use crate::system::ConstrainedStep;

/// RATTLE, for states with g(q, t) = 0 and G ∂H/∂p + ∂g/∂t = 0, where G = ∂g/∂q. The start of a run must satisfy both. With multipliers λ and μ, a step is
///
/// - p½ = p₀ − h/2 (∂H/∂q + Gᵀλ)(q₀, p½),
/// - q₁ = q₀ + h/2 (∂H/∂p(q₀, p½) + ∂H/∂p(q₁, p½)), with λ from g(q₁, t₁) = 0,
/// - p₁ = p½ − h/2 (∂H/∂q + Gᵀμ)(q₁, p½), with μ from G ∂H/∂p(q₁, p₁) + ∂g/∂t = 0.
///
/// Order 2, symmetric, and a symplectic map of these states. With short steps the energy oscillates and does not drift. Both conditions are met to rounding.
/// For H = T(p) + V(q) with a constant mass matrix and without damping, the multipliers λ are the only unknowns, and a step evaluates the force at both ends.
/// Otherwise q₁ − q₀ and p½ − p₀ are unknowns, too. With a damping matrix C the force is −∂H/∂q − C ∂H/∂p, and the map is not symplectic.
///
/// A step over a position at which the rows of G are linearly dependent is refused, because more than one motion continues from this position. The check
/// is det(G W G₁ᵀ) > 0, with G and G₁ at q₀ and q₁, and W = ∂²H/∂p². It is a test and no proof, because two changes of the sign in one step cancel.
///
/// H. C. Andersen, J. Comput. Phys. 52 (1983) 24; B. Leimkuhler & R. Skeel, J. Comput. Phys. 112 (1994) 117; for every H: L. Jay, SIAM J. Numer. Anal.
/// 33 (1996) 368; Hairer, Lubich & Wanner, *Geometric Numerical Integration*, (VII.1.26).
#[doc(alias("SHAKE", "RATTLE"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rattle;

// `Claims` hold for systems without damping.
implicit_method!(Rattle, |_| Name::new("Rattle"), Claims::of_order(2).symmetric().symplectic());
// Compositions such as `Suzuki4.of(Rattle)`.
substeps!([] Rattle);

impl ConstrainedMethod for Rattle {
    // The multipliers μ project p₁, so that the velocity is tangent to the constraints.
    const KEEPS_ENERGY: bool = false;
}

impl<S: ConstrainedStep<Rattle, R>, R: Real> ImplicitMethod<S, R> for Rattle {
    type Proof = <S as ConstrainedStep<Rattle, R>>::Proof;
    type Step = MultiplierStep<Rattle>;

    fn step(self) -> Self::Step {
        MultiplierStep(self)
    }
}
