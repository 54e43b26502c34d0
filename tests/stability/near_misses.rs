//! Controls: a step near a pole that does not cross the pole is accepted.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Hamiltonian, Method};

#[hamiltonian]
fn kepler(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - m / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// The same with a denominator of which the structure says nothing.
#[hamiltonian]
fn expanded(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    let [x, y] = [q[0] + 1.0, q[1]];
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - m / (x * x - 2.0 * x + 1.0 + y * y).sqrt()
}

#[hamiltonian]
fn single(q: [f32; 2], p: [f32; 2], m: f32) -> f32 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - m / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

#[hamiltonian]
fn charges(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3]) -> f64 {
    let mut h = 0.0;
    for i in 0..3 {
        h += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
        for j in 0..i {
            h += m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
        }
    }
    h
}

/// Returns 1 if a run is refused because of a pole, else 0.
fn poles<S: Hamiltonian, M: Method<S>>(system: S, method: M, h: f64, start: State<S::Coordinates>, steps: u64) -> u32 {
    let mut sim = system.integrator(method, h, start);
    match sim.advance(steps) {
        Err(StepError { failure: Failure::OutsideDomain { what }, .. }) if what.contains("a pole between") => 1,
        _ => 0,
    }
}

/// Returns a generator of numbers between 0 and 1. The sequence is the same in every run.
fn random() -> impl FnMut() -> f64 {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Starts at the apocentre of an ellipse of eccentricity e. The steps are long, so a single step passes the pericentre.
#[test]
fn eccentric_orbits_pass() {
    let mut runaways = 0;
    for e in [0.5, 0.9, 0.99, 0.999, 1.0 - 1e-6] {
        for h in [0.001, 0.01, 0.1, 0.5, 1.5] {
            let v = ((1.0 - e) / (1.0_f64 + e)).sqrt();
            let (q, p) = ([1.0 + e, 0.0], [0.0, 1.3 * v]);
            let start = State::new(q, p);
            let refused = poles(Kepler { m: 1.3 }, DiscreteGradient, h, start, 2000)
                + poles(Kepler { m: 1.3 }, ImplicitMidpoint, h, start, 2000)
                + poles(Expanded { m: 1.3 }, DiscreteGradient, h, start, 2000);
            assert_eq!(refused, 0, "e = {e}, h = {h}");
            runaways += poles(Kepler { m: 1.3 }, Gonzalez, h, start, 500);
            let start = State::new(q.map(|x| x as f32), p.map(|x| x as f32));
            let mut sim = Single { m: 1.3 }.integrator(DiscreteGradient, h as f32, start);
            let outcome = sim.advance(2000);
            let pole = matches!(outcome, Err(StepError { failure: Failure::OutsideDomain { what }, .. }) if what.contains("a pole between"));
            assert!(!pole, "f32: e = {e}, h = {h}: {outcome:?}");
        }
    }
    // An iteration that does not converge may run away over the pole. The error then names the pole.
    assert!(runaways <= 3, "{runaways}");
}

/// Radial orbits go through the centre, so they are refused.
#[test]
fn radial_orbits_do_not() {
    for h in [0.01, 0.07, 0.3, 1.0] {
        for angle in [0.0, 0.4_f64, 2.0] {
            let q = [angle.cos(), angle.sin()];
            let start = State::new(q, [0.0, 0.0]);
            let mut sim = Kepler { m: 1.3 }.integrator(DiscreteGradient, h, start);
            while sim.steps() < 500 && sim.step().is_ok() {
                let [x, y] = sim.state().q;
                // A rounding error may put the orbit beside the line, so it may pass the centre.
                assert!(x * q[0] + y * q[1] > 0.0 || angle != 0.0, "h = {h}: {:?}", sim.state());
            }
            let start = State::new([1.0_f32, 0.0], [0.0, 0.0]);
            let mut sim = Single { m: 1.3 }.integrator(ImplicitMidpoint, h as f32, start);
            while sim.steps() < 500 && sim.step().is_ok() {
                assert!(sim.state().q[0] > 0.0, "f32, h = {h}: {:?}", sim.state());
            }
        }
    }
}

#[test]
fn random_encounters_pass() {
    let mut random = random();
    let mut between = |a: f64, b: f64| a + (b - a) * random();
    for _ in 0..if cfg!(debug_assertions) { 50 } else { 150 } {
        let q = [0; 3].map(|_| [between(-1.0, 1.0), between(-1.0, 1.0)]);
        let p = [0; 3].map(|_| [between(-2.0, 2.0), between(-2.0, 2.0)]);
        let (m, h) = ([0; 3].map(|_| between(0.1, 2.0)), between(0.01, 0.5));
        let start = State::new(q, p);
        let refused = poles(Charges { m }, DiscreteGradient, h, start, 200)
            + poles(Charges { m }, ImplicitMidpoint, h, start, 200);
        assert_eq!(refused, 0, "{start:?}, m = {m:?}, h = {h}");
        // Fast orbits in a plane.
        let start = State::new(q[0], p[0]);
        let refused = poles(Kepler { m: 1.3 }, DiscreteGradient, h, start, 500)
            + poles(Kepler { m: 1.3 }, Gauss::<2>, h, start, 500)
            + poles(Expanded { m: 1.3 }, ImplicitMidpoint, h, start, 500);
        assert_eq!(refused, 0, "{start:?}, h = {h}");
    }
}
