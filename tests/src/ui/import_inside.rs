use geoint_runtime::prelude::*;

mod outside {
    pub const STIFFNESS: f64 = 2.0;
}

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    use outside::STIFFNESS;
    p * p + STIFFNESS * q * q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
