use geoint_runtime::prelude::*;

#[hamiltonian(structure = canonical, require(separable))]
fn pendulum(x: [f64; 2]) -> f64 {
    x[1] * x[1] / 2.0 - x[0].cos()
}

fn main() {}
