use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) {
    let _ = p * p + q;
}

fn main() {
    energy(0.5, 1.0);
}
