use geoint_runtime::prelude::*;

fn square(x: f64) -> f64 {
    x * x
}

#[energy_function]
fn potential(q: f64) -> f64 {
    square(q)
}

#[hamiltonian(with(potential))]
fn energy(q: f64, p: f64) -> f64 {
    p * p + potential(q)
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
