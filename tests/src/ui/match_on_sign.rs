use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    p * p
        + match q > 0.0 {
            true => q,
            false => -q,
        }
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
