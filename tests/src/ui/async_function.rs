use geoint_runtime::prelude::*;

#[hamiltonian]
async fn energy(q: f64, p: f64) -> f64 {
    p * p + q
}

fn main() {
    let _ = energy(0.5, 1.0);
}
