use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64, (x, y): (f64, f64)) -> f64 {
    p * p + q * x + y
}

fn main() {
    println!("{}", energy(0.5, 1.0, (0.0, 0.0)));
}
