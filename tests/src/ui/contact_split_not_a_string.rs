use geoint_runtime::prelude::*;

#[contact_hamiltonian(split = p * p / 2.0)]
fn free(q: f64, p: f64, s: f64) -> f64 {
    p * p / 2.0 + q * s
}

fn main() {}
