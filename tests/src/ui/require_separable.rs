use geoint_runtime::prelude::*;

#[hamiltonian(require(separable))]
fn energy(q: f64, p: f64, m: f64, k: f64, b: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0 + b * q * p
}

fn main() {
    println!("{}", energy(0.5, 1.0, 1.0, 1.0, 1.0));
}
