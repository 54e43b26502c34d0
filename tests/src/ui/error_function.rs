use geoint_runtime::prelude::*;

fn erf(x: f64) -> f64 {
    x.tanh()
}

#[hamiltonian]
fn screened(q: f64, p: f64) -> f64 {
    p * p / 2.0 + erf(q) / q
}

fn main() {
    println!("{}", screened(0.5, 1.0));
}
