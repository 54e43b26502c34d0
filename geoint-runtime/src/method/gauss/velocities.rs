//! The step of a Lagrangian. The unknowns are the velocities Vᵢ of all stages: with Qᵢ = q₀ + h Σ aᵢⱼ Vⱼ and pᵢ = p₀ + h Σ aᵢⱼ fⱼ,
//!
//! ∂L/∂v(Qᵢ, Vᵢ) = pᵢ, fⱼ = ∂L/∂q(Qⱼ, Vⱼ) less friction.

use super::prepared::Scaled;
use super::stages::{Form, Part, Rows, Slopes, Values, assemble, shifts};
use super::{Gauss, GaussTableau};
use crate::method::implicit::{Arrival, Departure, Equation, ImplicitStep, Increment, Policy, Stage, Units, Watch};
use crate::method::{Probe, Refusal};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, moved, scaled, sum};
use crate::space::{Array, Square};
use crate::system::{Regular, VelocityForm, acceleration, row_units, velocity_near};

/// The step that is solved for velocities at its stages.
#[derive(Clone, Copy, Debug)]
pub struct VelocityStages<const S: usize>;

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Constants<P, R, const S: usize> {
    pub(in crate::method) kernel: P,
    pub(in crate::method) scaled: Scaled<R, S>,
    /// The mass matrix is positive definite everywhere.
    pub(in crate::method) is_definite: bool,
}

/// The sign of the determinant of the mass matrix.
#[derive(Clone, Copy, Debug)]
pub struct Start<R> {
    sign: R,
}

/// All derivatives of momentum and force are given.
const FORM: Form = Form {
    value: Slopes { by_unknown: Part::Given, by_shift: Part::Given },
    rate: Slopes { by_unknown: Part::Given, by_shift: Part::Given },
    rows: Rows::Scaled,
};

/// The last evaluation, and its velocities.
#[derive(Clone, Copy, Debug)]
pub struct Seen<A: Array, const S: usize> {
    v: [A; S],
    stages: [Values<A>; S],
}

impl<Y: VelocityForm<R>, R: Real, const S: usize> Equation<'_, VelocityStages<S>, Y, R>
where
    Gauss<S>: GaussTableau<S>,
{
    /// Qᵢ, with the momenta before the step.
    #[inline(always)]
    fn point(&self, i: usize, v: &[Y::Array; S]) -> Y::Phase {
        let mut change = Y::Array::zero();
        for (a, v) in self.constants.scaled.coupling[i].iter().zip(v) {
            change.add_scaled(*a, v);
        }
        [sum(&self.from.z[0], &change), self.from.z[1]]
    }
}

