use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
use geoint_runtime::prelude::*;

#[hamiltonian(attitude = r)]
fn tops(r: [UnitQuaternion<f64>; 2], m: [Vector3<f64>; 2], i: f64) -> f64 {
    (m[0].norm_squared() + m[1].norm_squared()) / (2.0 * i) + m[0].dot(&m[1]) + (r[0].inverse() * r[1]).w
}

fn main() {}
