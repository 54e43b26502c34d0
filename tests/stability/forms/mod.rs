//! Every form of a system under the methods of its lists: in other units, in `f32`, in single steps and in one call.

mod systems;

use super::units::{PLAIN, Units, power};
use geoint_runtime::method::{Visitor, catalogue};
use geoint_runtime::prelude::*;
use geoint_runtime::private::{Action, Jets};
use geoint_runtime::space::{Array, Snapshot};
use geoint_runtime::system::StateOf;
use geoint_runtime::{Method, PhaseSpace, Real, TaylorIntegrator};
use geoint_tests::methods;
use std::marker::PhantomData;
use systems::{Over, double, single};

const UNITS: [Units; 4] = [
    Units { q: 3, p: -5, t: 1 },
    Units { q: 37, p: 97, t: 23 },
    Units { q: -33, p: -80, t: -53 },
    Units { q: -61, p: 60, t: 40 },
];

/// x·2ᵏ.
fn times(x: f64, k: i32) -> f64 {
    x * power(k)
}

/// A system in either scalar.
trait Form<R: Real> {
    type System: PhaseSpace<R>;
    fn system(units: Units) -> Self::System;
}

/// The properties of a form that do not depend on the scalar.
trait Written {
    /// All coordinates in plain units, and the action.
    const START: &'static [f64];
    const STEP: f64;
    fn exponents(units: Units) -> Vec<i32>;
}

macro_rules! forms {
    ($($name:ident from $start:expr, step $step:expr, units |$u:ident| $exponents:expr,
        $System:ident { $($field:ident: $value:expr),* $(,)? })*) => { $(
        struct $name;
        impl Written for $name {
            const START: &'static [f64] = &$start;
            const STEP: f64 = $step;
            fn exponents($u: Units) -> Vec<i32> {
                $exponents
            }
        }
        forms!(@ $name, double, f64, $u, $System { $($field: $value),* });
        forms!(@ $name, single, f32, $u, $System { $($field: $value),* });
    )* };
    (@ $name:ident, $module:ident, $real:ident, $u:ident, $System:ident { $($field:ident: $value:expr),* }) => {
        impl Form<$real> for $name {
            type System = $module::$System;
            fn system($u: Units) -> Self::System {
                $module::$System { $($field: $value.over()),* }
            }
        }
    };
}

/// Scales a mass m, because p = m·q/t.
fn mass(x: f64, u: Units) -> f64 {
    times(x, u.p + u.t - u.q)
}

/// Scales an energy times qⁿ.
fn energy(x: f64, n: i32, u: Units) -> f64 {
    times(x, u.q + u.p - u.t + n * u.q)
}

forms! {
    Damped from [0.9, 0.2, -0.3, 1.9, 0.4], step 0.03, units |u| vec![u.q, u.q, u.p, u.p, u.q + u.p],
        Damped { m: mass(1.6, u), k: energy(2.3, 1, u), gamma: times(0.03, -u.t) }
    Bound from [0.6, 0.0, -0.8, 0.0, 0.7, 0.0], step 0.1, units |u| vec![u.q, u.q, u.q, u.p, u.p, u.p],
        Bound { m: mass(0.7, u), l: times(1.0, u.q), g: times(1.7, u.q - 2 * u.t) }
    Planets from [0.0, 0.0, 1.0, 0.0, 0.0, 2.1, 0.002, -0.001, 0.0, 0.01, -0.0137, 0.0], step 0.05,
        units |u| [[u.q; 6], [u.p; 6]].concat(),
        Planets { m: [1.0, 0.01, 0.02].map(|m| mass(m, u)), g: times(1.0, 4 * u.q - u.p - 3 * u.t) }
    Charge from [0.7, -0.2, 0.3, 0.5], step 0.05, units |u| vec![u.q, u.q, u.p, u.p],
        Charge { m: mass(1.3, u), b: times(1.1, u.p - u.q), k: energy(0.4, -4, u) }
    Top from [0.5, 1.6, -1.2], step 0.1, units |u| vec![u.p; 3],
        Top { inertia: [1.0, 2.0, 3.1].map(|i| times(i, u.p + u.t)) }
    // Fields are projected as if all coordinates had one unit.
    Predators from [1.3, 0.6], step 0.05, units |u| vec![u.q, u.q],
        Predators { a: times(1.1, -u.t), b: times(0.7, -u.q - u.t), c: times(0.9, -u.t), d: times(0.8, -u.q - u.t) }
    Rods from [1.1, -0.4, 0.3, 0.2], step 0.03, units |u| vec![0, 0, u.p, u.p],
        Rods { m: times(0.9, u.p + u.t - 2 * u.q), l: times(1.2, u.q), g: times(3.1, u.q - 2 * u.t) }
    Vortices from [0.5, -0.3], step 0.05, units |u| vec![u.q; 2],
        Vortices { k: times(1.2, u.p - u.q), w: times(0.8, u.q + u.p - u.t), l: times(1.0, u.q) }
    HeavyBody from [0.8, 0.0, 0.6, 0.0, 0.5, 1.6, -1.2, 0.0], step 0.05, units |u| [[0; 4], [u.p; 4]].concat(),
        HeavyBody { inertia: [1.0, 2.0, 3.1].map(|i| times(i, u.p + u.t)), weight: times(0.8, u.p - u.t) }
}

