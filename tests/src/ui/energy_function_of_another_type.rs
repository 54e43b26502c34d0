use geoint_runtime::prelude::*;

#[energy_function]
fn potential(q: f64) -> f64 {
    (q as f32).sin() as f64
}

#[hamiltonian(with(potential))]
fn energy(q: f64, p: f64) -> f64 {
    p * p + potential(q)
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
