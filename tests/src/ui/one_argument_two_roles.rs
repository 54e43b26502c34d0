use geoint_runtime::prelude::*;

#[hamiltonian(q = p, p = p)]
fn energy(p: f64) -> f64 {
    p * p
}

fn main() {
    println!("{}", energy(0.5));
}
