use geoint_runtime::prelude::*;

#[hamiltonian(damping = c)]
fn shock(q: f64, p: f64, c: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0
}

fn main() {
    Shock { c: 0.1 }.integrator(StormerVerlet, 0.01, State::new(0.5, 1.0));
}
