//! Two runs give the same bits, with each kind of step, and so do two builds. If `BITS` names a folder, the first build writes the last states to it, and
//! the next build compares. `.ci/alike` lets an unoptimised build write, and an optimised build compare.

use geoint_runtime::method::catalogue;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Snapshot, Summation};
use geoint_runtime::{Method, PhaseSpace, TaylorIntegrator};
use geoint_tests::methods::Visitor;
use geoint_tests::problems::{DoublePendulum, Problem};
use geoint_tests::scene::{Scene, flat, point};
use nalgebra::Vector3;
use std::marker::PhantomData;
use std::path::Path;

/// Returns the bits of the coordinates of a state.
fn bits(state: &impl Snapshot<Real = f64>) -> String {
    flat(state).iter().chain([&state.time()]).map(|x| format!("{:016x}\n", x.to_bits())).collect()
}

/// Asserts that two runs lead to the same state, and to the state of the build before.
fn alike(name: &str, run: impl Fn() -> String) {
    let found = run();
    assert_eq!(found, run(), "{name}: two runs");
    let Some(folder) = std::env::var_os("BITS") else { return };
    let file = Path::new(&folder).join(name);
    if file.exists() {
        assert_eq!(std::fs::read_to_string(file).expect("a state"), found, "{name}: two builds");
    } else {
        std::fs::write(file, found).expect("a state");
    }
}

/// Takes steps by the bare loop, and a single step.
fn ended<S: PhaseSpace, M: Method<S>, C: Summation<S::Phase>>(mut sim: Integrator<S, M, f64, C>) -> String {
    sim.advance(25).and_then(|()| sim.step()).expect("steps");
    bits(&sim.state())
}

/// Tests the methods of a list on a scene.
struct Alike<P> {
    h: f64,
    scene: PhantomData<P>,
}

impl<P: Scene> Visitor<P::Over<f64>> for Alike<P> {
    fn visit<M: Method<P::Over<f64>> + 'static>(&mut self, method: M) {
        let (t, x) = P::start();
        let run = || Integrator::new(P::over::<f64>(), method, self.h, point(t, &x));
        alike(&format!("{}, {}", P::NAME, method.name()), || ended(run()) + &ended(run().compensated()));
    }
}

geoint_tests::every_kind!(Alike);

/// Sun, asteroid, Jupiter, Saturn in AU, days and solar masses.
#[hamiltonian(coordinates = jacobi)]
fn asteroid(q: [Vector3<f64>; 4], p: [Vector3<f64>; 4], m: [f64; 4], g: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..4 {
        energy += p[i].norm_squared() / (2.0 * m[i]);
        for j in 0..i {
            energy -= g * m[i] * m[j] / (q[i] - q[j]).norm();
        }
    }
    energy
}

/// A hundred years in steps of 40 days. The check of the energy finds errors of an optimiser that both runs of a build share.
struct Century(State<[Vector3<f64>; 4]>, Asteroid);

impl Visitor<Asteroid> for Century {
    fn visit<M: Method<Asteroid> + 'static>(&mut self, method: M) {
        let Century(start, system) = *self;
        alike(&format!("asteroid, {}", method.name()), || {
            let mut sim = system.integrator(method, 40.0, start);
            sim.advance(913).expect("steps");
            let error = sim.energy() / system.energy(&start) - 1.0;
            assert!(error.abs() < 1e-6, "{}: {error:.1e}", method.name());
            bits(&sim.state())
        });
    }
}

/// Regression test: one release of rustc vectorised the processor of these methods wrongly. The fault appeared only after inlining with full optimisation.
#[test]
fn planets_in_three_dimensions() {
    let m = [1.00000597682, 1e-6, 0.000954786104043, 0.000285583733151];
    let q = [[0.0; 3], [2.34, 0.0, 0.0], [-3.5023653, -3.8169847, -1.5507963], [9.0755314, -3.0458353, -1.6483708]];
    let v =
        [[0.0; 3], [0.0, 0.0108, 0.0046], [0.00565429, -0.00412490, -0.00190589], [0.00168318, 0.00483525, 0.00192462]];
    let p = std::array::from_fn(|i| Vector3::from(v[i]) * m[i]);
    let mut century = Century(State::new(q.map(Vector3::from), p), Asteroid { m, g: 2.95912208286e-4 });
    catalogue::perturbed(&mut century);
    catalogue::processed(&mut century);
}

/// Estimates of errors choose the steps of these runs.
#[test]
fn steps_that_adapt() {
    fn check<T: Trajectory<State = State<[f64; 2]>>>(name: &str, run: impl Fn() -> T) {
        alike(name, || {
            let mut run = run();
            run.advance(100).expect("steps");
            bits(&run.state())
        });
    }
    let (system, start) = (DoublePendulum::system::<f64>(), DoublePendulum::initial(0.2));
    check("adaptive DOP853", || system.adaptive(DOP853, 1e-9, start));
    check("adaptive Gauss", || system.adaptive(Gauss::<3>, 1e-9, start));
    check("adaptive discrete gradient", || system.adaptive(DiscreteGradient, 1e-6, start));
    check("Taylor", || TaylorIntegrator::new(system, Taylor::default(), start));
}
