use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64
where
    f64: Copy,
{
    p * p + q * q
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
