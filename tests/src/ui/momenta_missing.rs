use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, w: f64) -> f64 {
    w * w + q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
