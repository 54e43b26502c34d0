//! Stages of a differential equation y' = f(y, t), or q'' = M⁻¹f(q, t): solved for the values of f.

use super::defect;
use super::prepared::{Prepared, PreparedFields};
use super::stages::Stages;
use super::{Gauss, GaussTableau};
use crate::method::explicit::tableau::Tableau;
use crate::method::{Estimate, Probe, Refusal, Step, StepsOf, check_end, check_way, start};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::{Array, PerCoordinate, Snapshot, Summation};
use crate::system::{ByField, Collocation};
use core::array::from_fn;

/// Steps of fewer stages are compared with their halves because three solved equations cost less than one and a look at its defect; those of more
/// because 4ˢ times the rounding of a step is more than tolerances near 10⁻¹² allow.
const STAGES: [usize; 2] = [3, 4];

/// With more unknowns the eliminations that an estimate takes cost more than two equations that are solved by evaluations.
const MOST_UNKNOWNS: usize = 6;

/// Whether steps estimate their errors.
const fn estimates<Y: Collocation<R>, R: Real, const S: usize>() -> bool {
    STAGES[0] <= S && S <= STAGES[1] && Y::Unknown::LEN <= MOST_UNKNOWNS
}

impl<Y: Collocation<R>, R: Real, const S: usize> StepsOf<Gauss<S>, Y, R> for ByField
where
    Gauss<S>: GaussTableau<S>,
{
    type Prepared = PreparedFields<Y::Constants, R, S>;
    type Memory = Newton<[Y::Unknown; S]>;

    fn prepare(system: &Y, h: R) -> Self::Prepared {
        let stages = Prepared::new(system, system.constants(), h);
        if Y::DERIVATIVE == 1 {
            return PreparedFields { stages, coupling: stages.coupling, increments: stages.weights };
        }
        let Tableau { a, b, c } = Gauss::<S>::TABLEAU;
        let square = |i: usize, j: usize| (0..S).map(|k| a[i][k] * a[k][j]).sum();
        PreparedFields {
            stages,
            coupling: from_fn(|i| from_fn(|j| R::from_f64(square(i, j)) * h * h)),
            increments: from_fn(|i| R::from_f64(b[i] * (1.0 - c[i])) * h * h),
        }
    }

    fn memory() -> Self::Memory {
        Newton::new(Y::State::ALIKE, Y::Unknown::LEN / Y::State::ALIKE)
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        newton: &mut Self::Memory,
        step: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let equation = Stages::new(step.system, prepared, step.t, step.x.z);
        taken(&equation, newton, step).map(drop)
    }

    fn order_of_estimate() -> Option<u32> {
        const { estimates::<Y, R, S>() }.then_some(2 * S as u32)
    }

    #[inline]
    fn estimated<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        newton: &mut Self::Memory,
        mut step: Step<'_, Y, R, C, P>,
    ) -> Option<Result<Estimate<Y, R>, Refusal>> {
        if const { !estimates::<Y, R, S>() } {
            return None;
        }
        let equation = Stages::new(step.system, prepared, step.t, step.x.z);
        let error = taken(&equation, newton, step.part([step.t, step.end])).and_then(|k| {
            let z = defect::error(&equation, &k, step.probe).ok_or(Refusal::Singular)?;
            Ok([PerCoordinate { z, s: () }, PerCoordinate::zero()])
        });
        Some(error)
    }
}

/// A step by the solution of its equation: the values of f at its stages.
#[inline(always)]
fn taken<Y: Collocation<R>, R: Real, C: Summation<Y::Phase>, P: Probe<Y, R>, const S: usize>(
    equation: &Stages<'_, Y, R, S>,
    newton: &mut Newton<[Y::Unknown; S]>,
    Step { system, t, end, x, probe }: Step<'_, Y, R, C, P>,
) -> Result<[Y::Unknown; S], Refusal> {
    let zero = Y::Unknown::zero();
    probe.visit(t, &x.z, &());
    let Solution { x: k, .. } = newton.solve(equation, probe)?;

    let PreparedFields { stages: Prepared { poles, constants, h, nodes, weights, .. }, increments, .. } =
        equation.prepared;
    for (i, node) in nodes.iter().enumerate() {
        let way = ([t, t + *node], [&equation.z, &equation.point(&equation.change(i, &k))], [&(), &()]);
        check_way::<Y, R, P>(poles, false, system, way, &mut x.doubtful)?;
    }
    let (mut change, mut impulse) = (zero, zero);
    change.add_scaled(*h, &equation.velocity);
    for i in 0..S {
        system.add(constants, increments[i], &k[i], &mut change);
        impulse.add_scaled(weights[i], &k[i]);
    }
    let before = start::<Y, R, C>(x);
    x.add(&Y::increments(&change, &impulse));
    check_end(poles, &before, Step { system, t, end, x, probe })?;
    Ok(k)
}
