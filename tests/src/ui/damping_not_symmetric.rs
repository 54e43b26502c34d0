use geoint_runtime::prelude::*;

#[hamiltonian(damping = [[c, c / 2.0], [c / 3.0, c]])]
fn energy(q: [f64; 2], p: [f64; 2], c: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0] * q[0] * q[1]
}

fn main() {
    println!("{}", energy([0.5, 0.1], [1.0, 0.2], 0.1));
}
