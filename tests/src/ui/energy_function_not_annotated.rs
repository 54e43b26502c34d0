use geoint_runtime::prelude::*;

fn potential(q: f64) -> f64 {
    q * q
}

#[hamiltonian(with(potential))]
fn energy(q: f64, p: f64) -> f64 {
    p * p + potential(q)
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
