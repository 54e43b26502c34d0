use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let n = 3;
    p * p + n
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
