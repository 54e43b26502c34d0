use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> i32 {
    (p * p + q) as i32
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
