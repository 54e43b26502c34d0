use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    p * p / (2.0 * (1.0 - 1.0)) + q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