fn start<F: Written + Form<R>, R: Real>(units: Units) -> StateOf<F::System, R> {
    let (mut z, mut s) = (<F::System as PhaseSpace<R>>::Phase::zero(), <F::System as PhaseSpace<R>>::Action::zero());
    let values: Vec<R> = F::START.iter().zip(F::exponents(units)).map(|(x, k)| R::from_f64(times(*x, k))).collect();
    let (of_z, of_s) = values.split_at(z.as_slice().len());
    z.as_mut_slice().copy_from_slice(of_z);
    s.numbers_mut().copy_from_slice(of_s);
    Snapshot::of(R::from_f64(0.0), z, s)
}

/// All coordinates of a state, and the action, in plain units.
fn plain<F: Written + Form<R>, R: Real>(units: Units, state: StateOf<F::System, R>) -> Vec<R> {
    let (_, z, s) = state.parts();
    let values = z.as_slice().iter().chain(s.numbers()).copied().collect::<Vec<R>>();
    values.into_iter().zip(F::exponents(units)).map(|(x, k)| x * R::from_f64(times(1.0, -k))).collect()
}

/// Number of steps whose bits are compared, and number of steps of a long run.
const FEW: u64 = 30;
const MANY: u64 = 200;

/// Bound on the distance between a long run in `f32` and the same run in `f64`. Constraints cause the largest distance. The rounding of a position, divided
/// by the step, enters the momentum, and compositions have short steps.
const NEARBY: f64 = 1e-2;

/// Tests a form under methods in `f64`: other units, single steps, and the end of a long run.
struct Walk<F> {
    ends: Vec<(String, Vec<f64>)>,
    failures: Vec<String>,
    form: PhantomData<F>,
}

impl<F: Written + Form<f64>> Visitor<F::System, f64> for Walk<F> {
    fn visit<M: Method<F::System, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let bits = |units: Units, state: StateOf<F::System, f64>| -> Vec<u64> {
            plain::<F, f64>(units, state).iter().map(|x| x.to_bits()).collect()
        };
        let integrator =
            |units: Units| F::system(units).integrator(method, times(F::STEP, units.t), start::<F, f64>(units));
        let run = |units: Units| {
            let mut sim = integrator(units);
            (sim.advance(FEW).is_ok(), sim.steps(), bits(units, sim.state()))
        };
        let expected = run(PLAIN);
        for units in UNITS {
            let seen = run(units);
            if seen != expected {
                self.failures.push(format!("{name} in {units:?}: {seen:?}, plain {expected:?}"));
            }
        }
        // Flows that are merged within one call are rounded once instead of twice.
        let mut batch = integrator(PLAIN);
        let mut sim = integrator(PLAIN);
        let outcomes = [batch.advance(FEW), (0..FEW).try_for_each(|_| sim.step())];
        let [all, single] = [batch.state(), sim.state()].map(|state| plain::<F, f64>(PLAIN, state));
        let apart = all.iter().zip(&single).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if outcomes[0] != outcomes[1] || apart > 1e-13 || apart.is_nan() {
            self.failures.push(format!("{name} in single steps: {outcomes:?}, {apart:.1e}"));
        }
        match sim.advance(MANY - FEW) {
            Ok(()) => self.ends.push((name, plain::<F, f64>(PLAIN, sim.state()))),
            Err(error) => self.failures.push(format!("{name}: {error}")),
        }
    }
}

