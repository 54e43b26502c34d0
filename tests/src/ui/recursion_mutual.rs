use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    fn even(x: f64) -> f64 {
        if x < 1.0 { x } else { odd(x - 1.0) }
    }
    fn odd(x: f64) -> f64 {
        if x < 1.0 { -x } else { even(x - 1.0) }
    }
    p * p + even(q)
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
