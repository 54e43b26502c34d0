//! The step of a Lagrangian with an action that is solved for velocities: with qᵢ = q₀ + h Σ aᵢⱼ vⱼ,
//!
//! rᵢ ∂L/∂v(qᵢ, vᵢ, sᵢ) = p₀ + h Σ aᵢⱼ rⱼ fⱼ, sᵢ = s₀ + h Σ aᵢⱼ Lⱼ, rᵢ = 1 + h Σ aᵢⱼ rⱼ σⱼ with f = ∂L/∂q and σ = −∂L/∂s.

use super::factors::Factors;
use crate::method::gauss::prepared::Scaled;
use crate::method::gauss::velocities::Constants;
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::implicit::{Arrival, Departure, Equation, ImplicitStep, Increment, Policy, Stage, Units, Watch};
use crate::method::{Probe, Refusal};
use crate::scalar::{Real, zero};
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, dot, moved, scaled, sum, sum_of_products};
use crate::space::{Array, Square};
use crate::system::{ContactStage, ContactVelocities, Regular, row_scale, velocity_near};

/// The step that is solved for velocities of its stages, and for the increments of s if they read it.
#[derive(Clone, Copy, Debug)]
pub struct ContactVelocityStages<const S: usize>;

/// What depends on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<R, const S: usize> {
    /// The sign of the determinant of the mass matrix.
    sign: R,
    /// The factors, where they do not depend on what is solved for.
    known: Option<Factors<R, S>>,
}

/// What was evaluated last, for which unknowns.
#[derive(Clone, Copy, Debug)]
pub struct Last<D, A: Array, const S: usize> {
    d: [D; S],
    stages: [ContactStage<A>; S],
    factors: Factors<A::Real, S>,
}

impl<D: Array<Real = A::Real>, A: Array, const S: usize> Last<D, A, S> {
    fn none() -> Self {
        Last { d: [D::zero(); S], stages: [ContactStage::none(); S], factors: Factors::unknown() }
    }
}

/// Whether the factors, and s, depend on what is solved for: where L = L₀(q, v, t) − g(t)·s they do not.
const fn varying<Y: ContactVelocities<R>, R: Real>() -> bool {
    Y::Moved::LEN > Y::Array::LEN
}

impl<Y: ContactVelocities<R>, R: Real, const S: usize> Equation<'_, ContactVelocityStages<S>, Y, R>
where
    Gauss<S>: GaussTableau<S>,
{
    /// The velocity of a stage, and the increment of s.
    #[inline(always)]
    fn apart(&self, d: &Y::Moved) -> (Y::Array, R) {
        let mut v = Y::Array::zero();
        for (v, d) in v.as_mut_slice().iter_mut().zip(d.as_slice()) {
            *v = *d;
        }
        (v, d.as_slice().get(Y::Array::LEN).copied().unwrap_or_else(zero))
    }

    /// The same in a row, with what belongs to s if that is solved for.
    #[inline(always)]
    fn together(&self, v: &Y::Array, s: R) -> Y::Moved {
        let mut row = Y::Moved::zero();
        for (x, v) in row.as_mut_slice().iter_mut().zip(v.as_slice()) {
            *x = *v;
        }
        if let Some(last) = row.as_mut_slice().get_mut(Y::Array::LEN) {
            *last = s;
        }
        row
    }

    /// What velocities of stages move positions by.
    #[inline(always)]
    fn shift(&self, i: usize, d: &[Y::Moved; S]) -> Y::Array {
        let mut change = Y::Array::zero();
        for (a, d) in self.constants.scaled.coupling[i].iter().zip(d) {
            change.add_scaled(*a, &self.apart(d).0);
        }
        change
    }

    /// Where a stage is: positions and s, with the momenta before the step.
    #[inline(always)]
    fn place(&self, i: usize, d: &[Y::Moved; S]) -> (Y::Phase, R) {
        ([sum(&self.from.z[0], &self.shift(i, d)), self.from.z[1]], self.from.s + self.apart(&d[i]).1)
    }

    /// What the step adds, from stages at `last` and what the last correction changes them by: its square is rounding. `None` where the form
    /// would not be multiplied by a positive number.
    #[inline(always)]
    fn end(&self, d: &[Y::Moved; S], last: &Last<Y::Moved, Y::Array, S>) -> Option<Increment<Y::Phase, R>> {
        let Scaled { coupling, weights, .. } = &self.constants.scaled;
        let mut corrections = [Y::Moved::zero(); S];
        for i in 0..S {
            corrections[i] = difference(&d[i], &last.d[i]);
        }
        let (mut forces, mut decay, mut rates) = ([Y::Array::zero(); S], [zero(); S], [zero(); S]);
        for i in 0..S {
            let moved = (self.shift(i, &corrections), self.apart(&corrections[i]));
            (forces[i], decay[i], rates[i]) = after::<Y, R>(&last.stages[i], &moved.0, moved.1);
        }
        let factors = self.start.known.unwrap_or_else(|| last.factors.after(&decay));
        let grown = factors.growth(weights)?;
        let (mut change, mut impulse) = (Y::Array::zero(), scaled(-grown, &self.from.z[1]));
        for i in 0..S {
            change.add_scaled(weights[i], &self.apart(&d[i]).0);
            impulse.add_scaled(weights[i] * factors.r[i], &forces[i]);
        }
        let impulse = scaled(R::from_f64(1.0) / (R::from_f64(1.0) + grown), &impulse);
        if !varying::<Y, R>() {
            rates = factors.rates_of_action(coupling, rates)?;
        }
        Some(Increment { z: [change, impulse], s: sum_of_products(weights, &rates), lost: Y::Phase::zero() })
    }
}

