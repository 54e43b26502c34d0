use geoint_runtime::prelude::*;

#[hamiltonian(structure = so3)]
fn free_body(x: [f64; 3]) -> [f64; 3] {
    [x[1] * x[2], -x[2] * x[0], 0.0]
}

fn main() {}
