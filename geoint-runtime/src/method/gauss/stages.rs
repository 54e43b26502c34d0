//! The equation of the stages.

use super::prepared::{Prepared, PreparedFields};
use crate::method::Probe;
use crate::scalar::Real;
use crate::solving::equation::{Effort, StepEquation};
use crate::space::vector::{difference, scaled, sum};
use crate::space::{Array, Square};
use crate::system::Collocation;

/// kᵢ = f(Yᵢ) for the derivatives at all stages.
pub(super) struct Stages<'a, Y: Collocation<R>, R: Real, const S: usize> {
    pub(super) system: &'a Y,
    pub(super) prepared: &'a PreparedFields<Y::Constants, R, S>,
    pub(super) t: R,
    pub(super) z: Y::Phase,
    pub(super) y0: Y::Unknown,
    /// What h·k is added to.
    pub(super) changed: Y::Unknown,
    pub(super) velocity: Y::Unknown,
}

impl<Y: Collocation<R>, R: Real, const S: usize> Clone for Stages<'_, Y, R, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Y: Collocation<R>, R: Real, const S: usize> Copy for Stages<'_, Y, R, S> {}

impl<'a, Y: Collocation<R>, R: Real, const S: usize> Stages<'a, Y, R, S> {
    #[inline(always)]
    pub(super) fn new(system: &'a Y, prepared: &'a PreparedFields<Y::Constants, R, S>, t: R, z: Y::Phase) -> Self {
        let (y0, changed) = Y::start(&z);
        let velocity = system.velocity(&prepared.stages.constants, &changed);
        Stages { system, prepared, t, z, y0, changed, velocity }
    }

    /// f and f' where the polynomial of the step is after the time `x`, with these coefficients of k over h, or h² if f is y''.
    #[inline(always)]
    pub(super) fn at<P: Probe<Y, R>>(
        &self,
        probe: &mut P,
        x: R,
        k: &[Y::Unknown; S],
        coefficients: &[f64; S],
    ) -> (Y::Unknown, Square<Y::Unknown>) {
        let Prepared { constants, h, .. } = &self.prepared.stages;
        let power = if Y::DERIVATIVE == 1 { *h } else { *h * *h };
        let mut change = scaled(x, &self.velocity);
        for (coefficient, k) in coefficients.iter().zip(k) {
            self.system.add(constants, R::from_f64(*coefficient) * power, k, &mut change);
        }
        let (mut f, mut slope) = (Y::Unknown::zero(), Y::Unknown::fill(Y::Unknown::zero()));
        probe.visit(self.t + x, &self.point(&change), &());
        self.system.field(constants, self.t + x, &sum(&self.y0, &change), &mut f, &mut slope);
        (f, slope)
    }

    /// Yᵢ − y₀.
    #[inline(always)]
    pub(super) fn change(&self, i: usize, k: &[Y::Unknown; S]) -> Y::Unknown {
        let PreparedFields { stages: Prepared { constants, nodes, .. }, coupling, .. } = self.prepared;
        let mut change = scaled(nodes[i], &self.velocity);
        for j in 0..S {
            self.system.add(constants, coupling[i][j], &k[j], &mut change);
        }
        change
    }

    /// Where a stage with this change is, with the momenta before the step if they are not solved for.
    #[inline(always)]
    pub(super) fn point(&self, change: &Y::Unknown) -> Y::Phase {
        sum(&self.z, &Y::increments(change, &Y::Unknown::zero()))
    }

    /// f(Yᵢ) and f'(Yᵢ).
    #[inline(always)]
    fn stage<P: Probe<Y, R>>(
        &self,
        probe: &mut P,
        i: usize,
        k: &[Y::Unknown; S],
        slope: &mut Square<Y::Unknown>,
    ) -> Y::Unknown {
        let Prepared { constants, nodes, .. } = &self.prepared.stages;
        let (t, change, mut f) = (self.t + nodes[i], self.change(i, k), Y::Unknown::zero());
        probe.visit(t, &self.point(&change), &());
        self.system.field(constants, t, &sum(&self.y0, &change), &mut f, slope);
        f
    }
}

impl<Y: Collocation<R>, R: Real, P: Probe<Y, R>, const S: usize> StepEquation<[Y::Unknown; S], P>
    for Stages<'_, Y, R, S>
{
    const EFFORT: Effort = P::EFFORT;

    /// −2p/h turns p round in the middle of the step.
    fn standstill(&self) -> f64 {
        if Y::DERIVATIVE == 1 { 0.0 } else { -2.0 }
    }

    /// The accuracy of kᵢ that can be seen in what h·kᵢ is added to.
    #[inline(always)]
    fn origin(&self) -> [Y::Unknown; S] {
        [scaled(R::from_f64(1.0) / self.prepared.stages.h, &self.changed); S]
    }

    /// The stages as if y' were constant.
    fn guess(&self) -> [Y::Unknown; S] {
        let Prepared { constants, nodes, .. } = &self.prepared.stages;
        let mut slope = Y::Unknown::fill(Y::Unknown::zero());
        let mut rate = self.velocity;
        if Y::DERIVATIVE == 1 {
            self.system.field(constants, self.t, &self.y0, &mut rate, &mut slope);
        }
        nodes.map(|node| {
            let (mut y, mut f) = (self.y0, Y::Unknown::zero());
            y.add_scaled(node, &rate);
            self.system.field(constants, self.t + node, &y, &mut f, &mut slope);
            f
        })
    }

    #[inline(always)]
    fn image(&self, probe: &mut P, k: &[Y::Unknown; S]) -> [Y::Unknown; S] {
        core::array::from_fn(|i| self.stage(probe, i, k, &mut Y::Unknown::fill(Y::Unknown::zero())))
    }

    #[inline(always)]
    fn residual(&self, probe: &mut P, k: &[Y::Unknown; S], matrix: &mut Square<[Y::Unknown; S]>) -> [Y::Unknown; S] {
        let PreparedFields { stages: Prepared { constants, .. }, coupling, .. } = self.prepared;
        let rows = <[Y::Unknown; S]>::entries::<[Y::Unknown; S]>(matrix);
        let mut all = [Y::Unknown::zero(); S];
        // Not by `from_fn`, whose closure would be a function of its own, and its result read in other pieces than it was written in.
        for (i, f) in all.iter_mut().enumerate() {
            // f'(Yᵢ)·∂Yᵢ/∂kⱼ.
            let mut slope = Y::Unknown::fill(Y::Unknown::zero());
            *f = self.stage(probe, i, k, &mut slope);
            for (r, slope_row) in Y::Unknown::entries::<Y::Unknown>(&mut slope).iter().enumerate() {
                let row = &mut rows[i * Y::Unknown::LEN + r];
                for j in 0..S {
                    row[j] = Y::Unknown::zero();
                    self.system.add(constants, -coupling[i][j], slope_row, &mut row[j]);
                }
                row[i].as_mut_slice()[r] += R::from_f64(1.0);
            }
        }
        difference(k, &all)
    }
}
