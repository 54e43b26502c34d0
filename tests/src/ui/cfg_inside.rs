use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    #[cfg(debug_assertions)]
    let q = 2.0 * q;
    p * p + q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
