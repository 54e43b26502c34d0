use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
use geoint_runtime::prelude::*;

#[hamiltonian(attitude = r, damping = 0.1)]
fn top(r: UnitQuaternion<f64>, m: Vector3<f64>) -> f64 {
    m.norm_squared() + r.w
}

fn main() {}
