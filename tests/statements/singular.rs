//! S63: singular contact systems. L = p·q' − H(q, p) − γs is linear in the velocities of its coordinates q and p, and does not read p'. Its solutions are
//! those of the contact Hamiltonian H + γs, and its action is stationary under independent variations of q and p.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::extrapolated;
use geoint_tests::scenes::contact_field;
use std::f64::consts::PI;

/// Two vortices near a wall, by distance and difference of heights, with friction.
#[contact_hamiltonian]
fn vortices(q: f64, p: f64, s: f64, strength: f64, gamma: f64) -> f64 {
    strength * (1.0 + q * q + p * p).ln() + 0.2 * q * p * p + gamma * s
}

const SYSTEM: Vortices = Vortices { strength: 1.3, gamma: 0.25 };
/// Duration of the variation.
const T: f64 = 2.0;
const START: [f64; 3] = [0.7, -0.4, 0.1];

/// Returns s(T) along the solution of `along`, with q varied by ε sin(πt/T) and p by ε cos 3t. L is that of [`SYSTEM`].
fn action(along: Vortices, epsilon: f64) -> f64 {
    let field = |t: f64, x: &[f64]| {
        let mut rate = contact_field(&along, t, &x[..3]);
        let w = PI / T;
        let (q, p) = (x[0] + epsilon * (w * t).sin(), x[1] + epsilon * (3.0 * t).cos());
        let speed = rate[0] + epsilon * w * (w * t).cos();
        rate.push(p * speed - SYSTEM.energy(&ContactState::at(t, q, p, x[3])));
        rate
    };
    let [q, p, s] = START;
    extrapolated(field, 0.0, vec![q, p, s, s], T, 8)[3]
}

#[test]
fn an_action_that_is_linear_in_velocities_is_stationary() {
    let changes = |along: Vortices| [0.1, 0.05, 0.025].map(|e| action(along, e) - action(along, 0.0));
    let ratios = |changes: [f64; 3]| [changes[0] / changes[1], changes[1] / changes[2]];
    let [first, second] = ratios(changes(SYSTEM));
    assert!((first - 4.0).abs() < 0.3 && (second - 4.0).abs() < 0.15, "{first} {second}");
    // Control: along the motion without friction the change is linear in ε.
    let [_, control] = ratios(changes(Vortices { gamma: 0.0, ..SYSTEM }));
    assert!((control - 2.0).abs() < 0.5, "{control}");
}

/// q' = ∂H/∂p and p' = −∂H/∂q − γp are both Euler–Lagrange equations: of p, and of q. Methods for contact Hamiltonians solve them.
#[test]
fn singular_contact_systems_are_contact_hamiltonians() -> Result<(), StepError> {
    let [q, p, s] = START;
    let exact = extrapolated(|t, x| contact_field(&SYSTEM, t, x), 0.0, vec![q, p, s], T, 16);
    let mut sim = SYSTEM.integrator(ContactGauss::<4>, 0.1, ContactState::new(q, p, s));
    sim.advance(20)?;
    let ContactState { q, p, s, .. } = sim.state();
    let error = [q - exact[0], p - exact[1], s - exact[2]].map(f64::abs);
    assert!(error.iter().all(|error| *error < 1e-10), "{error:?}");
    Ok(())
}
