//! A library with one function, which advances a pendulum by one method. The ledger counts the bytes of its machine code.

use geoint_runtime::prelude::*;

/// Planar pendulum.
#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}

/// Returns angle and momentum after `steps` steps of Verlet's method.
///
/// Errors: the steps of a pendulum with mass and length zero are not finite.
pub fn advance([q, p]: [f64; 2], [m, l, g]: [f64; 3], h: f64, steps: u64) -> Result<[f64; 2], StepError> {
    let mut run = Pendulum { m, l, g }.integrator(StormerVerlet, h, State::new(q, p));
    run.advance(steps)?;
    let State { q, p, .. } = run.state();
    Ok([q, p])
}
