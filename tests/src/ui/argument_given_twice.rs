use geoint_runtime::prelude::*;

#[hamiltonian(q = x, q = p)]
fn energy(x: f64, p: f64) -> f64 {
    x * x + p * p
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
