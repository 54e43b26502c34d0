use geoint_runtime::nalgebra::Vector3;
use geoint_runtime::prelude::*;

#[hamiltonian(attitude = r)]
fn top(r: [f64; 4], m: Vector3<f64>) -> f64 {
    m.norm_squared() + r[0]
}

fn main() {}
