use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
use geoint_runtime::prelude::*;

#[hamiltonian(attitude = r)]
fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, i: f64) -> f64 {
    m.norm_squared() / (2.0 * i) + 0.1 * m.x.powi(4) + r.k
}

fn main() {}
