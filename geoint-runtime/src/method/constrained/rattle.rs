//! RATTLE.

use super::step::{Equation, Prepared};
use crate::method::composition::substeps;
use crate::method::{Claims, Deciding, Method, Name, Probe, Refusal, Step, check_end, start};
use crate::scalar::Real;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, sum};
use crate::space::{Array, Summation};
use crate::system::{ConstrainedStep, held, on_one_side, tangent};

/// p½ = p₀ − h/2 (∂H/∂q + Gᵀλ)(q₀, p½), q₁ = q₀ + h/2 (∂H/∂p(q₀, p½) + ∂H/∂p(q₁, p½)) with g(q₁) = 0, and
/// p₁ = p½ − h/2 (∂H/∂q + Gᵀμ)(q₁, p½) with G ∂H/∂p(q₁, p₁) = 0.
///
/// Order 2, symmetric, and a symplectic map of the states on the constraints: the energy swings and does not drift. Constraints and their
/// rates are met to rounding. For H = T(p) + V(q) with a constant mass matrix the equation is one for the multipliers λ alone, and a step
/// costs one force. With damping C the force is −∂H/∂q − C ∂H/∂p.
///
/// A step over a position at which the constraints depend on each other is refused: more than one way leads on from there.
/// H. C. Andersen, J. Comput. Phys. 52 (1983) 24; B. Leimkuhler & R. Skeel, J. Comput. Phys. 112 (1994) 117; for every H: L. Jay, SIAM
/// J. Numer. Anal. 33 (1996) 368; Hairer, Lubich & Wanner, *Geometric Numerical Integration*, (VII.1.26).
#[doc(alias("SHAKE", "RATTLE"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rattle;

impl<S: ConstrainedStep<Rattle, R>, R: Real> Method<S, R> for Rattle {
    type Proof = <S as ConstrainedStep<Rattle, R>>::Proof;
    type Prepared = Prepared<S::Constants, R>;
    type Memory = Newton<S::Unknown>;

    fn claims(&self) -> Claims {
        Claims::of_order(2).symmetric().symplectic()
    }

    fn name(&self) -> Name {
        Name::new("Rattle")
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared::new(system, h)
    }

    fn memory() -> Self::Memory {
        Newton::new(S::Unknown::LEN, 1)
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { constants, poles, .. }: &Self::Prepared,
        newton: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let z = x.z;
        probe.visit(t, &z, &());
        let equation = Equation { system, constants, begun: system.begin(constants, t, &z), t, z };
        let mut deciding = Deciding::of::<S, R>(probe, &z);
        let mut increments = equation.solve(newton, &mut deciding)?;
        let Deciding { probe, .. } = deciding;

        // The momentum where the step ends, made tangent there.
        let [q, p] = sum(&z, &increments);
        increments[1] = difference(&tangent(system, end, [q, p])?, &z[1]);
        on_one_side(system, (t, &z), [&z[0], &q]).map_err(|what| Refusal::DependentConstraints { what })?;
        let before = start::<S, R, C>(x);
        x.add(&increments);
        held(system, end, [&z, &x.z])?;
        check_end(poles, &before, Step { system, t, end, x, probe })
    }
}

substeps!([] Rattle);
