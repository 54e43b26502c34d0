use geoint_runtime::prelude::*;

#[hamiltonian]
unsafe fn energy(q: f64, p: f64) -> f64 {
    p * p + q * q
}

fn main() {}
