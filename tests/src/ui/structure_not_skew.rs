use geoint_runtime::prelude::*;

#[hamiltonian(structure = [[0.0, x[0] * x[1]], [x[0] * x[1], 0.0]])]
fn species(x: [f64; 2]) -> f64 {
    x[0] + x[1]
}

#[hamiltonian(structure = [[x[0], 1.0], [-1.0, 0.0]])]
fn leaking(x: [f64; 2]) -> f64 {
    x[0] * x[0] + x[1] * x[1]
}

fn main() {}
