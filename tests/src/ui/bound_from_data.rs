use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64, n: usize) -> f64 {
    let mut e = p * p;
    for i in 0..n {
        e += q * i as f64;
    }
    e
}

fn main() {
    println!("{}", energy(0.5, 1.0, 2));
}
