use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64, g: f32) -> f64 {
    p * p + q + f64::from(g)
}

fn main() {
    println!("{}", energy(0.5, 1.0, 2.0));
}
