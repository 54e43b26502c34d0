use geoint_runtime::prelude::*;

#[hamiltonian(q = t)]
fn energy(t: f64, p: f64) -> f64 {
    p * p + t * t
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
