use geoint_runtime::prelude::*;

#[hamiltonian(require(symplectic))]
fn energy(q: f64, p: f64) -> f64 {
    p * p + q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
