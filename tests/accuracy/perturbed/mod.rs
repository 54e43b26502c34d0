//! Methods for H = A + B: their orders in h and in the size of B, and the outer solar system in Jacobi's coordinates. Some methods move a transformed
//! point; the state remains the user's.

mod orders;

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Claims, Method};
use geoint_tests::measure::distance;
use geoint_tests::methods::{self, Visitor};
use geoint_tests::outer_planets;
use geoint_tests::problems::{Planets, Problem, flat};
use geoint_tests::scalars::Double;
use nalgebra::Vector3;

/// An oscillator with a small rest.
#[hamiltonian]
fn hardening(q: f64, p: f64, m: f64, k: f64, epsilon: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0 + epsilon * (q.powi(3) / 3.0 + q.powi(4) / 5.0)
}

/// Bodies under their mutual gravity.
#[hamiltonian(coordinates = jacobi)]
fn outer_planets(q: [Vector3<f64>; 6], p: [Vector3<f64>; 6], m: [f64; 6], g: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..6 {
        energy += p[i].norm_squared() / (2.0 * m[i]);
        for j in 0..i {
            energy -= g * m[i] * m[j] / (q[i] - q[j]).norm();
        }
    }
    energy
}

const OUTER: OuterPlanets = OuterPlanets { m: outer_planets::MASSES, g: outer_planets::G };

type Bodies = State<[Vector3<f64>; 6]>;

fn outer_end<M: Method<OuterPlanets>>(method: M, steps: u64) -> Bodies {
    let mut sim = OUTER.integrator(method, 200_000.0 / steps as f64, outer_planets::start());
    sim.advance(steps).expect("no collision");
    sim.state()
}

/// Errors over 547 years equal the errors of another program with the same tables, to 20 %. The errors depend on A, B, the coordinates, the processor
/// and the gradient.
#[test]
fn the_outer_solar_system_has_the_errors_of_other_programs() {
    // The reference method does not use Jacobi's coordinates. Its steps are so short that only rounding is left.
    let exact = outer_end(BceRkn17_8, 5000);
    let near = |name: &str, error: f64, expected: f64| {
        assert!((error / expected - 1.0).abs() < 0.2, "{name}: {error:.2e}, expected {expected:.2e}");
    };
    near("WisdomHolman", outer_planets::error(&outer_end(WisdomHolman, 1000), &exact), 8.8e-6);
    near("WisdomHolmanProcessed", outer_planets::error(&outer_end(WisdomHolmanProcessed, 1000), &exact), 7.8e-8);
    near("WisdomHolmanGradient", outer_planets::error(&outer_end(WisdomHolmanGradient, 1000), &exact), 3.3e-10);
    near("WisdomHolmanGradient", outer_planets::error(&outer_end(WisdomHolmanGradient, 2000), &exact), 2.1e-11);
    near("Saba3Gradient", outer_planets::error(&outer_end(Saba3Gradient, 500), &exact), 5.4e-7);
    near("Saba3Gradient", outer_planets::error(&outer_end(Saba3Gradient, 1000), &exact), 1.15e-11);
    near("Aba10_6_4", outer_planets::error(&outer_end(Aba10_6_4, 250), &exact), 7.3e-8);
    near("Aba10_6_4", outer_planets::error(&outer_end(Aba10_6_4, 500), &exact), 1.2e-10);
    assert!(outer_planets::error(&outer_end(Aba10_6_4, 2000), &exact) < 2e-12);
    // A control: the same table for kicks and drifts has an error ten thousand times as large.
    assert!(outer_planets::error(&outer_end(StormerVerlet, 1000), &exact) > 1e-2);
}

#[test]
fn energies_and_momenta_of_planets_do_not_drift() {
    let mut sim = OUTER.integrator(Aba10_6_4, 100.0, outer_planets::start()).compensated();
    let (energy, moment) = (sim.energy(), |x: &Bodies| (0..6).map(|i| x.q[i].cross(&x.p[i])).sum::<Vector3<f64>>());
    let before = moment(&sim.state());
    sim.advance(50_000).expect("no collision");
    // Dividing momenta by a rounded mass and multiplying again would have lost twice as much by now, in a straight line.
    assert!((sim.energy() / energy - 1.0).abs() < 1e-14);
    assert!((moment(&sim.state()) - before).norm() < 5e-14 * before.norm());
}

