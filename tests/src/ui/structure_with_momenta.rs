use geoint_runtime::prelude::*;

#[hamiltonian(structure = canonical)]
fn pendulum(q: f64, p: f64) -> f64 {
    p * p / 2.0 - q.cos()
}

fn main() {}
