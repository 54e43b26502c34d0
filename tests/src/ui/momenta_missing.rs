use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, v: f64) -> f64 {
    v * v + q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
