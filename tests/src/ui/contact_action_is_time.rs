use geoint_runtime::prelude::*;

#[contact_hamiltonian(s = t)]
fn swing(q: f64, p: f64, t: f64) -> f64 {
    p * p / 2.0 + q.cos() + 0.1 * t
}

fn main() {}
