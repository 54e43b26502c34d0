use geoint_runtime::prelude::*;

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    fn square<T: Copy + std::ops::Mul<Output = T>>(x: T) -> T {
        x * x
    }
    square(p) + square(q)
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
