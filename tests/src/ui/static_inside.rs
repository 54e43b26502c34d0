use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    static STIFFNESS: f64 = 2.0;
    p * p + STIFFNESS * q * q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
