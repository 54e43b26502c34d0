use geoint_runtime::nalgebra::{Matrix2, Vector2};
use geoint_runtime::prelude::*;

#[hamiltonian]
fn coupled(q: Vector2<f64>, p: Vector2<f64>, k: f64) -> f64 {
    let stiffness = Matrix2::new(2.0 * k, -k, -k, k);
    p.norm_squared() / 2.0 + q.dot(&(stiffness * q)) / 2.0
}

fn main() {
    println!("{}", coupled(Vector2::zeros(), Vector2::zeros(), 1.0));
}
