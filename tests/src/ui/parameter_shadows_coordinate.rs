use geoint_runtime::prelude::*;

#[hamiltonian(q = x, p = y)]
fn energy(x: f64, y: f64, q: f64) -> f64 {
    y * y + q * x
}

fn main() {
    println!("{}", energy(0.5, 1.0, 2.0));
}
