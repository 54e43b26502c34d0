//! Stages of a Lagrangian with an action, solved for their velocities: with qᵢ = q₀ + h Σ aᵢⱼ vⱼ,
//!
//! rᵢ ∂L/∂v(qᵢ, vᵢ, sᵢ) = p₀ + h Σ aᵢⱼ rⱼ fⱼ, sᵢ = s₀ + h Σ aᵢⱼ Lⱼ, rᵢ = 1 + h Σ aᵢⱼ rⱼ σⱼ with f = ∂L/∂q and σ = −∂L/∂s.

mod equation;

use super::ContactGauss;
use super::factors::Factors;
use crate::method::contact::ContactMidpoint;
use crate::method::gauss::prepared::Prepared;
use crate::method::gauss::velocities::{Memory, PreparedVelocities};
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::{Probe, Refusal, Step, StepsOf, check_end, check_way, start};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::{Array, Summation};
use crate::system::{ByVelocities, ContactVelocities, Regular};
use equation::{Last, Seen, StageVelocities};

/// One stage is the midpoint rule.
impl<Y: ContactVelocities<R>, R: Real> StepsOf<ContactMidpoint, Y, R> for ByVelocities {
    type Prepared = <ByVelocities as StepsOf<ContactGauss<1>, Y, R>>::Prepared;
    type Memory = <ByVelocities as StepsOf<ContactGauss<1>, Y, R>>::Memory;

    fn prepare(system: &Y, h: R) -> Self::Prepared {
        <ByVelocities as StepsOf<ContactGauss<1>, Y, R>>::prepare(system, h)
    }

    fn memory() -> Self::Memory {
        <ByVelocities as StepsOf<ContactGauss<1>, Y, R>>::memory()
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        <ByVelocities as StepsOf<ContactGauss<1>, Y, R>>::step(prepared, memory, step)
    }
}

impl<Y: ContactVelocities<R>, R: Real, const S: usize> StepsOf<ContactGauss<S>, Y, R> for ByVelocities
where
    Gauss<S>: GaussTableau<S>,
{
    type Prepared = PreparedVelocities<Y::StageConstants, R, S>;
    type Memory = Memory<Y::Moved, Y::Array, S>;

    fn prepare(system: &Y, h: R) -> Self::Prepared {
        PreparedVelocities {
            stages: Prepared::new(system, system.stage_constants(), h),
            is_definite: system.is_definite(),
        }
    }

    fn memory() -> Self::Memory {
        // Each unknown of a stage is of a kind of its own.
        Memory { newton: Newton::new(1, Y::Moved::LEN), regular: Regular::unknown() }
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        PreparedVelocities { stages: prepared, is_definite }: &Self::Prepared,
        Memory { newton, regular }: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let (none, z, s) = (Y::Array::zero(), x.z, x.s);
        probe.visit(t, &z, &s);
        let sign = regular.begin(system, *is_definite, (t, &z, &s))?;
        let Prepared { poles, coupling, nodes, constants, .. } = prepared;
        let known = if varying::<Y, R>() {
            None
        } else {
            let decay = nodes.map(|node| ContactVelocities::force(system, constants, t + node, &none, &none, &s).1);
            Some(Factors::new::<false>(coupling, &decay).ok_or(Refusal::Singular)?)
        };
        let equation = StageVelocities { system, prepared, t, z, s, sign, known };
        let mut seen = Seen { probe, last: Last::none() };
        let Solution { x: d, .. } = newton.solve(&equation, &mut seen)?;

        let Seen { probe, last } = seen;
        for i in 0..if varying::<Y, R>() { S } else { 0 } {
            let (stage_z, stage_s) = equation.stage(i, &d);
            let way = ([t, t + nodes[i]], [&z, &stage_z], [&s, &stage_s]);
            check_way::<Y, R, P>(poles, false, system, way, &mut x.doubtful)?;
        }
        let increments = equation.end(&d, &last).ok_or(Refusal::Singular)?;
        let before = start::<Y, R, C>(x);
        x.add_everywhere(&increments);
        let near = equation.apart(&d[S - 1]).0;
        regular.follow(system, *is_definite, [(t, &z, &s), (end, &x.z, &x.s)], near)?;
        check_end(poles, &before, Step { system, t, end, x, probe })
    }
}

/// Whether the factors, and s, depend on what is solved for: where L = L₀(q, v, t) − g(t)·s they do not.
const fn varying<Y: ContactVelocities<R>, R: Real>() -> bool {
    Y::Moved::LEN > Y::Array::LEN
}
