//! Orbits that end, and what is said of them.

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

/// From rest, at distance 1, two bodies meet after π/√8 units of time.
#[test]
fn a_collision_is_named_by_its_piece() {
    let system = Three { m: [1.0, 1e-3, 1e-30], g: 1.0 / 1.001 };
    let rest = State::new([[0.0, 0.0], [1.0, 0.0], [0.0, 50.0]], [[0.0; 2]; 3]);
    let mut sim = system.integrator(WisdomHolman, 0.05, rest);
    let refused = sim.advance(100);
    let expected = "Kepler's motion of q[1]";
    assert!(matches!(refused, Err(StepError::Pole { piece, .. }) if piece == expected), "{refused:?}");
    assert_eq!(sim.steps(), 22);
    assert!(sim.state().q[1][0].is_finite() && sim.state().q[1][0] < 0.1);
}
