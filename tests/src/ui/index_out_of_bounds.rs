use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: [f64; 3], p: [f64; 3]) -> f64 {
    (0..3).map(|i| p[i] * p[i] + (q[i + 1] - q[i]).powi(2)).sum()
}

fn main() {}
