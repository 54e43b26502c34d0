use geoint_runtime::prelude::*;

#[hamiltonian(m = l)]
fn top(q: f64, p: f64, l: f64) -> f64 {
    p * p / (2.0 * l) + q * q
}

fn main() {}
