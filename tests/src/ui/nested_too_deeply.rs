use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    p * p + q.cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos()
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
