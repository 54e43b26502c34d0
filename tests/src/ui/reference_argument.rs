use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: &[f64; 3], p: &[f64; 3]) -> f64 {
    p[0] * p[0] + q[0] + q[1] + q[2]
}

fn main() {
    println!("{}", energy(&[0.5; 3], &[1.0; 3]));
}