/// The user's states appear before, between and after steps. Single steps agree with many steps at once.
#[test]
fn states_are_those_of_the_user() {
    fn check<M: Method<Planets>>(method: M) {
        let (system, start) = (Planets::system::<f64>(), Planets::initial(0.0));
        let mut sim = system.integrator(method, 0.05, start);
        assert_eq!(sim.state(), start);
        assert_eq!(sim.energy(), system.energy(&start));
        sim.step().expect("no collision");
        let one = sim.state();
        sim.advance(9).expect("no collision");
        let mut single = system.integrator(method, 0.05, start);
        for _ in 0..10 {
            single.step().expect("no collision");
        }
        let ten = sim.state();
        let near = |a: &State<[[f64; 2]; 3]>, b: &State<[[f64; 2]; 3]>, bound: f64| {
            let (a, b) = (flat(a), flat(b));
            a.iter().zip(&b).all(|(a, b)| (a - b).abs() < bound)
        };
        assert!(near(&ten, &single.state(), 1e-14), "{}", method.name());
        // Looked at, and gone on from there.
        let mut again = system.integrator(method, 0.05, one);
        again.advance(9).expect("no collision");
        assert!(near(&ten, &again.state(), 1e-13), "{}", method.name());
        // Half of the step from here on, and back: coefficients are others, the state is not.
        sim.set_step_size(-0.05);
        assert!(near(&ten, &sim.state(), 1e-14), "{}", method.name());
        sim.advance(10).expect("no collision");
        assert!(near(&start, &sim.state(), 1e-9), "{}", method.name());
    }
    check(WisdomHolman);
    check(WisdomHolmanProcessed);
    check(WisdomHolmanGradient);
    check(Aba10_6_4);
    check(Perturbation(BlanesMoanSrkn6b));
}

/// Runs that look at every step see the user's coordinates as well.
#[test]
fn adaptive_and_projected_runs() {
    let (system, start) = (Planets::system::<f64>(), Planets::initial(0.0));
    let mut exact = system.integrator(BceRkn17_8, 0.01, start);
    exact.advance(500).expect("no collision");
    let error = |state: State<[[f64; 2]; 3]>| distance(&flat(&state), &flat(&exact.state()));
    let mut adaptive = system.adaptive(Aba10_6_4, 1e-9, start);
    adaptive.advance_to(5.0).expect("no collision");
    assert!(error(adaptive.state()) < 1e-7, "{}", error(adaptive.state()));
    let mut processed = system.adaptive(WisdomHolmanGradient, 1e-9, start);
    processed.advance_to(5.0).expect("no collision");
    assert!(error(processed.state()) < 1e-7, "{}", error(processed.state()));
    let mut projected = system.integrator(Projection(Aba8_4, Energy), 0.05, start);
    let energy = projected.energy();
    projected.advance(100).expect("no collision");
    assert!((projected.energy() / energy - 1.0).abs() < 1e-14);
    assert!(error(projected.state()) < 1e-5, "{}", error(projected.state()));
}

/// The mass of a body may be so small that its attraction is lost in rounding. Its orbit is then the orbit of the limit.
#[test]
fn test_particles() {
    let with = |mass: f64| {
        let mut system = OUTER;
        system.m[5] = mass;
        let mut start = outer_planets::start();
        start.p[5] = Vector3::from(outer_planets::VELOCITIES[5]) * mass;
        let mut sim = system.integrator(Aba10_6_4, 400.0, start);
        sim.advance(500).expect("no collision");
        sim.state().q[5]
    };
    let limit = with(1e-30);
    assert!((with(1e-20) - limit).norm() < 1e-11 * limit.norm());
    assert!((with(1e-5) - limit).norm() > 1e-9 * limit.norm());
}

/// A motion without an orbit is refused with the reason. The state is the last good one.
#[test]
fn what_has_no_orbit_is_refused() {
    let (system, start) = (Planets::system::<f64>(), Planets::initial::<f64>(0.0));
    for body in 0..3 {
        let mut massless = system;
        massless.m[body] = 0.0;
        let mut sim = massless.integrator(WisdomHolman, 0.1, start);
        let expected = format!("division by zero: m[{body}]");
        let refused = sim.step();
        assert!(
            matches!(refused, Err(StepError { failure: Failure::OutsideDomain { what }, .. }) if what == expected),
            "{refused:?}"
        );
        assert_eq!(sim.state(), start);
    }
    let mut together = start;
    together.q[1] = together.q[0];
    let mut sim = system.integrator(Aba10_6_4, 0.1, together);
    assert!(matches!(sim.advance(10), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })));
    assert_eq!(sim.state(), together);
    // From rest, at distance 1, two bodies meet after π/√8 units of time.
    let pair = Planets { m: [1.0, 1e-3, 1e-30], g: 1.0 / 1.001, k: 0.0 };
    let rest = State::new([[0.0, 0.0], [1.0, 0.0], [0.0, 50.0]], [[0.0; 2]; 3]);
    let mut sim = pair.integrator(WisdomHolman, 0.05, rest);
    let refused = sim.advance(100);
    assert!(
        matches!(refused, Err(StepError { failure: Failure::Pole { piece: "Kepler's motion of q[1]" }, .. })),
        "{refused:?}"
    );
    assert_eq!(sim.steps(), 22);
    assert!(sim.state().q[1][0].is_finite() && sim.state().q[1][0] < 0.1);
}

