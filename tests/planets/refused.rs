//! Orbits that end, and their error messages.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Three bodies in the plane.
#[hamiltonian(coordinates = jacobi)]
fn three(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], g: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
        for j in 0..i {
            energy -= g * m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
        }
    }
    energy
}

const START: State<[[f64; 2]; 3]> =
    State { t: 0.0, q: [[0.0, 0.0], [1.0, 0.0], [0.0, 3.0]], p: [[0.1, 0.0], [0.0, 0.8], [-0.2, 0.1]] };

fn refused<M: Method<Three>>(method: M, m: [f64; 3]) -> StepError {
    let mut sim = Three { m, g: 1.0 }.integrator(method, 0.01, START);
    let refused = sim.advance(10).expect_err("no coordinates");
    assert_eq!(sim.state(), START);
    refused
}

/// The central mass must not be negligible beside the body. Otherwise the error of the quotient m/η, with the sum η of masses, is 1/ε.
#[test]
fn masses_that_leave_no_digit_are_refused() {
    let lost = |sum: &str, mass: &str, found: StepError| {
        let expected =
            format!("coordinates in which no digit of {sum} is left beside {mass}; let heavy bodies come first");
        assert!(
            matches!(found, StepError { failure: Failure::OutsideDomain { what }, .. } if what == expected),
            "{found}"
        );
    };
    for m in [[1e-17, 1.0, 0.1], [-1e-30, 1.0, 1e-30]] {
        lost("m[0]", "m[1]", refused(WisdomHolman, m));
        lost("m[0]", "m[1]", refused(WisdomHolmanProcessed, m));
    }
    lost("m[0] + m[1]", "m[1]", refused(Aba8_4, [1.0, -1.0, 1.0]));
    lost("m[0] + m[1]", "m[2]", refused(Aba8_4, [1e-20, 1e-18, 1.0]));
    lost("m[2] + (m[0] + m[1])", "m[2]", refused(Saba2Gradient, [0.1, 0.2, -0.1 - 0.2]));
    // If the energy is undefined, the error says so.
    let zero = refused(WisdomHolman, [0.0, 1.0, 1.0]);
    assert!(
        matches!(zero, StepError { failure: Failure::OutsideDomain { what: "division by zero: m[0]" }, .. }),
        "{zero}"
    );
}

/// Negative masses, and a first body that is much lighter than others. The loss of digits is proportional to the mass ratio.
#[test]
fn masses_of_all_kinds() {
    for (m, bound) in [([1.0, -0.3, 0.1], 1e-12), ([-1.0, -0.3, -0.1], 1e-12), ([1e-6, 1.0, 1e-3], 1e-8)] {
        let system = Three { m, g: 1.0 };
        let start = State { p: std::array::from_fn(|i| START.p[i].map(|v| v * m[i])), ..START };
        let mut sim = system.integrator(Aba10_6_4, 0.001, start);
        sim.advance(500).expect("no collision");
        let mut exact = system.integrator(Gauss::<4>, 0.001, start);
        exact.advance(500).expect("no collision");
        for i in 0..3 {
            for d in 0..2 {
                let error = (sim.state().q[i][d] - exact.state().q[i][d]).abs();
                assert!(error < bound, "{m:?}, q[{i}][{d}]: {error:e}");
            }
        }
    }
}

/// After so many periods that no digit of the phase is known, the step is refused as a pole.
#[test]
fn orbits_without_end() {
    let system = Three { m: [1.0, 1e-3, 1e-30], g: 1.0 };
    let start = State { p: [[0.0; 2], [0.0, 1e-3], [-0.5e-30, 0.0]], ..START };
    for h in [1e17, -1e18, 1e100] {
        let mut sim = system.integrator(WisdomHolman, h, start);
        let refused = sim.step().expect_err("no digit is known");
        assert!(
            matches!(refused, StepError { failure: Failure::Pole { piece: "Kepler's motion of q[1]" }, .. }),
            "h = {h}: {refused}"
        );
        assert_eq!(sim.state(), start);
    }
    let mut sim = system.integrator(WisdomHolman, 1e12, start);
    sim.step().expect("a third of the digits");
}

/// From rest, at distance 1, two bodies meet after π/√8 units of time.
#[test]
fn a_collision_is_named_by_its_piece() {
    let system = Three { m: [1.0, 1e-3, 1e-30], g: 1.0 / 1.001 };
    let rest = State::new([[0.0, 0.0], [1.0, 0.0], [0.0, 50.0]], [[0.0; 2]; 3]);
    let mut sim = system.integrator(WisdomHolman, 0.05, rest);
    let refused = sim.advance(100);
    let expected = "Kepler's motion of q[1]";
    assert!(
        matches!(refused, Err(StepError { failure: Failure::Pole { piece }, .. }) if piece == expected),
        "{refused:?}"
    );
    assert_eq!(sim.steps(), 22);
    assert!(sim.state().q[1][0].is_finite() && sim.state().q[1][0] < 0.1);
}
