//! The equations of all stages for their velocities, and what a solution of them adds.

use super::varying;
use crate::method::Probe;
use crate::method::contact::gauss::factors::Factors;
use crate::method::gauss::prepared::Prepared;
use crate::scalar::{Real, zero};
use crate::solving::Observer;
use crate::solving::equation::{Effort, StepEquation};
use crate::space::vector::{difference, dot, moved, scaled, sum, sum_of_products};
use crate::space::{Array, PerCoordinate, Square};
use crate::system::{ContactStage, ContactVelocities, row_scale, velocity_near};

/// The equations of all stages for their velocities, and for the increments of s if they read it.
pub(super) struct StageVelocities<'a, Y: ContactVelocities<R>, R: Real, const S: usize> {
    pub(super) system: &'a Y,
    pub(super) prepared: &'a Prepared<Y::StageConstants, R, S>,
    pub(super) t: R,
    pub(super) z: Y::Phase,
    pub(super) s: R,
    /// Of the determinant of the mass matrix.
    pub(super) sign: R,
    /// The factors, where they do not depend on what is solved for.
    pub(super) known: Option<Factors<R, S>>,
}

impl<Y: ContactVelocities<R>, R: Real, const S: usize> Clone for StageVelocities<'_, Y, R, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Y: ContactVelocities<R>, R: Real, const S: usize> Copy for StageVelocities<'_, Y, R, S> {}

impl<Y: ContactVelocities<R>, R: Real, const S: usize> StageVelocities<'_, Y, R, S> {
    /// The velocity of a stage, and the increment of s.
    #[inline(always)]
    pub(super) fn apart(&self, d: &Y::Moved) -> (Y::Array, R) {
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
        for (a, d) in self.prepared.coupling[i].iter().zip(d) {
            change.add_scaled(*a, &self.apart(d).0);
        }
        change
    }

    /// Where a stage is: positions and s, with the momenta before the step.
    #[inline(always)]
    pub(super) fn stage(&self, i: usize, d: &[Y::Moved; S]) -> (Y::Phase, R) {
        ([sum(&self.z[0], &self.shift(i, d)), self.z[1]], self.s + self.apart(&d[i]).1)
    }

    /// What the step adds, from stages at `last` and what the last correction changes them by: its square is rounding. `None` where the form
    /// would not be multiplied by a positive number.
    #[inline(always)]
    pub(super) fn end(
        &self,
        d: &[Y::Moved; S],
        last: &Last<Y::Moved, Y::Array, S>,
    ) -> Option<PerCoordinate<Y::Phase, R>> {
        let Prepared { coupling, weights, .. } = self.prepared;
        let mut corrections = [Y::Moved::zero(); S];
        for i in 0..S {
            corrections[i] = difference(&d[i], &last.d[i]);
        }
        let (mut forces, mut decay, mut rates) = ([Y::Array::zero(); S], [zero(); S], [zero(); S]);
        for i in 0..S {
            let moved = (self.shift(i, &corrections), self.apart(&corrections[i]));
            (forces[i], decay[i], rates[i]) = after::<Y, R>(&last.stages[i], &moved.0, moved.1);
        }
        let factors = self.known.unwrap_or_else(|| last.factors.after(&decay));
        let grown = factors.growth(weights)?;
        let (mut change, mut impulse) = (Y::Array::zero(), scaled(-grown, &self.z[1]));
        for i in 0..S {
            change.add_scaled(weights[i], &self.apart(&d[i]).0);
            impulse.add_scaled(weights[i] * factors.r[i], &forces[i]);
        }
        let impulse = scaled(R::from_f64(1.0) / (R::from_f64(1.0) + grown), &impulse);
        if !varying::<Y, R>() {
            rates = factors.rates_of_action(coupling, rates)?;
        }
        Some(PerCoordinate { z: [change, impulse], s: sum_of_products(weights, &rates) })
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

/// What was evaluated last, for which unknowns.
pub(super) struct Last<D, A: Array, const S: usize> {
    d: [D; S],
    stages: [ContactStage<A>; S],
    factors: Factors<A::Real, S>,
}

impl<D: Array<Real = A::Real>, A: Array, const S: usize> Last<D, A, S> {
    pub(super) fn none() -> Self {
        Last { d: [D::zero(); S], stages: [ContactStage::none(); S], factors: Factors::unknown() }
    }
}

/// Who watches, and what was evaluated last.
pub(super) struct Seen<'a, P, D, A: Array, const S: usize> {
    pub(super) probe: &'a mut P,
    pub(super) last: Last<D, A, S>,
}

impl<P: Observer, D, A: Array, const S: usize> Observer for Seen<'_, P, D, A, S> {
    fn pause(&mut self, paused: bool) {
        self.probe.pause(paused);
    }
}

impl<Y: ContactVelocities<R>, R: Real, P: Probe<Y, R>, const S: usize>
    StepEquation<[Y::Moved; S], Seen<'_, P, Y::Moved, Y::Array, S>> for StageVelocities<'_, Y, R, S>
{
    const EFFORT: Effort = P::EFFORT;

    /// The accuracy of a velocity that can be seen in the position which h times it is added to.
    #[inline(always)]
    fn origin(&self) -> [Y::Moved; S] {
        [self.together(&scaled(R::from_f64(1.0) / self.prepared.h, &self.z[0]), self.s); S]
    }

    /// The velocities as if v' and s' were constant.
    fn guess(&self) -> [Y::Moved; S] {
        let StageVelocities { system, prepared, t, z, s, .. } = self;
        let v = velocity_near(*system, *t, z, s, Y::Array::zero()).unwrap_or_else(Y::Array::zero);
        let mut at = ContactStage::none();
        system.stage(&prepared.constants, *t, &z[0], &v, s, &mut at);
        let rate = at.acceleration(&v);
        prepared.nodes.map(|node| self.together(&moved(&v, node, &rate), node * at.lagrangian))
    }

    /// What the momentum of each stage is too large by, a row over |Mᵢᵢ|, and the increment of s.
    #[inline(always)]
    fn residual(
        &self,
        Seen { probe, last }: &mut Seen<'_, P, Y::Moved, Y::Array, S>,
        d: &[Y::Moved; S],
        matrix: &mut Square<[Y::Moved; S]>,
    ) -> [Y::Moved; S] {
        let Prepared { coupling, constants, nodes, .. } = self.prepared;
        let (n, length, one) = (Y::Array::LEN, Y::Moved::LEN, R::from_f64(1.0));
        last.d = *d;
        for (i, stage) in last.stages.iter_mut().enumerate() {
            let (t, (z, s)) = (self.t + nodes[i], self.stage(i, d));
            probe.visit(t, &z, &s);
            self.system.stage(constants, t, &z[0], &self.apart(&d[i]).0, &s, stage);
        }
        last.factors = match self.known {
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
                    scale *= self.sign;
                }
                let p = stages[i].momentum.as_slice()[row];
                let mut value = (r[i] - one).multiply_add(p, p - self.z[1].as_slice()[row]);
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
                    rows[i * length + row][k] = self.together(&scaled(scale, &by_v), scale * by_s);
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
                    rows[i * length + row][k] = self.together(&by_v, by_s);
                }
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
