//! Stages of a differential equation y' = f(y, t), or q'' = M⁻¹f(q, t): solved for the values of f.

use super::stages::Stages;
use super::{Gauss, GaussTableau};
use crate::method::{Probe, Refusal, Step, StepsOf, check_end, start};
use crate::scalar::Real;
use crate::solving::newton::{Found, Newton};
use crate::space::{Array, Snapshot, Summation};
use crate::system::{ByField, Collocation, Poles};

/// Coefficients of one step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R, const S: usize> {
    pub(super) poles: Poles,
    pub(super) constants: P,
    pub(super) h: R,
    /// What stage j adds to stage i: h·A, or h²·A².
    pub(super) coupling: [[R; S]; S],
    /// h·c.
    pub(super) nodes: [R; S],
    /// h·b.
    pub(super) weights: [R; S],
    /// What a stage adds to the end: h·b, or h²·b(1 − c).
    pub(super) increments: [R; S],
}

impl<Y: Collocation<R>, R: Real, const S: usize> StepsOf<Gauss<S>, Y, R> for ByField
where
    Gauss<S>: GaussTableau<S>,
{
    type Prepared = Prepared<Y::Constants, R, S>;
    type Memory = Newton<[Y::Unknown; S]>;

    fn prepare(system: &Y, h: R) -> Self::Prepared {
        let tableau = Gauss::<S>::TABLEAU;
        let first_order = Y::DERIVATIVE == 1;
        let coupling = |i: usize, j: usize| {
            let square = (0..S).map(|k| tableau.a[i][k] * tableau.a[k][j]).sum();
            if first_order { R::from_f64(tableau.a[i][j]) * h } else { R::from_f64(square) * h * h }
        };
        let increment = |i: usize| {
            let (b, c) = (tableau.b[i], tableau.c[i]);
            if first_order { R::from_f64(b) * h } else { R::from_f64(b * (1.0 - c)) * h * h }
        };
        Prepared {
            poles: Poles::of(system),
            constants: system.constants(),
            h,
            coupling: core::array::from_fn(|i| core::array::from_fn(|j| coupling(i, j))),
            nodes: tableau.c.map(|c| R::from_f64(c) * h),
            weights: tableau.b.map(|b| R::from_f64(b) * h),
            increments: core::array::from_fn(increment),
        }
    }

    fn memory() -> Self::Memory {
        Newton::new(Y::State::ALIKE, Y::Unknown::LEN / Y::State::ALIKE)
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        newton: &mut Self::Memory,
        Step { system, t, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let zero = Y::Unknown::zero();
        let (y0, changed) = Y::start(&x.z);
        let velocity = system.velocity(&prepared.constants, &changed);
        probe.visit(t, &x.z, &());
        let Found { x: k, outcome, .. } =
            newton.solve(&Stages { system, prepared, t, z: x.z, y0, changed, velocity }, probe);
        outcome?;

        let Prepared { poles, constants, h, weights, increments, .. } = prepared;
        let (mut change, mut impulse) = (zero, zero);
        change.add_scaled(*h, &velocity);
        for i in 0..S {
            system.add(constants, increments[i], &k[i], &mut change);
            impulse.add_scaled(weights[i], &k[i]);
        }
        let before = start::<Y, R, C>(x);
        x.add(&Y::increments(&change, &impulse));
        check_end(poles, [t, t + *h], &before, Step { system, t, x, probe })
    }
}
