//! How short is a complete program? A pendulum whose energy stays constant to rounding.

use geoint_runtime::prelude::*;

/// Planar pendulum; q in rad, p in kg m²/s.
#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}

fn main() -> Result<(), StepError> {
    println!("{}", Pendulum::REPORT);

    let system = Pendulum { m: 1.0, l: 1.0, g: 9.81 };
    let mut sim = system.integrator(DiscreteGradient, 0.01, State::new(2.0, 0.0));
    let start = sim.energy();
    sim.advance(100_000)?;
    println!("relative energy error {:.1e}", (sim.energy() - start) / start);
    Ok(())
}
