use geoint_runtime::prelude::*;

#[hamiltonian(coordinates = jacobi)]
fn oscillator(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / q[0].hypot(q[1])
}

fn main() {}
