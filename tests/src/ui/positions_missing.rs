use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(x: f64, p: f64) -> f64 {
    p * p + x
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
