use geoint_runtime::prelude::*;

#[hamiltonian(split = "p[0] * p[0] / 2.0 | (q[0] * p[1]).cos() * q[1].cosh()")]
fn tangle(q: [f64; 2], p: [f64; 2]) -> f64 {
    p[0] * p[0] / 2.0 + (q[0] * p[1]).cos() * q[1].cosh()
}

fn main() {}
