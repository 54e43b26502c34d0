//! Stages of a Lagrangian, solved for their velocities: with Qᵢ = q₀ + h Σ aᵢⱼ Vⱼ and pᵢ = p₀ + h Σ aᵢⱼ fⱼ,
//!
//! ∂L/∂v(Qᵢ, Vᵢ) = pᵢ, fⱼ = ∂L/∂q(Qⱼ, Vⱼ) less friction.

use super::prepared::Prepared;
use super::{Gauss, GaussTableau};
use crate::method::{Probe, Refusal, Step, StepsOf, check_end, check_way, start};
use crate::scalar::Real;
use crate::solving::Observer;
use crate::solving::equation::{Effort, Solution, StepEquation};
use crate::solving::newton::Newton;
use crate::space::vector::{difference, dot, moved, scaled, sum};
use crate::space::{Array, Record, Square, Summation, Tape};
use crate::system::{ByVelocities, Regular, VelocityForm, acceleration, row_scale, velocity_near};

/// The coefficients of one step, and what is known of the system.
#[derive(Clone, Copy, Debug)]
pub struct PreparedVelocities<P, R, const S: usize> {
    pub(in crate::method) stages: Prepared<P, R, S>,
    /// The mass matrix is positive definite everywhere.
    pub(in crate::method) is_definite: bool,
}

/// What a step hands on to the next one.
#[derive(Clone, Copy, Debug)]
pub struct Memory<D, A: Array, const S: usize> {
    pub(in crate::method) newton: Newton<[D; S]>,
    pub(in crate::method) regular: Regular<A>,
}

impl<D: Array, A: Array<Real = D::Real>, const S: usize> Record<D::Real> for Memory<D, A, S> {
    fn record(&mut self, tape: &mut impl Tape<D::Real>) {
        self.newton.record(tape);
        self.regular.record(tape);
    }
}

impl<Y: VelocityForm<R>, R: Real, const S: usize> StepsOf<Gauss<S>, Y, R> for ByVelocities
where
    Gauss<S>: GaussTableau<S>,
{
    type Prepared = PreparedVelocities<Y::Constants, R, S>;
    type Memory = Memory<Y::Array, Y::Array, S>;

    fn prepare(system: &Y, h: R) -> Self::Prepared {
        PreparedVelocities {
            stages: Prepared::new(system, VelocityForm::constants(system), h),
            is_definite: system.is_definite(),
        }
    }

    fn memory() -> Self::Memory {
        Memory { newton: Newton::new(Y::Array::LEN, 1), regular: Regular::unknown() }
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        PreparedVelocities { stages: prepared, is_definite }: &Self::Prepared,
        Memory { newton, regular }: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let (none, z) = (Y::Array::zero(), x.z);
        probe.visit(t, &z, &());
        let sign = regular.begin(system, *is_definite, (t, &z, &()))?;
        let equation = StageVelocities { system, prepared, t, z, sign };
        let mut seen = Seen { probe, v: [none; S], stages: [Stage::none(); S] };
        let Solution { x: v, .. } = newton.solve(&equation, &mut seen)?;

        let Prepared { poles, h, coupling, nodes, weights, .. } = prepared;
        for (i, node) in nodes.iter().enumerate() {
            let way = ([t, t + *node], [&z, &[equation.position(i, &v), z[1]]], [&(), &()]);
            check_way::<Y, R, P>(poles, false, system, way, &mut x.doubtful)?;
        }
        // Forces where they were evaluated last, and what the last correction changes them by: its square is rounding.
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
        let Seen { probe, .. } = seen;
        let before = start::<Y, R, C>(x);
        x.add(&[change, impulse]);
        regular.follow(system, *is_definite, [(t, &z, &()), (t + *h, &x.z, &())], v[S - 1])?;
        check_end(poles, &before, Step { system, t, end, x, probe })
    }
}

/// ∂L/∂v(Qᵢ, Vᵢ) = pᵢ for the velocities of all stages.
struct StageVelocities<'a, Y: VelocityForm<R>, R: Real, const S: usize> {
    system: &'a Y,
    prepared: &'a Prepared<<Y as VelocityForm<R>>::Constants, R, S>,
    t: R,
    z: Y::Phase,
    /// Of the determinant of the mass matrix.
    sign: R,
}

impl<Y: VelocityForm<R>, R: Real, const S: usize> Clone for StageVelocities<'_, Y, R, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Y: VelocityForm<R>, R: Real, const S: usize> Copy for StageVelocities<'_, Y, R, S> {}

