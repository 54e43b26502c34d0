use geoint_runtime::prelude::*;

#[contact_hamiltonian(split = "p * p / 2.0 | gamma * s")]
fn wall(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 + gamma * s + if q < 0.0 { 100.0 * q * q } else { 0.0 }
}

fn main() {}
