use geoint_runtime::prelude::*;

#[hamiltonian]
fn oscillator(q: f64, p: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0
}

fn main() {
    let _ = Oscillator.integrator(StormerVerlet, 0.01, State::new([0.5], [1.0]));
}
