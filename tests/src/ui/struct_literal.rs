use geoint_runtime::prelude::*;

struct Point {
    x: f64,
}

#[hamiltonian]
fn energy(q: f64, p: f64) -> f64 {
    let point = Point { x: q };
    p * p + point.x
}

fn main() {
    println!("{}", energy(0.5, 1.0));
}
