use geoint_runtime::prelude::*;

#[energy_function]
fn legendre(n: u32, x: f64) -> f64 {
    if n == 0 { 1.0 } else { x * legendre(n - 1, x) }
}

#[hamiltonian(with(legendre))]
fn energy(q: f64, p: f64) -> f64 {
    p * p + legendre(2, q)
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
