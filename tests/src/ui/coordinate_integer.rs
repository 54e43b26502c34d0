use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: i64, p: i64) -> f64 {
    p as f64 + q as f64
}

fn main() {
    println!("{}", energy(0, 1));
}
