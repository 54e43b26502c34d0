use geoint_runtime::prelude::*;

#[hamiltonian(damping = [0.1, -0.3])]
fn energy(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0] * q[0] * q[1]
}

fn main() {
    println!("{}", energy([0.5, 0.1], [1.0, 0.2]));
}
