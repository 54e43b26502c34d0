//! The discrete gradient with constraints.

use super::step::{Equation, Prepared};
use crate::method::discrete_gradient::DiscreteGradient;
use crate::method::{Deciding, Probe, Refusal, Step, StepsOf, check_conditions, check_poles, start};
use crate::scalar::Real;
use crate::solving::newton::Newton;
use crate::space::vector::moved;
use crate::space::{Array, Compensated, Record, Summation, Tape};
use crate::system::{ByConstraint, ConstrainedStep, held, on_one_side};

/// What a step hands on to the next one.
#[derive(Clone, Debug)]
pub struct Memory<S: ConstrainedStep<DiscreteGradient, R>, R: Real> {
    newton: Newton<S::Unknown>,
    sums: Compensated<S::Phase>,
}

impl<S: ConstrainedStep<DiscreteGradient, R>, R: Real> Record<R> for Memory<S, R> {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.newton.record(tape);
        self.sums.record(tape);
    }
}

/// q₁ − q₀ = h ∇̄ₚH, p₁ − p₀ = −h (∇̄_qH + ḡᵀλ), g(q₁) = 0 with the tree slopes of H and of every g: H changes by
/// −λ·(g(q₁) − g(q₀)) = 0.
impl<S: ConstrainedStep<DiscreteGradient, R>, R: Real> StepsOf<DiscreteGradient, S, R> for ByConstraint {
    type Prepared = Prepared<S::Constants, R>;
    type Memory = Memory<S, R>;
    /// Momenta carry along what leads away from the constraints, of order h²: made tangent in the end, they change the energy by h⁴.
    const COMPOSES_TO: u32 = 4;
    /// What multiplies h²λ is known to the rounding of q, and nothing makes momenta tangent again.
    const ROUGH_IF_SHORT: bool = true;

    fn prepare(system: &S, h: R) -> Self::Prepared {
        Prepared::new(system, h)
    }

    fn memory() -> Self::Memory {
        Memory { newton: Newton::new(S::Unknown::LEN, 1), sums: Compensated::new() }
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { constants, poles, h }: &Self::Prepared,
        Memory { newton, sums }: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let (z, half) = (x.z, R::from_f64(0.5));
        let middle = t + half * *h;
        probe.visit(t, &z, &());
        let equation = Equation { system, constants, begun: system.begin(constants, middle, &z), t, z };
        let mut deciding = Deciding::of::<S, R>(probe, &z);
        let increments = equation.solve(newton, &mut deciding)?;
        let Deciding { probe, decided } = deciding;

        // The equation itself has the gradients in the middle beside those at the end.
        let between = moved(&z[0], half, &increments[0]);
        on_one_side(system, (t, &z), [&z[0], &between]).map_err(|what| Refusal::DependentConstraints { what })?;
        let before = start::<S, R, C>(x);
        x.add_with(sums, &increments, &S::Phase::zero());
        held(system, t + *h, [&z, &x.z])?;
        check_conditions(system, middle, &decided, x)?;
        check_poles(poles, true, &before, Step { system, t, end, x, probe })
    }
}
