use geoint_runtime::prelude::*;

use geoint_runtime::nalgebra::Vector2;

#[hamiltonian]
fn energy(q: Vector2<f64>, p: [f64; 2]) -> f64 {
    p[0] * p[0] + p[1] * p[1] + q.x + q.y
}

fn main() {}