/// Asserts that the same methods in `f32` end nearby.
struct Single<F> {
    walk: Walk<F>,
}

impl<F: Written + Form<f32>> Visitor<F::System, f32> for Single<F> {
    fn visit<M: Method<F::System, f32> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let Some((_, expected)) = self.walk.ends.iter().find(|(other, _)| *other == name) else { return };
        let mut sim = F::system(PLAIN).integrator(method, F::STEP as f32, start::<F, f32>(PLAIN));
        if let Err(error) = sim.advance(MANY) {
            self.walk.failures.push(format!("{name} in f32: {error}"));
            return;
        }
        let seen = plain::<F, f32>(PLAIN, sim.state());
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let far = |(seen, expected): (&f32, &f64)| (f64::from(*seen) - expected).abs() > NEARBY * size;
        if seen.iter().zip(expected).any(far) {
            self.walk.failures.push(format!("{name} in f32: {seen:?}, in f64 {expected:?}"));
        }
    }
}

macro_rules! in_every_form {
    ($($test:ident: $form:ident, $($list:path)*;)*) => { $(
        #[test]
        fn $test() {
            let mut walk = Walk::<$form> { ends: vec![], failures: vec![], form: PhantomData };
            $( $list(&mut walk); )*
            assert!(!walk.ends.is_empty());
            let mut single = Single { walk };
            $( $list(&mut single); )*
            assert!(single.walk.failures.is_empty(), "{}", single.walk.failures.join("\n"));
        }
    )* };
}

in_every_form! {
    contact: Damped, methods::kinds_of_separable methods::kinds_of_nystrom methods::kinds_of_force_gradient
        methods::kinds_of_pieces methods::kinds_of_mechanical methods::kinds_of_contact;
    constraints: Bound, methods::kinds_of_constrained;
    planets: Planets, methods::kinds_of_perturbed methods::kinds_of_perturbed_gradient catalogue::processed;
    pieces: Charge, methods::kinds_of_coupled catalogue::nystrom_pieces;
    structures: Top, methods::kinds_of_poisson structured;
    fields: Predators, methods::kinds_of_planar structured;
    velocities: Rods, of_velocities;
    linear_in_velocities: Vortices, of_velocities;
    bodies: HeavyBody, methods::kinds_of_separable catalogue::principal_axes;
}

/// Steps by Taylor series: their lengths follow from the coefficients of the solution, and are rounded otherwise in other units.
#[test]
fn series() {
    fn run<F: Written + Form<f64>>(units: Units) -> Vec<f64>
    where
        F::System: Jets,
    {
        let mut sim = TaylorIntegrator::new(F::system(units), Taylor::default(), start::<F, f64>(units));
        assert_eq!(sim.advance(20), Ok(()), "{units:?}");
        let mut values = plain::<F, f64>(units, sim.state());
        values.push(times(sim.time(), -units.t));
        values
    }
    fn check<F: Written + Form<f64>>()
    where
        F::System: Jets,
    {
        let expected = run::<F>(PLAIN);
        for units in UNITS {
            for (seen, expected) in run::<F>(units).iter().zip(&expected) {
                assert!((seen - expected).abs() <= 1e-13 * (1.0 + expected.abs()), "{units:?}: {seen}, {expected}");
            }
        }
    }
    check::<Damped>();
    check::<Charge>();
    check::<Top>();
    check::<Predators>();
}

/// Visits methods for fields with invariants.
fn structured<S: PhaseSpace<R>, R: Real>(visitor: &mut impl Visitor<S, R>)
where
    DiscreteGradient: Method<S, R>,
    FourthOrder<DiscreteGradient>: Method<S, R>,
    ImplicitMidpoint: Method<S, R>,
    Gauss<3>: Method<S, R>,
{
    visitor.visit(DiscreteGradient);
    visitor.visit(FourthOrder(DiscreteGradient));
    visitor.visit(ImplicitMidpoint);
    visitor.visit(Gauss::<3>);
}

/// Visits methods for Lagrangians with a full mass matrix, or without one.
fn of_velocities<S: PhaseSpace<R>, R: Real>(visitor: &mut impl Visitor<S, R>)
where
    DiscreteGradient: Method<S, R>,
    ImplicitMidpoint: Method<S, R>,
    Gauss<3>: Method<S, R>,
{
    visitor.visit(DiscreteGradient);
    visitor.visit(ImplicitMidpoint);
    visitor.visit(Gauss::<3>);
}
