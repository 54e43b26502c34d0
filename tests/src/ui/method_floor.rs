use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let cell = q.floor();
    p * p + cell * cell
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
