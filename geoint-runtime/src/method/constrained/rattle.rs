//! The method RATTLE for systems with constraints.

use super::step::{ConstrainedMethod, Momenta, MultiplierStep};
use crate::implicit_method;
use crate::method::composition::substeps;
use crate::method::implicit::ImplicitMethod;
use crate::method::{Claims, Name};
use crate::scalar::Real;
use crate::system::ConstrainedStep;

/// RATTLE, for positions with g(q) = 0. With G = ∂g/∂q, and multipliers λ and μ, a step is
///
/// - p½ = p₀ − h/2 (∂H/∂q + Gᵀλ)(q₀, p½),
/// - q₁ = q₀ + h/2 (∂H/∂p(q₀, p½) + ∂H/∂p(q₁, p½)), with λ from g(q₁) = 0,
/// - p₁ = p½ − h/2 (∂H/∂q + Gᵀμ)(q₁, p½), with μ from G ∂H/∂p(q₁, p₁) = 0.
///
/// Order 2, symmetric, and a symplectic map of the states on the constraints. With short steps the energy oscillates and does not drift. Constraints and their
/// rates G ∂H/∂p are met to rounding. For H = T(p) + V(q) with a constant mass matrix and without damping, the multipliers λ are the only unknowns, and a step
/// evaluates the force at both ends. With a damping matrix C the force is −∂H/∂q − C ∂H/∂p, and the map is not symplectic.
///
/// A step over a position at which the constraints depend on each other is refused, because more than one motion continues from this position. The check
/// is a test and no proof: it may miss two such positions in one step.
///
/// H. C. Andersen, J. Comput. Phys. 52 (1983) 24; B. Leimkuhler & R. Skeel, J. Comput. Phys. 112 (1994) 117; for every H: L. Jay, SIAM J. Numer. Anal.
/// 33 (1996) 368; Hairer, Lubich & Wanner, *Geometric Numerical Integration*, (VII.1.26).
#[doc(alias("SHAKE", "RATTLE"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rattle;

implicit_method!(Rattle, |_| Name::new("Rattle"), Claims::of_order(2).symmetric().symplectic());
substeps!([] Rattle);

impl ConstrainedMethod for Rattle {
    const MOMENTA: Momenta = Momenta::MadeTangent;
}

impl<S: ConstrainedStep<Rattle, R>, R: Real> ImplicitMethod<S, R> for Rattle {
    type Proof = <S as ConstrainedStep<Rattle, R>>::Proof;
    type Step = MultiplierStep<Rattle>;

    fn step(self) -> Self::Step {
        MultiplierStep(self)
    }
}
