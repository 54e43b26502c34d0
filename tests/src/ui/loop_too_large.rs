use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let mut e = p * p;
    for i in 0..20_000 {
        e += (q * i as f64).cos();
    }
    e
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
