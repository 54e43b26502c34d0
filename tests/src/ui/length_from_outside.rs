use geoint_runtime::prelude::*;

const SIZE: usize = 3;

#[hamiltonian]
fn energy(q: [f64; SIZE], p: [f64; SIZE]) -> f64 {
    (0..SIZE).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
}

fn main() {
    println!("{}", energy([0.5; SIZE], [1.0; SIZE]));
}
