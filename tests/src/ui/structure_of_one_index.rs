use geoint_runtime::prelude::*;

#[hamiltonian(structure = |i| gamma[i])]
fn vortices(x: [f64; 4], gamma: [f64; 4]) -> f64 {
    x.iter().map(|x| x * x).sum()
}

/// A row is too short.
#[hamiltonian(structure = [[0.0, 1.0], [-1.0]])]
fn swing(x: [f64; 2]) -> f64 {
    x[1] * x[1] / 2.0 - x[0].cos()
}

fn main() {}
