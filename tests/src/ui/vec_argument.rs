use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64, weights: Vec<f64>) -> f64 {
    p * p + weights.iter().sum::<f64>() * q
}

fn main() {
    println!("{}", energy(0.5, 1.0, vec![1.0]));
}
