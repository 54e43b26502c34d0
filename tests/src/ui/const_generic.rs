use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy<const N: usize>(q: [f64; N], p: [f64; N]) -> f64 {
    (0..N).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
}

fn main() {
    println!("{}", energy([0.5; 3], [1.0; 3]));
}
