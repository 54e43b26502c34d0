//! Errors in heliocentric coordinates, in which the rest moves positions, too.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::distance;
use geoint_tests::outer_planets;
use geoint_tests::problems::flat;
use nalgebra::Vector3;

use crate::both::heliocentric::{OUTER, OuterPlanets};

type Bodies = State<[Vector3<f64>; 6]>;

fn end<M: Method<OuterPlanets>>(method: M, steps: u64) -> Bodies {
    let mut sim = OUTER.integrator(method, 200_000.0 / steps as f64, outer_planets::start());
    sim.advance(steps).expect("no collision");
    sim.state()
}

/// Errors over 547 years agree to 20 % with another program that uses the same tables.
#[test]
fn the_outer_solar_system_has_the_errors_of_other_programs() {
    // The reference is a method without special coordinates. Its steps are so short that only rounding is left.
    let exact = end(BceRkn17_8, 5000);
    let error = |state: Bodies| outer_planets::error(&state, &exact);
    let near = |name: &str, error: f64, expected: f64| {
        assert!((error / expected - 1.0).abs() < 0.2, "{name}: {error:.2e}, expected {expected:.2e}");
    };
    near("WisdomHolman", error(end(WisdomHolman, 1000)), 3.0e-5);
    near("Aba10_6_4", error(end(Aba10_6_4, 500)), 9.7e-11);
    assert!(error(end(Aba10_6_4, 1000)) < 5e-12);
    // A processor removes the error of first order. The remaining error is eight times the error in Jacobi coordinates.
    near("WisdomHolmanProcessed", error(end(WisdomHolmanProcessed, 1000)), 6.0e-7);
}

/// Three bodies of which none is small, and a tide.
#[hamiltonian(coordinates = heliocentric)]
fn three(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], tide: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]) + tide * m[i] * q[i][0] * q[i][0];
        for j in 0..i {
            energy -= m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
        }
    }
    energy
}

/// The same without.
#[hamiltonian(coordinates = heliocentric)]
fn free(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3]) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
        for j in 0..i {
            energy -= m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
        }
    }
    energy
}

/// Asserts the order in h that a method has and claims.
macro_rules! orders {
    ($system:expr, $($method:ident $order:literal $perturbed:expr;)*) => { $({
        let start = State::new([[0.0, 0.0], [1.0, 0.2], [-2.5, 0.5]], [[0.1, -0.5], [-0.2, 0.9], [0.1, -0.4]]);
        let run = |steps: u64| {
            let mut sim = $system.integrator($method, 1.0 / steps as f64, start);
            sim.advance(steps).expect("no collision");
            flat(&sim.state())
        };
        let mut exact = $system.integrator(BceRkn17_8, 0.005, start);
        exact.advance(200).expect("no collision");
        let [long, short] = [32, 64].map(|steps| distance(&run(steps), &flat(&exact.state())));
        let claims = claims_of(&$system, $method);
        let perturbed: &[u32] = $perturbed;
        assert_eq!((claims.order, claims.perturbed), ($order, perturbed), stringify!($method));
        let observed = (long / short).log2();
        assert!((observed - f64::from($order)).abs() < 0.15, "{}: {observed}", stringify!($method));
    })* };
}

fn claims_of<S: geoint_runtime::PhaseSpace, M: Method<S>>(_: &S, method: M) -> geoint_runtime::Claims {
    method.claims()
}

const MASSES: [f64; 3] = [1.3, 0.7, 0.5];

/// The gravity between planets depends on their differences. The motion of body 0 does not change them, so all tables keep their orders.
#[test]
fn gravity_leaves_the_motion_of_body_0_alone() {
    orders! {
        Free { m: MASSES },
        WisdomHolman 2 &[2, 2];
        Aba8_4 4 &[8, 4];
        Saba4 2 &[8, 2];
    }
}

/// A force that depends on the positions of all bodies breaks the order. The splitting of the motion of body 0 around the kick has order 2, and so has
/// every table.
#[test]
fn a_tide_does_not() {
    orders! {
        Three { m: MASSES, tide: 0.8 },
        WisdomHolman 2 &[];
        Aba8_4 2 &[];
        Aba8_6_4 2 &[];
        WisdomHolmanProcessed 2 &[];
    }
}

/// The map of Wisdom and Holman is Verlet's method with an exact flow as the drift. Its compositions have the same orders.
#[test]
fn compositions_have_their_order() {
    let start = State::new([[0.0, 0.0], [1.0, 0.2], [-2.5, 0.5]], [[0.1, -0.5], [-0.2, 0.9], [0.1, -0.4]]);
    let system = Free { m: MASSES };
    let mut holman = system.integrator(WisdomHolman, 0.05, start);
    let mut verlet = system.integrator(Perturbation(PositionVerlet), 0.05, start);
    holman.advance(20).expect("no collision");
    verlet.advance(20).expect("no collision");
    assert_eq!(holman.state(), verlet.state());
    let mut exact = system.integrator(BceRkn17_8, 0.005, start);
    exact.advance(200).expect("no collision");
    let error = |steps: u64| {
        let mut sim = system.integrator(Suzuki4.of(WisdomHolman), 1.0 / steps as f64, start);
        sim.advance(steps).expect("no collision");
        distance(&flat(&sim.state()), &flat(&exact.state()))
    };
    let observed = (error(32) / error(64)).log2();
    assert!((observed - 4.0).abs() < 0.15, "{observed}");
}
