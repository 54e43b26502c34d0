use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
use geoint_runtime::prelude::*;

#[hamiltonian(attitude = r)]
fn top(r: UnitQuaternion<f64>, l: Vector3<f64>) -> f64 {
    l.norm_squared() + r.w
}

fn main() {}
