use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let Some(x) = Some(q) else { return 0.0 };
    p * p + x * x
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
