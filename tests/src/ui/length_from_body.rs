use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: [f64; N], p: [f64; N]) -> f64 {
    const N: usize = 3;
    (0..N).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
}

fn main() {}
