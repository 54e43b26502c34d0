use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64, #[cfg(any())] k: f64) -> f64 {
    p * p + q * q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
