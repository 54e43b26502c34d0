use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: String, p: String) -> f64 {
    p.len() as f64 + q.len() as f64
}

fn main() {}