impl<Y: ContactVelocities<R>, R: Real, const S: usize> ImplicitStep<Y, R> for ContactVelocityStages<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Unknown = [Y::Moved; S];
    type Constants = Constants<Y::StageConstants, R, S>;
    type Start = Start<R, S>;
    type History = Regular<Y::Array>;
    type Seen = Last<Y::Moved, Y::Array, S>;
    type Kept = ();
    type Solver = Newton<[Y::Moved; S]>;

    const POLICY: Policy = Policy {
        // Each unknown of a stage is of a kind of its own.
        ..Policy::of(Units { alike: 1, kinds: Y::Moved::LEN })
    };
    const STAGES: usize = if varying::<Y, R>() { S } else { 0 };

    fn constants(self, system: &Y, h: R) -> Self::Constants {
        Constants { kernel: system.stage_constants(), scaled: Scaled::by(h), is_definite: system.is_definite() }
    }

    fn history() -> Self::History {
        Regular::unknown()
    }

    fn unseen() -> Self::Seen {
        Last::none()
    }

    #[inline(always)]
    fn begin(
        from: &Departure<'_, Y, R>,
        Constants { kernel, scaled: Scaled { coupling, nodes, .. }, is_definite }: &Self::Constants,
        regular: &mut Self::History,
    ) -> Result<Self::Start, Refusal> {
        let Departure { system, t, z, s, .. } = from;
        let sign = regular.begin(*system, *is_definite, (*t, z, s))?;
        let known = if varying::<Y, R>() {
            None
        } else {
            let none = Y::Array::zero();
            let decay = nodes.map(|node| ContactVelocities::force(*system, kernel, *t + node, &none, &none, s).1);
            Some(Factors::new::<false>(coupling, &decay).ok_or(Refusal::Singular)?)
        };
        Ok(Start { sign, known })
    }

    /// The accuracy of a velocity that can be seen in the position which h times it is added to.
    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, Y, R>) -> [Y::Moved; S] {
        let Departure { h, z, s, .. } = &equation.from;
        [equation.together(&scaled(R::from_f64(1.0) / *h, &z[0]), *s); S]
    }

    /// The velocities as if v' and s' were constant.
    fn guess(equation: &Equation<'_, Self, Y, R>) -> [Y::Moved; S] {
        let Equation { from: Departure { system, t, z, s, .. }, constants, .. } = equation;
        let v = velocity_near(*system, *t, z, s, Y::Array::zero()).unwrap_or_else(Y::Array::zero);
        let mut at = ContactStage::none();
        system.stage(&constants.kernel, *t, &z[0], &v, s, &mut at);
        let rate = at.acceleration(&v);
        constants.scaled.nodes.map(|node| equation.together(&moved(&v, node, &rate), node * at.lagrangian))
    }

    /// What the momentum of each stage is too large by, a row over |Mᵢᵢ|, and the increment of s.
    #[inline(always)]
    fn residual<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        watch: &mut Watch<'_, Y, R, P, Self::Seen>,
        d: &[Y::Moved; S],
        matrix: &mut Square<[Y::Moved; S]>,
    ) -> [Y::Moved; S] {
        let Equation { from, constants: Constants { kernel, scaled: Scaled { coupling, nodes, .. }, .. }, start } =
            equation;
        let (n, length, one) = (Y::Array::LEN, Y::Moved::LEN, R::from_f64(1.0));
        watch.seen.d = *d;
        for i in 0..S {
            let (t, (z, s)) = (from.t + nodes[i], equation.place(i, d));
            watch.visit(t, &z, &s);
            from.system.stage(kernel, t, &z[0], &equation.apart(&d[i]).0, &s, &mut watch.seen.stages[i]);
        }
        let last = &mut watch.seen;
        last.factors = match start.known {
            Some(known) => known,
            None => {
                let decay = core::array::from_fn(|i| last.stages[i].decay);
                Factors::new::<true>(coupling, &decay).unwrap_or_else(Factors::unknown)
            }
        };
        let (stages, Factors { r, by_decay, .. }) = (&last.stages, &last.factors);
        // What L has no second derivatives by is not multiplied.
        let [by_q_and_v, by_v_and_s, by_q_and_s] = Y::MIXED;
        // −∂σ/∂v: how the velocities of stages move the decay at each.
        let moves_decay = varying::<Y, R>() && (by_v_and_s || by_q_and_s);
        let mut decays = [[Y::Array::zero(); S]; S];
        for m in 0..if moves_decay { S } else { 0 } {
            for k in 0..S {
                if by_q_and_s {
                    decays[m][k] = scaled(coupling[m][k], &stages[m].by_action[1]);
                }
                if m == k && by_v_and_s {
                    decays[m][k].add_scaled(one, &stages[m].by_action[0]);
                }
            }
        }
        let rows = <[Y::Moved; S]>::entries::<[Y::Moved; S]>(matrix);
        let mut residuals = [Y::Moved::zero(); S];
        for (i, residual) in residuals.iter_mut().enumerate() {
            for row in 0..n {
                let entry = |stage: &ContactStage<Y::Array>, of: usize| {
                    Y::Array::entries_of::<Y::Array>(&stage.derivatives[of])[row]
                };
                let mass = entry(&stages[i], MASS);
                let mut scale = one / row_scale(&mass, row);
                // As many mass matrices as stages: with an even number of them the determinant is positive.
                if S % 2 == 1 && i == 0 && row == 0 {
                    scale *= start.sign;
                }
                let p = stages[i].momentum.as_slice()[row];
                let mut value = (r[i] - one).multiply_add(p, p - from.z[1].as_slice()[row]);
                for j in 0..S {
                    value = (-(coupling[i][j] * r[j])).multiply_add(stages[j].force.as_slice()[row], value);
                }
                residual.as_mut_slice()[row] = scale * value;
                let by_decay_of: [R; S] = core::array::from_fn(|m| {
                    let mut by = p * by_decay[i][m];
                    for j in 0..S {
                        let f = stages[j].force.as_slice()[row];
                        by = (-(coupling[i][j] * by_decay[j][m])).multiply_add(f, by);
                    }
                    by
                });
                for k in 0..S {
                    let mut by_v = if i == k { scaled(r[i], &mass) } else { Y::Array::zero() };
                    if by_q_and_v {
                        by_v.add_scaled(coupling[i][k] * r[i], &entry(&stages[i], MOMENTUM_BY_Q));
                        by_v.add_scaled(-(coupling[i][k] * r[k]), &entry(&stages[k], FORCE_BY_V));
                    }
                    for j in 0..S {
                        by_v.add_scaled(-(coupling[i][j] * r[j] * coupling[j][k]), &entry(&stages[j], FORCE_BY_Q));
                    }
                    let mut by_s = zero();
                    if varying::<Y, R>() {
                        if by_q_and_s {
                            by_s = -(coupling[i][k] * r[k] * stages[k].by_action[1].as_slice()[row]);
                        }
                        if i == k && by_v_and_s {
                            by_s = r[i].multiply_add(stages[i].by_action[0].as_slice()[row], by_s);
                        }
                        // What σ of all stages does by all factors.
                        for m in 0..if moves_decay { S } else { 0 } {
                            by_v.add_scaled(-by_decay_of[m], &decays[m][k]);
                        }
                        by_s = by_decay_of[k].multiply_add(stages[k].decay_by_action, by_s);
                    }
                    rows[i * length + row][k] = equation.together(&scaled(scale, &by_v), scale * by_s);
                }
            }
            // s₀ + h Σ aᵢⱼ Lⱼ, if it is solved for.
            for row in n..length {
                let mut value = d[i].as_slice()[row];
                for j in 0..S {
                    value = (-coupling[i][j]).multiply_add(stages[j].lagrangian, value);
                }
                residual.as_mut_slice()[row] = value;
                for k in 0..S {
                    let mut by_v = scaled(-coupling[i][k], &stages[k].momentum);
                    for j in 0..S {
                        by_v.add_scaled(-(coupling[i][j] * coupling[j][k]), &stages[j].force);
                    }
                    let own = if i == k { one } else { zero() };
                    let by_s = coupling[i][k].multiply_add(stages[k].decay, own);
                    rows[i * length + row][k] = equation.together(&by_v, by_s);
                }
            }
        }
        residuals
    }
    #[inline(always)]
    fn stage(equation: &Equation<'_, Self, Y, R>, i: usize, d: &[Y::Moved; S]) -> Stage<Y, R> {
        let (z, s) = equation.place(i, d);
        Stage { t: equation.from.t + equation.constants.scaled.nodes[i], z, s }
    }

    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, Y, R>,
        solution: &Solution<[Y::Moved; S]>,
        last: &Self::Seen,
    ) -> Result<Increment<Y::Phase, R>, Refusal> {
        equation.end(&solution.x, last).ok_or(Refusal::Singular)
    }

    #[inline(always)]
    fn finish<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        solution: &Solution<[Y::Moved; S]>,
        regular: &mut Self::History,
        Arrival { z, s, .. }: Arrival<'_, Y, R>,
    ) -> Result<(), Refusal> {
        let Equation { from, constants, .. } = equation;
        let ends = [(from.t, &from.z, &from.s), (from.end, z, s)];
        regular.follow(from.system, constants.is_definite, ends, equation.apart(&solution.x[S - 1]).0)
    }
}

