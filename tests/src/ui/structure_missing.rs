use geoint_runtime::prelude::*;

#[hamiltonian]
fn free_body(x: [f64; 3]) -> f64 {
    x[0] * x[0] + x[1] * x[1] / 2.0 + x[2] * x[2] / 3.0
}

fn main() {}
