//! Stages of a Lagrangian, solved for their velocities: with Qᵢ = q₀ + h Σ aᵢⱼ Vⱼ and pᵢ = p₀ + h Σ aᵢⱼ fⱼ,
//!
//! ∂L/∂v(Qᵢ, Vᵢ) = pᵢ, fⱼ = ∂L/∂q(Qⱼ, Vⱼ) less friction.

use super::{Gauss, GaussTableau, Stages};
use crate::method::explicit::tableau::Tableau;
use crate::method::{Probe, Refusal, Step, check_end, start};
use crate::scalar::Real;
use crate::solving::newton::Newton;
use crate::space::vector::sum;
use crate::space::{Array, Square, Summation};
use crate::system::{ByVelocities, Orientation, Poles, VelocityForm, acceleration, row_scale, velocity_near};

/// Coefficients of one step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R, const S: usize> {
    poles: Poles,
    constants: P,
    h: R,
    /// h·A.
    coupling: [[R; S]; S],
    /// h·c.
    nodes: [R; S],
    /// h·b.
    weights: [R; S],
}

/// What a step hands on to the next one.
#[derive(Clone, Copy, Debug)]
pub struct Memory<A, const S: usize> {
    newton: Newton<[A; S]>,
    orientation: Orientation,
}

impl<Y: VelocityForm<R>, R: Real> Stages<Y, R> for ByVelocities {
    type Prepared<const S: usize> = Prepared<Y::Constants, R, S>;
    type Memory<const S: usize> = Memory<Y::Array, S>;

    fn prepare<const S: usize>(system: &Y, h: R) -> Self::Prepared<S>
    where
        Gauss<S>: GaussTableau<S>,
    {
        let Tableau { a, b, c } = Gauss::<S>::TABLEAU;
        Prepared {
            poles: Poles::of(system),
            constants: VelocityForm::constants(system),
            h,
            coupling: a.map(|row| row.map(|a| R::from_f64(a) * h)),
            nodes: c.map(|c| R::from_f64(c) * h),
            weights: b.map(|b| R::from_f64(b) * h),
        }
    }

    fn memory<const S: usize>() -> Self::Memory<S> {
        Memory { newton: Newton::new(Y::Array::LEN, 1), orientation: Orientation::unknown() }
    }

    #[inline(always)]
    fn step<const S: usize, C: Summation<Y::Phase>, P: Probe<Y, R>>(
        Prepared { poles, constants, h, coupling, nodes, weights }: &Self::Prepared<S>,
        Memory { newton, orientation }: &mut Self::Memory<S>,
        Step { system, t, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let (none, nothing) = (Y::Array::zero(), Y::Array::fill(Y::Array::zero()));
        let z = x.z;
        let [q0, p0] = z;
        probe.visit(t, &z, &());
        let at_start = || velocity_near(system, t, &z, none);
        let sign = orientation.sign::<R>(|| Some(at_start()?.1))?;

        // Velocities as if v' were constant.
        let nodes = *nodes;
        let explicit = move || {
            let v = velocity_near(system, t, &z, none).map_or(none, |(v, _)| v);
            let rate = acceleration(system, t, &q0, &v);
            core::array::from_fn(|i| {
                let mut v = v;
                v.add_scaled(nodes[i], &rate);
                v
            })
        };
        // The accuracy of a velocity that can be seen in the position which h times it is added to.
        let mut visible = none;
        visible.add_scaled(R::from_f64(1.0) / *h, &q0);

        // Values and derivatives of a stage.
        let stage = |probe: &mut P, i: usize, v: &[Y::Array; S]| {
            let mut q = none;
            for j in 0..S {
                q.add_scaled(coupling[i][j], &v[j]);
            }
            let q = sum(&q0, &q);
            probe.visit(t + nodes[i], &[q, p0], &());
            let (mut p, mut f, mut derivatives) = (none, none, [nothing; 4]);
            system.stage(constants, t + nodes[i], &q, &v[i], [&mut p, &mut f], &mut derivatives);
            (p, f, derivatives)
        };
        // V less the residual of each stage in units of the velocity, and the derivative of that.
        let evaluate = |probe: &mut P, v: &[Y::Array; S], matrix: &mut Square<[Y::Array; S]>| {
            let mut stages: [_; S] = core::array::from_fn(|i| stage(probe, i, v));
            let rows = <[Y::Array; S]>::entries::<[Y::Array; S]>(matrix);
            let mut image = *v;
            for i in 0..S {
                let mut residual = stages[i].0;
                residual.add_scaled(R::from_f64(-1.0), &p0);
                for j in 0..S {
                    residual.add_scaled(-coupling[i][j], &stages[j].1);
                }
                for r in 0..Y::Array::LEN {
                    let mut scale =
                        R::from_f64(1.0) / row_scale(&Y::Array::entries::<Y::Array>(&mut stages[i].2[1])[r], r);
                    if i == 0 && r == 0 {
                        scale = sign_of_stages::<R, S>(sign) * scale;
                    }
                    let row = &mut rows[i * Y::Array::LEN + r];
                    for k in 0..S {
                        let mut entry = none;
                        let [by_q, mass, ..] = &mut stages[i].2;
                        entry.add_scaled(coupling[i][k], &Y::Array::entries::<Y::Array>(by_q)[r]);
                        if i == k {
                            entry.add_scaled(R::from_f64(1.0), &Y::Array::entries::<Y::Array>(mass)[r]);
                        }
                        let [.., by_v] = &mut stages[k].2;
                        entry.add_scaled(-coupling[i][k], &Y::Array::entries::<Y::Array>(by_v)[r]);
                        for j in 0..S {
                            let [_, _, by_q, _] = &mut stages[j].2;
                            let weight = -(coupling[i][j] * coupling[j][k]);
                            entry.add_scaled(weight, &Y::Array::entries::<Y::Array>(by_q)[r]);
                        }
                        for x in entry.as_mut_slice() {
                            *x *= scale;
                        }
                        row[k] = entry;
                    }
                    let v = &mut image[i].as_mut_slice()[r];
                    *v = (-scale).multiply_add(residual.as_slice()[r], *v);
                }
            }
            image
        };
        let image = |probe: &mut P, v: &[Y::Array; S]| evaluate(probe, v, &mut <[Y::Array; S]>::fill([none; S]));
        let still = P::PATIENT.then_some(0.0);
        let (v, _) = newton.solve((&[visible; S], still), explicit, probe, image, evaluate)?;

        let (mut change, mut impulse) = (none, none);
        for i in 0..S {
            change.add_scaled(weights[i], &v[i]);
            let mut q = none;
            for j in 0..S {
                q.add_scaled(coupling[i][j], &v[j]);
            }
            let f = system.force(constants, t + nodes[i], &sum(&q0, &q), &v[i]);
            impulse.add_scaled(weights[i], &f);
        }
        let before = start::<Y, R, C>(x);
        x.add(&[change, impulse]);
        // The end has a velocity, and the mass matrix is not singular on the way, as far as its sign shows.
        let end = velocity_near(system, t + *h, &x.z, v[S - 1]);
        orientation.agrees(end.map(|(_, positive)| positive))?;
        check_end(poles, [t, t + *h], &before, Step { system, t, x, probe })
    }
}

/// The sign of the determinant of as many mass matrices as there are stages.
#[inline(always)]
fn sign_of_stages<R: Real, const S: usize>(sign: R) -> R {
    if S % 2 == 0 { R::from_f64(1.0) } else { sign }
}
