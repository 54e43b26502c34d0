use geoint_runtime::prelude::*;

#[hamiltonian(require(separable, quadratic_kinetic))]
fn energy(q: f64, p: f64, m: f64, k: f64) -> f64 {
    let kinetic = (m * m + p * p).sqrt();
    kinetic + k * q * q / 2.0
}

fn main() {
    println!("{}", energy(0.5, 1.0, 1.0, 1.0));
}
