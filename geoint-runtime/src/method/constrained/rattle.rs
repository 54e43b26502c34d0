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
/// Order 2, symmetric, and a symplectic map of the states on the constraints. The energy oscillates and does not drift. Constraints and their rates are
/// met to rounding. For H = T(p) + V(q) with a constant mass matrix, the multipliers λ are the only unknowns, and a step costs one force. With damping
/// C the force is −∂H/∂q − C ∂H/∂p.
///
/// A step over a position at which the constraints depend on each other is refused, because more than one motion continues from this position.
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
