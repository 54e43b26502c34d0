use geoint_runtime::prelude::*;

#[contact_hamiltonian(split = "p * p / (2.0 * m) | gamma * s")]
fn weak(q: f64, p: f64, s: f64, m: f64, gamma: f64, big: f64) -> f64 {
    p * p / (2.0 * m) + gamma * s - 6.674e-11 * big * q.cos()
}

fn main() {}
