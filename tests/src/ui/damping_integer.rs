use geoint_runtime::prelude::*;

#[hamiltonian(damping = 1)]
fn energy(q: f64, p: f64) -> f64 {
    p * p / 2.0 + q * q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
