use geoint_runtime::prelude::*;

#[hamiltonian(q = p)]
fn energy(p: f64, x: f64) -> f64 {
    p * p + x
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
