use geoint_runtime::prelude::*;

#[hamiltonian(damping = 0.1 * swell)]
fn energy(q: f64, p: f64) -> f64 {
    let swell = 1.0 + q * q;
    p * p / 2.0 + q * q * swell
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
