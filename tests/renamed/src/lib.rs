//! Is the runtime found under the name that Cargo.toml gives it?

use physics::prelude::*;

/// A spring.
#[hamiltonian]
pub fn spring(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k * q.powi(4)
}

/// A spring in honey.
#[contact_hamiltonian]
pub fn honey(q: f64, p: f64, s: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k * q.powi(4) + 0.3 * s
}

#[test]
fn steps_are_made() -> Result<(), StepError> {
    let mut sim = Spring { m: 1.3, k: 0.7 }.integrator(DiscreteGradient, 0.1, State::new(1.0, 0.0));
    sim.advance(100)?;
    assert!((sim.energy() - 0.7).abs() < 1e-14);
    let mut sim = Honey { m: 1.3, k: 0.7 }.integrator(ContactSplitting, 0.1, ContactState::new(1.0, 0.0, 0.0));
    sim.advance(100)
}
