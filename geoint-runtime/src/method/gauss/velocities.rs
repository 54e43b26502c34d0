//! The step of a Lagrangian that is solved for velocities: with Qᵢ = q₀ + h Σ aᵢⱼ Vⱼ and pᵢ = p₀ + h Σ aᵢⱼ fⱼ,
//!
//! ∂L/∂v(Qᵢ, Vᵢ) = pᵢ, fⱼ = ∂L/∂q(Qⱼ, Vⱼ) less friction.

use super::prepared::Scaled;
use super::{Gauss, GaussTableau};
use crate::method::implicit::{Arrival, Departure, Equation, ImplicitStep, Increment, Policy, Stage, Units, Watch};
use crate::method::{Probe, Refusal};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, dot, moved, scaled, sum};
use crate::space::{Array, Square};
use crate::system::{Regular, VelocityForm, acceleration, row_scale, velocity_near};

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

/// Values at a stage, and [∂p/∂q, ∂p/∂v, ∂f/∂q, ∂f/∂v].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Values<A: Array> {
    momentum: A,
    force: A,
    derivatives: [Square<A>; 4],
}

impl<A: Array> Values<A> {
    fn none() -> Self {
        let none = A::zero();
        Values { momentum: none, force: none, derivatives: [A::fill(none); 4] }
    }

    /// The force after small changes of position and velocity.
    #[inline(always)]
    fn force_after(&self, dq: &A, dv: &A) -> A {
        let mut force = self.force;
        let rows = A::entries_of::<A>(&self.derivatives[FORCE_BY_Q]).iter();
        let rows = rows.zip(A::entries_of::<A>(&self.derivatives[FORCE_BY_V]));
        for (f, (by_q, by_v)) in force.as_mut_slice().iter_mut().zip(rows) {
            *f += dot(by_q, dq) + dot(by_v, dv);
        }
        force
    }
}

/// What was evaluated last, at which velocities.
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

    /// The accuracy of a velocity that can be seen in the position which h times it is added to.
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

    /// What the momentum of each stage is too large by, and its derivative, a row over |Mᵢᵢ|: then it has the unit of the velocity.
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
            let Values { momentum, force, derivatives } = &mut watch.seen.stages[i];
            from.system.stage(kernel, t, &z[0], &v[i], [momentum, force], derivatives);
        }
        let stages = &watch.seen.stages;
        let rows = <[Y::Array; S]>::entries::<[Y::Array; S]>(matrix);
        let mut residuals = [Y::Array::zero(); S];
        for (i, residual) in residuals.iter_mut().enumerate() {
            *residual = difference(&stages[i].momentum, &from.z[1]);
            for j in 0..S {
                residual.add_scaled(-coupling[i][j], &stages[j].force);
            }
            for (r, residual) in residual.as_mut_slice().iter_mut().enumerate() {
                let entry =
                    |stage: &Values<Y::Array>, of: usize| Y::Array::entries_of::<Y::Array>(&stage.derivatives[of])[r];
                let mass = entry(&stages[i], MASS);
                let mut scale = R::from_f64(1.0) / row_scale(&mass, r);
                // As many mass matrices as stages: with an even number of them the determinant is positive.
                if S % 2 == 1 && i == 0 && r == 0 {
                    scale *= start.sign;
                }
                for k in 0..S {
                    let mut row = if i == k { mass } else { Y::Array::zero() };
                    let turning = difference(&entry(&stages[i], MOMENTUM_BY_Q), &entry(&stages[k], FORCE_BY_V));
                    row.add_scaled(coupling[i][k], &turning);
                    for j in 0..S {
                        row.add_scaled(-(coupling[i][j] * coupling[j][k]), &entry(&stages[j], FORCE_BY_Q));
                    }
                    rows[i * Y::Array::LEN + r][k] = scaled(scale, &row);
                }
                *residual *= scale;
            }
        }
        residuals
    }

    #[inline(always)]
    fn stage(equation: &Equation<'_, Self, Y, R>, i: usize, v: &[Y::Array; S]) -> Stage<Y, R> {
        Stage { t: equation.from.t + equation.constants.scaled.nodes[i], z: equation.point(i, v), s: () }
    }

    /// By the forces where they were evaluated last, and what the last correction changes them by: its square is rounding.
    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, Y, R>,
        Solution { x: v, .. }: &Solution<[Y::Array; S]>,
        seen: &Self::Seen,
    ) -> Result<Increment<Y::Phase, ()>, Refusal> {
        let Scaled { coupling, weights, .. } = &equation.constants.scaled;
        let none = Y::Array::zero();
        let corrections: [Y::Array; S] = core::array::from_fn(|i| difference(&v[i], &seen.v[i]));
        let (mut change, mut impulse) = (none, none);
        for i in 0..S {
            change.add_scaled(weights[i], &v[i]);
            let mut moved = none;
            for (a, correction) in coupling[i].iter().zip(&corrections) {
                moved.add_scaled(*a, correction);
            }
            impulse.add_scaled(weights[i], &seen.stages[i].force_after(&moved, &corrections[i]));
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

/// The places of derivatives.
const MOMENTUM_BY_Q: usize = 0;
const MASS: usize = 1;
const FORCE_BY_Q: usize = 2;
const FORCE_BY_V: usize = 3;
