use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64, t: [f64; 2]) -> f64 {
    p * p + q * t[0]
}

fn main() {
    println!("{}", energy(0.5, 1.0, [0.0; 2]));
}
