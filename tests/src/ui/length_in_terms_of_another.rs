use geoint_runtime::prelude::*;

const N: usize = 2;
const M: usize = 2 * N;

#[hamiltonian(const M = 2 * N)]
fn energy(q: [f64; M], p: [f64; M]) -> f64 {
    (0..M).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
}

fn main() {
    println!("{}", energy([0.5; M], [1.0; M]));
}
