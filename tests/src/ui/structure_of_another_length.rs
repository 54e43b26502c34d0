use geoint_runtime::prelude::*;

#[hamiltonian(structure = so3)]
fn four(x: [f64; 4]) -> f64 {
    x[0] * x[1] + x[2] * x[3]
}

#[hamiltonian(structure = [[0.0, 1.0], [-1.0, 0.0]])]
fn three(x: [f64; 3]) -> f64 {
    x[0] * x[1] + x[2]
}

#[hamiltonian(structure = nambu(x[0]))]
fn two(x: [f64; 2]) -> f64 {
    x[0] * x[1]
}

fn main() {}
