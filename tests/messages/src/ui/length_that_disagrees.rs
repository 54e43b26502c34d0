use geoint_runtime::prelude::*;

const N: usize = 3;

#[hamiltonian(const N = 4)]
fn energy(q: [f64; N], p: [f64; N]) -> f64 {
    (0..N).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
}

fn main() {
    println!("{}", energy([0.5; N], [1.0; N]));
}
