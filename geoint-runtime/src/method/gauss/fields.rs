//! Stages of a differential equation y' = f(y, t), or q'' = M⁻¹f(q, t): solved for the values of f.

use super::prepared::{Prepared, PreparedFields};
use super::stages::Stages;
use super::{Gauss, GaussTableau};
use crate::method::explicit::tableau::Tableau;
use crate::method::{Earlier, Probe, Refusal, Step, StepsOf, check_end, check_way, start};
use crate::scalar::Real;
use crate::solving::newton::{Found, Newton};
use crate::space::{Array, Snapshot, Summation};
use crate::system::{ByField, Collocation};
use core::array::from_fn;

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
    fn follow(newton: &mut Self::Memory, before: [Earlier<'_, Self::Memory, R>; 2]) {
        newton.follow(before.map(|earlier| earlier.of_rates(|newton| newton)));
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        newton: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let zero = Y::Unknown::zero();
        let (y0, changed) = Y::start(&x.z);
        let velocity = system.velocity(&prepared.stages.constants, &changed);
        probe.visit(t, &x.z, &());
        let equation = Stages { system, prepared, t, z: x.z, y0, changed, velocity };
        let Found { x: k, outcome, .. } = newton.solve(&equation, probe);
        outcome?;

        let PreparedFields { stages: Prepared { poles, constants, h, nodes, weights, .. }, increments, .. } = prepared;
        for (i, node) in nodes.iter().enumerate() {
            let way = ([t, t + *node], [&equation.z, &equation.point(&equation.change(i, &k))], [&(), &()]);
            check_way::<Y, R, P>(poles, false, system, way, &mut x.doubtful)?;
        }
        let (mut change, mut impulse) = (zero, zero);
        change.add_scaled(*h, &velocity);
        for i in 0..S {
            system.add(constants, increments[i], &k[i], &mut change);
            impulse.add_scaled(weights[i], &k[i]);
        }
        let before = start::<Y, R, C>(x);
        x.add(&Y::increments(&change, &impulse));
        check_end(poles, &before, Step { system, t, end, x, probe })
    }
}
