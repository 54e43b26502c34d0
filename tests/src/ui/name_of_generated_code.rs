use geoint_runtime::prelude::*;

#[contact_hamiltonian]
fn state(q: f64, p: f64, s: f64) -> f64 {
    p * p / 2.0 - q.cos() + 0.1 * s
}

fn main() {}
