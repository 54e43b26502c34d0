use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
use geoint_runtime::prelude::*;

#[hamiltonian(attitude = r)]
fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, t: f64) -> f64 {
    m.norm_squared() / (2.0 + t.sin()) + r.k
}

fn main() {}
