//! Every form of a system under the methods of its lists: in other units, in `f32`, in single steps and in one call.

use geoint_runtime::method::{Visitor, catalogue};
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Action, Array, Snapshot};
use geoint_runtime::system::StateOf;
use geoint_runtime::{Method, PhaseSpace, Real};
use std::marker::PhantomData;

/// Powers of two: what was 1 in the units of before is 2ᵏ in these.
#[derive(Clone, Copy, Debug)]
struct Units {
    q: i32,
    p: i32,
    t: i32,
}

const PLAIN: Units = Units { q: 0, p: 0, t: 0 };
const UNITS: [Units; 4] = [
    Units { q: 3, p: -5, t: 1 },
    Units { q: 37, p: 97, t: 23 },
    Units { q: -33, p: -80, t: -53 },
    Units { q: -61, p: 60, t: 40 },
];

/// x·2ᵏ.
fn times(x: f64, k: i32) -> f64 {
    x * 2.0_f64.powi(k)
}

/// A parameter of another scalar.
trait Over<T> {
    fn over(self) -> T;
}

impl Over<f64> for f64 {
    fn over(self) -> f64 {
        self
    }
}

impl Over<f32> for f64 {
    fn over(self) -> f32 {
        self as f32
    }
}

impl<T, const N: usize> Over<[T; N]> for [f64; N]
where
    f64: Over<T>,
{
    fn over(self) -> [T; N] {
        self.map(Over::over)
    }
}

macro_rules! systems {
    ($module:ident, $real:ident) => {
        mod $module {
            use geoint_runtime::prelude::*;
            use nalgebra::{UnitQuaternion, Vector3};

            #[contact_hamiltonian]
            pub(super) fn damped(q: [$real; 2], p: [$real; 2], s: $real, m: $real, k: $real, gamma: $real) -> $real {
                (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / q[0].hypot(q[1]) + gamma * s
            }

            /// A pendulum whose length is a constraint.
            #[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - l * l) / 2.0])]
            pub(super) fn bound(q: [$real; 3], p: [$real; 3], m: $real, l: $real, g: $real) -> $real {
                (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + m * g * q[2]
            }

            #[hamiltonian(coordinates = jacobi)]
            pub(super) fn planets(q: [[$real; 2]; 3], p: [[$real; 2]; 3], m: [$real; 3], g: $real) -> $real {
                let mut energy = 0.0;
                for i in 0..3 {
                    energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
                    for j in 0..i {
                        energy -= g * m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
                    }
                }
                energy
            }

            /// A charge in a field, and bound.
            #[hamiltonian]
            pub(super) fn charge(q: [$real; 2], p: [$real; 2], m: $real, b: $real, k: $real) -> $real {
                let u = [p[0] + 0.5 * b * q[1], p[1] - 0.5 * b * q[0]];
                (u[0] * u[0] + u[1] * u[1]) / (2.0 * m) + k * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
            }

            #[hamiltonian(structure = so3)]
            pub(super) fn top(x: [$real; 3], inertia: [$real; 3]) -> $real {
                (x[0] * x[0] / inertia[0] + x[1] * x[1] / inertia[1] + x[2] * x[2] / inertia[2]) / 2.0
            }

            #[vector_field(keeps(wealth = d * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()))]
            pub(super) fn predators(x: [$real; 2], a: $real, b: $real, c: $real, d: $real) -> [$real; 2] {
                [x[0] * (a - b * x[1]), x[1] * (d * x[0] - c)]
            }

            /// Two masses on rods.
            #[lagrangian]
            pub(super) fn rods(q: [$real; 2], v: [$real; 2], m: $real, l: $real, g: $real) -> $real {
                let coupling = v[0] * v[1] * (q[0] - q[1]).cos();
                m * l * l * (v[0] * v[0] + 0.5 * v[1] * v[1] + coupling) + m * g * l * (2.0 * q[0].cos() + q[1].cos())
            }

            /// Linear in velocities.
            #[lagrangian]
            pub(super) fn vortices(q: [$real; 2], v: [$real; 2], k: $real, w: $real) -> $real {
                k * q[0] * v[1] - w * (1.0 + q[0] * q[0] + 3.0 * q[1] * q[1]).ln()
            }

            #[hamiltonian(attitude = r)]
            pub(super) fn heavy_body(
                r: UnitQuaternion<$real>,
                m: Vector3<$real>,
                inertia: [$real; 3],
                weight: $real,
            ) -> $real {
                let spin = m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2];
                spin / 2.0 + weight * (r * Vector3::new(0.3, -0.2, 0.7)).z
            }
        }
    };
}

systems!(double, f64);
systems!(single, f32);

/// A system in either scalar.
trait Form<R: Real> {
    type System: PhaseSpace<R>;
    fn system(units: Units) -> Self::System;
}

/// What does not depend on the scalar.
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

/// m, of which p = m·q/t.
fn mass(x: f64, u: Units) -> f64 {
    times(x, u.p + u.t - u.q)
}

/// An energy times qⁿ.
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

/// Steps whose bits are compared, and those of a long run.
const FEW: u64 = 30;
const MANY: u64 = 200;

/// How far a long run in `f32` may be from that in `f64`. With constraints most: what a position is rounded by, divided by the step, is seen
/// in the momentum, and compositions have short steps.
const NEARBY: f64 = 1e-2;

/// A form under methods in `f64`: units, single steps, and where a long run ends.
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
        // Flows that are merged within one call are rounded once in place of twice.
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

/// The same methods in `f32` end nearby.
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
    contact: Damped, catalogue::separable catalogue::quadratic_kinetic catalogue::force_gradient catalogue::pieces
        catalogue::mechanical catalogue::contact;
    constraints: Bound, catalogue::constrained;
    planets: Planets, catalogue::perturbed catalogue::perturbed_gradient catalogue::processed;
    pieces: Charge, catalogue::coupled catalogue::nystrom_pieces;
    structures: Top, catalogue::poisson structured;
    fields: Predators, catalogue::planar structured;
    velocities: Rods, of_velocities;
    bodies: HeavyBody, catalogue::separable catalogue::principal_axes;
}

/// Methods for fields that keep something.
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

/// Methods for Lagrangians whose mass matrix is full.
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
