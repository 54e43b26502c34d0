//! Stages of a differential equation y' = f(y, t), or q'' = M⁻¹f(q, t): solved for the values of f.

use super::{Gauss, GaussTableau, Stages};
use crate::method::{Probe, Refusal, Step, check_end, start};
use crate::scalar::Real;
use crate::solving::newton::Newton;
use crate::space::vector::sum;
use crate::space::{Array, Snapshot, Square, Summation};
use crate::system::{ByField, Collocation, Poles};

/// Coefficients of one step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R, const S: usize> {
    poles: Poles,
    constants: P,
    h: R,
    /// What stage j adds to stage i: h·A, or h²·A².
    coupling: [[R; S]; S],
    /// h·c.
    nodes: [R; S],
    /// h·b.
    weights: [R; S],
    /// What a stage adds to the end: h·b, or h²·b(1 − c).
    increments: [R; S],
}

impl<Y: Collocation<R>, R: Real> Stages<Y, R> for ByField {
    type Prepared<const S: usize> = Prepared<Y::Constants, R, S>;
    type Memory<const S: usize> = Newton<[Y::Unknown; S]>;

    fn prepare<const S: usize>(system: &Y, h: R) -> Self::Prepared<S>
    where
        Gauss<S>: GaussTableau<S>,
    {
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

    fn memory<const S: usize>() -> Self::Memory<S> {
        Newton::new(Y::State::ALIKE, Y::Unknown::LEN / Y::State::ALIKE)
    }

    #[inline(always)]
    fn step<const S: usize, C: Summation<Y::Phase>, P: Probe<Y, R>>(
        Prepared { poles, constants, h, coupling, nodes, weights, increments }: &Self::Prepared<S>,
        newton: &mut Self::Memory<S>,
        Step { system, t, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let zero = Y::Unknown::zero();
        let (y0, changed) = Y::start(&x.z);
        let velocity = system.velocity(constants, &changed);
        probe.visit(t, &x.z, &());

        // The stages as if y' were constant.
        let nodes = *nodes;
        let explicit = move || {
            let (mut rate, mut slope) = (velocity, Y::Unknown::fill(zero));
            if Y::DERIVATIVE == 1 {
                system.field(constants, t, &y0, &mut rate, &mut slope);
            }
            core::array::from_fn(|i| {
                let (mut y, mut f) = (y0, zero);
                y.add_scaled(nodes[i], &rate);
                system.field(constants, t + nodes[i], &y, &mut f, &mut slope);
                f
            })
        };

        // The accuracy of kᵢ that can be seen in what h·kᵢ is added to.
        let mut visible = zero;
        visible.add_scaled(R::from_f64(1.0) / *h, &changed);
        // f(Yᵢ) and f'(Yᵢ) of a stage.
        let point = &*x;
        let stage = |probe: &mut P, i: usize, k: &[Y::Unknown; S], slope: &mut Square<Y::Unknown>| {
            let (mut change, mut f) = (zero, zero);
            change.add_scaled(nodes[i], &velocity);
            for j in 0..S {
                system.add(constants, coupling[i][j], &k[j], &mut change);
            }
            probe.visit(t + nodes[i], &sum(&point.z, &Y::increments(&change, &zero)), &());
            system.field(constants, t + nodes[i], &sum(&y0, &change), &mut f, slope);
            f
        };
        let image = |probe: &mut P, k: &[Y::Unknown; S]| {
            core::array::from_fn(|i| stage(probe, i, k, &mut Y::Unknown::fill(zero)))
        };
        // −2p/h turns p round in the middle of the step.
        let still = P::PATIENT.then_some(if Y::DERIVATIVE == 1 { 0.0 } else { -2.0 });
        let (k, _) = newton.solve((&[visible; S], still), explicit, probe, image, |probe, k, derivative| {
            let rows = <[Y::Unknown; S]>::entries::<[Y::Unknown; S]>(derivative);
            core::array::from_fn(|i| {
                // f'(Yᵢ)·∂Yᵢ/∂kⱼ.
                let mut slope = Y::Unknown::fill(zero);
                let f = stage(probe, i, k, &mut slope);
                for (r, slope_row) in Y::Unknown::entries::<Y::Unknown>(&mut slope).iter().enumerate() {
                    let row = &mut rows[i * Y::Unknown::LEN + r];
                    for j in 0..S {
                        row[j] = zero;
                        system.add(constants, -coupling[i][j], slope_row, &mut row[j]);
                    }
                    row[i].as_mut_slice()[r] += R::from_f64(1.0);
                }
                f
            })
        })?;

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
