use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    fn power(x: f64, n: i32) -> f64 {
        if n == 0 { 1.0 } else { x * power(x, n - 1) }
    }
    power(p, 2) + power(q, 4)
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
