use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    p * p + (q as i32) as f64
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
