use geoint_runtime::prelude::*;

#[hamiltonian(const N = 64, type Chain = [f64; 64])]
fn energy(q: [f64; N], p: Chain) -> f64 {
    (0..64).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
}

fn main() {}
