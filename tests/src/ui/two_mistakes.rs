use geoint_runtime::prelude::*;

fn potential(q: f64) -> f64 {
    q * q
}

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let x = q.floor();
    let y = potential(p);
    x + y
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
