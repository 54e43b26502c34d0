use geoint_runtime::prelude::*;

#[hamiltonian]
fn lagrangian(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 - m * q[1]
}

fn main() {
    println!("{}", lagrangian([0.5; 2], [1.0; 2], 2.0));
}
