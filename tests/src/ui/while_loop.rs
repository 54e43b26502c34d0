use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let mut e = p * p;
    while e < 1.0 {
        e += q;
    }
    e
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