impl<Y: VelocityForm<R>, R: Real, const S: usize> StageVelocities<'_, Y, R, S> {
    /// Qᵢ.
    #[inline(always)]
    fn position(&self, i: usize, v: &[Y::Array; S]) -> Y::Array {
        let mut change = Y::Array::zero();
        for (a, v) in self.prepared.coupling[i].iter().zip(v) {
            change.add_scaled(*a, v);
        }
        sum(&self.z[0], &change)
    }

    /// Momentum and force of a stage, and the derivatives of both.
    #[inline(always)]
    fn stage<P: Probe<Y, R>>(&self, probe: &mut P, i: usize, v: &[Y::Array; S], stage: &mut Stage<Y::Array>) {
        let t = self.t + self.prepared.nodes[i];
        let q = self.position(i, v);
        probe.visit(t, &[q, self.z[1]], &());
        let values = [&mut stage.momentum, &mut stage.force];
        self.system.stage(&self.prepared.constants, t, &q, &v[i], values, &mut stage.derivatives);
    }
}

/// Values at a stage, and [∂p/∂q, ∂p/∂v, ∂f/∂q, ∂f/∂v].
#[derive(Clone, Copy)]
struct Stage<A: Array> {
    momentum: A,
    force: A,
    derivatives: [Square<A>; 4],
}

impl<A: Array> Stage<A> {
    fn none() -> Self {
        let none = A::zero();
        Stage { momentum: none, force: none, derivatives: [A::fill(none); 4] }
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

/// Who watches, and what was evaluated last, at which velocities.
struct Seen<'a, P, A: Array, const S: usize> {
    probe: &'a mut P,
    v: [A; S],
    stages: [Stage<A>; S],
}

impl<P: Observer, A: Array, const S: usize> Observer for Seen<'_, P, A, S> {
    fn pause(&mut self, paused: bool) {
        self.probe.pause(paused);
    }
}

impl<Y: VelocityForm<R>, R: Real, P: Probe<Y, R>, const S: usize> StepEquation<[Y::Array; S], Seen<'_, P, Y::Array, S>>
    for StageVelocities<'_, Y, R, S>
{
    const EFFORT: Effort = P::EFFORT;

    /// The accuracy of a velocity that can be seen in the position which h times it is added to.
    #[inline(always)]
    fn origin(&self) -> [Y::Array; S] {
        [scaled(R::from_f64(1.0) / self.prepared.h, &self.z[0]); S]
    }

    /// The velocities as if v' were constant.
    fn guess(&self) -> [Y::Array; S] {
        let none = Y::Array::zero();
        let v = velocity_near(self.system, self.t, &self.z, &(), none).unwrap_or(none);
        let rate = acceleration(self.system, self.t, &self.z[0], &v);
        self.prepared.nodes.map(|node| moved(&v, node, &rate))
    }

    /// What the momentum of each stage is too large by, and its derivative, a row over |Mᵢᵢ|: then it has the unit of the velocity.
    #[inline(always)]
    fn residual(
        &self,
        Seen { probe, v: last, stages }: &mut Seen<'_, P, Y::Array, S>,
        v: &[Y::Array; S],
        matrix: &mut Square<[Y::Array; S]>,
    ) -> [Y::Array; S] {
        let coupling = &self.prepared.coupling;
        *last = *v;
        for (i, stage) in stages.iter_mut().enumerate() {
            self.stage(*probe, i, v, stage);
        }
        let rows = <[Y::Array; S]>::entries::<[Y::Array; S]>(matrix);
        let mut residuals = [Y::Array::zero(); S];
        for (i, residual) in residuals.iter_mut().enumerate() {
            *residual = difference(&stages[i].momentum, &self.z[1]);
            for j in 0..S {
                residual.add_scaled(-coupling[i][j], &stages[j].force);
            }
            for (r, residual) in residual.as_mut_slice().iter_mut().enumerate() {
                let entry =
                    |stage: &Stage<Y::Array>, of: usize| Y::Array::entries_of::<Y::Array>(&stage.derivatives[of])[r];
                let mass = entry(&stages[i], MASS);
                let mut scale = R::from_f64(1.0) / row_scale(&mass, r);
                // As many mass matrices as stages: with an even number of them the determinant is positive.
                if S % 2 == 1 && i == 0 && r == 0 {
                    scale *= self.sign;
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
}

/// The places of derivatives.
const MOMENTUM_BY_Q: usize = 0;
const MASS: usize = 1;
const FORCE_BY_Q: usize = 2;
const FORCE_BY_V: usize = 3;
