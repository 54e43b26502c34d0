use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let mut x = [q, p];
    x[0] = 2.0 * q;
    x[0] * x[1]
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
