use geoint_runtime::prelude::*;

/// (m, γ) are six numbers.
#[hamiltonian(structure = se3)]
fn top(x: [f64; 4]) -> f64 {
    x[0] * x[0] + x[3]
}

/// ∇C × ∇H is in space.
#[hamiltonian(structure = nambu(x[0] * x[1]))]
fn plane(x: [f64; 2]) -> f64 {
    x[0] * x[0] + x[1]
}

fn main() {}
