use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: [f64; 2000], p: [f64; 2000]) -> f64 {
    p[0] * p[0] + q[0] * q[0]
}

fn main() {
    println!("{}", energy([0.5; 2000], [1.0; 2000]));
}