/// A charge in a uniform field and a potential.
#[hamiltonian]
fn charge(q: [f64; 2], p: [f64; 2], m: f64, b: f64, k: f64) -> f64 {
    let [x, y] = q;
    ((p[0] + b * y).powi(2) + (p[1] - b * x).powi(2)) / (2.0 * m)
        + k * ((x.powi(4) + y.powi(4)) / 4.0 + x * x * y / 2.0)
}

#[test]
fn charges_gyrate() {
    let start = State::new([0.5, 0.3], [0.2, -0.4]);
    let free = Charge { m: 0.7, b: 1.3, k: 0.0 };
    // A circle, in one step: with ω = 2b/m the velocity turns by ωh.
    let mut sim = free.integrator(WisdomHolman, 2.3, start);
    sim.step().expect("a circle");
    let ([u, v], omega) = ([(0.2 + 1.3 * 0.3) / 0.7, (-0.4 - 1.3 * 0.5) / 0.7], 2.0 * 1.3 / 0.7);
    let (sin, cos) = (2.3_f64 * omega).sin_cos();
    let expected = [0.5 + (u * sin + v * (1.0 - cos)) / omega, 0.3 + (v * sin - u * (1.0 - cos)) / omega];
    assert!(sim.state().q.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-14), "{:?} {expected:?}", sim.state());
    // With a potential: orders of tables of all kinds, against a method that does not use A and B.
    let system = Charge { k: 0.4, ..free };
    let mut exact = system.integrator(Gauss::<6>, 0.005, start);
    exact.advance(400).expect("steps");
    fn order<M: Method<Charge>>(system: Charge, method: M, exact: &State<[f64; 2]>, start: State<[f64; 2]>) -> f64 {
        let error = |steps: u64| {
            let mut sim = system.integrator(method, 2.0 / steps as f64, start);
            sim.advance(steps).expect("steps");
            distance(&flat(&sim.state()), &flat(exact))
        };
        (error(64) / error(128)).log2()
    }
    let exact = exact.state();
    assert!((order(system, WisdomHolman, &exact, start) - 2.0).abs() < 0.2);
    assert!((order(system, Saba3Gradient, &exact, start) - 4.0).abs() < 0.3);
    assert!((order(system, Perturbation(BlanesMoanSrkn6b), &exact, start) - 4.0).abs() < 0.3);
}

/// A linear flow with rounded coefficients that stand beside 1 would change areas by the same number each time: the energy by 5e-16 a step.
#[test]
fn energies_of_oscillators_have_no_trend() {
    let system = Hardening { m: 1.0, k: 1.0, epsilon: 0.01 };
    for h in [0.3, 0.17] {
        let mut sim = system.integrator(Rnia10_8_6, h, State::new(0.9, 0.3));
        let energy = sim.energy();
        sim.advance(100_000).expect("no singularity");
        let change = sim.energy() / energy - 1.0;
        assert!(change.abs() < 3e-12, "h = {h}: {change:e}");
    }
}

/// A and B by name: the same as what is found by itself, and a part that is not found.
#[hamiltonian(split = "p * p / (2.0 * m) + k * q * q / 2.0 | epsilon * (q.powi(3) / 3.0 + q.powi(4) / 5.0)")]
fn hardening_by_hand(q: f64, p: f64, m: f64, k: f64, epsilon: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0 + epsilon * (q.powi(3) / 3.0 + q.powi(4) / 5.0)
}

#[test]
fn parts_by_name_are_those_that_are_found() {
    let (m, k, epsilon, start) = (1.7, 0.9, 0.2, State::new(0.9, 0.3));
    let mut found = Hardening { m, k, epsilon }.integrator(Aba8_6_4, 0.3, start);
    let mut named = HardeningByHand { m, k, epsilon }.integrator(Aba8_6_4, 0.3, start);
    found.advance(100).expect("no singularity");
    named.advance(100).expect("no singularity");
    assert!((found.state().q - named.state().q).abs() < 1e-13);
    assert!(Hardening::<f64>::REPORT.contains("A = p²/(2·m) + q²·k/2"), "{}", Hardening::<f64>::REPORT);
    // If the rest is zero, the step is exact.
    let mut free = Hardening { m, k, epsilon: 0.0 }.integrator(WisdomHolman, 20.0, start);
    free.step().expect("no singularity");
    let (sin, cos) = (20.0 * (k / m).sqrt()).sin_cos();
    assert!((free.state().q - (start.q * cos + start.p / (k * m).sqrt() * sin)).abs() < 1e-14);
}
