use geoint_runtime::prelude::*;

const G: f64 = 9.81;

#[hamiltonian(const G = 9.81)]
fn energy(q: f64, p: f64) -> f64 {
    p * p + G * q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