impl<Y: VelocityForm<R>, R: Real, const S: usize> ImplicitStep<Y, R> for VelocityStages<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Unknown = [Y::Array; S];
    type Constants = Constants<<Y as VelocityForm<R>>::Constants, R, S>;
    type Start = Start<R>;
    type History = Regular<Y::Array>;
    type Seen = Seen<Y::Array, S>;
    type Kept = ();
    type Solver = Newton<[Y::Array; S]>;

    const POLICY: Policy = Policy::of(Units { alike: Y::Array::LEN, kinds: 1 });
    const STAGES: usize = S;

    fn constants(self, system: &Y, h: R) -> Self::Constants {
        let kernel = VelocityForm::constants(system);
        Constants { kernel, scaled: Scaled::by(h), is_definite: system.is_definite() }
    }

    fn history() -> Self::History {
        Regular::unknown()
    }

    fn unseen() -> Self::Seen {
        Seen { v: [Y::Array::zero(); S], stages: [Values::none(); S] }
    }

    #[inline(always)]
    fn begin(
        from: &Departure<'_, Y, R>,
        constants: &Self::Constants,
        regular: &mut Self::History,
    ) -> Result<Self::Start, Refusal> {
        Ok(Start { sign: regular.begin(from.system, constants.is_definite, (from.t, &from.z, &()))? })
    }

    /// q₀/h: rounding of a velocity is relative to it, because h times the velocity is added to q₀.
    #[inline(always)]
    fn origin(Equation { from, .. }: &Equation<'_, Self, Y, R>) -> [Y::Array; S] {
        [scaled(R::from_f64(1.0) / from.h, &from.z[0]); S]
    }

    /// The velocities as if v' were constant.
    fn guess(Equation { from, constants, .. }: &Equation<'_, Self, Y, R>) -> [Y::Array; S] {
        let none = Y::Array::zero();
        let v = velocity_near(from.system, from.t, &from.z, &(), none).unwrap_or(none);
        let rate = acceleration(from.system, from.t, &from.z[0], &v);
        constants.scaled.nodes.map(|node| moved(&v, node, &rate))
    }

    /// ∂L/∂v − pᵢ, each row over |Mᵢᵢ|, so that it has the unit of the velocity.
    #[inline(always)]
    fn residual<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        watch: &mut Watch<'_, Y, R, P, Self::Seen>,
        v: &[Y::Array; S],
        matrix: &mut Square<[Y::Array; S]>,
    ) -> [Y::Array; S] {
        let Equation { from, constants: Constants { kernel, scaled: Scaled { coupling, nodes, .. }, .. }, start } =
            equation;
        watch.seen.v = *v;
        for i in 0..S {
            let (t, z) = (from.t + nodes[i], equation.point(i, v));
            watch.visit(t, &z, &());
            let stage = &mut watch.seen.stages[i];
            let mut slopes = [Y::Array::fill(Y::Array::zero()); 4];
            from.system.stage(kernel, t, &z[0], &v[i], [&mut stage.value, &mut stage.rate], &mut slopes);
            let [momentum_by_q, mass, force_by_q, force_by_v] = slopes;
            stage.value = difference(&stage.value, &from.z[1]);
            stage.value_slopes = Slopes { by_unknown: mass, by_shift: momentum_by_q };
            stage.rate_slopes = Slopes { by_unknown: force_by_v, by_shift: force_by_q };
            stage.scales = row_units(&mass);
        }
        // The determinant has the sign of (det M)ˢ.
        if S % 2 == 1 {
            watch.seen.stages[0].scales.as_mut_slice()[0] *= start.sign;
        }
        assemble(FORM, coupling, &watch.seen.stages, None, matrix)
    }

    #[inline(always)]
    fn stage(equation: &Equation<'_, Self, Y, R>, i: usize, v: &[Y::Array; S]) -> Stage<Y, R> {
        Stage { t: equation.from.t + equation.constants.scaled.nodes[i], z: equation.point(i, v), s: () }
    }

    /// The forces are those of the last evaluation, corrected to first order: the square of the last correction is rounding.
    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, Y, R>,
        Solution { x: v, .. }: &Solution<[Y::Array; S]>,
        seen: &Self::Seen,
    ) -> Result<Increment<Y::Phase, ()>, Refusal> {
        let Scaled { coupling, weights, .. } = &equation.constants.scaled;
        let corrections: [Y::Array; S] = core::array::from_fn(|i| difference(&v[i], &seen.v[i]));
        let moved = shifts(coupling, &corrections);
        let (mut change, mut impulse) = (Y::Array::zero(), Y::Array::zero());
        for i in 0..S {
            change.add_scaled(weights[i], &v[i]);
            impulse.add_scaled(weights[i], &seen.stages[i].rate_after(FORM, &corrections[i], &moved[i]));
        }
        Ok(Increment::of([change, impulse]))
    }

    #[inline(always)]
    fn finish<P: Probe<Y, R>>(
        Equation { from, constants, .. }: &Equation<'_, Self, Y, R>,
        Solution { x: v, .. }: &Solution<[Y::Array; S]>,
        regular: &mut Self::History,
        Arrival { z, .. }: Arrival<'_, Y, R>,
    ) -> Result<(), Refusal> {
        let ends = [(from.t, &from.z, &()), (from.t + from.h, z, &())];
        regular.follow(from.system, constants.is_definite, ends, v[S - 1])
    }
}
