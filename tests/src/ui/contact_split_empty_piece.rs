use geoint_runtime::prelude::*;

#[contact_hamiltonian(split = "p * p / 2.0 + gamma * s || -q.cos()")]
fn swing(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 - q.cos() + gamma * s
}

fn main() {}
