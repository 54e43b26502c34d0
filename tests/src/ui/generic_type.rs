use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy<T: Into<f64>>(q: T, p: T) -> f64 {
    0.5 * p.into().powi(2) + q.into()
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
