use geoint_runtime::prelude::*;

mod math {
    pub fn sqrt(x: f64) -> f64 {
        x.sqrt()
    }
}

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    p * p / 2.0 + math::sqrt(1.0 + q * q)
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
