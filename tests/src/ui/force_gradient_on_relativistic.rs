use geoint_runtime::prelude::*;

#[hamiltonian]
fn relativistic(q: f64, p: f64) -> f64 {
    (1.0 + p * p).sqrt() + q * q / 2.0
}

fn main() {
    let _ = Relativistic.integrator(Chin4A, 0.01, State::new(0.5, 1.0));
}