/// f, σ and L after small changes of q, v and s.
#[inline(always)]
fn after<Y: ContactVelocities<R>, R: Real>(
    stage: &ContactStage<Y::Array>,
    dq: &Y::Array,
    (dv, ds): (Y::Array, R),
) -> (Y::Array, R, R) {
    let [by_q_and_v, by_v_and_s, by_q_and_s] = Y::MIXED;
    let [.., by_q, by_v] = &stage.derivatives;
    let [momentum_by_s, force_by_s] = &stage.by_action;
    let mut force = if by_q_and_s { moved(&stage.force, ds, force_by_s) } else { stage.force };
    let rows = Y::Array::entries_of::<Y::Array>(by_q).iter().zip(Y::Array::entries_of::<Y::Array>(by_v));
    for (f, (by_q, by_v)) in force.as_mut_slice().iter_mut().zip(rows) {
        *f += dot(by_q, dq);
        if by_q_and_v {
            *f += dot(by_v, &dv);
        }
    }
    let mut decay = stage.decay_by_action.multiply_add(ds, stage.decay);
    if by_v_and_s {
        decay -= dot(momentum_by_s, &dv);
    }
    if by_q_and_s {
        decay -= dot(force_by_s, dq);
    }
    let lagrangian = stage.lagrangian + dot(&stage.momentum, &dv) + dot(&stage.force, dq) - stage.decay * ds;
    (force, decay, lagrangian)
}

/// The places of derivatives.
const MOMENTUM_BY_Q: usize = 0;
const MASS: usize = 1;
const FORCE_BY_Q: usize = 2;
const FORCE_BY_V: usize = 3;
