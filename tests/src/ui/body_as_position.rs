use geoint_runtime::nalgebra::UnitQuaternion;
use geoint_runtime::prelude::*;

#[hamiltonian]
fn top(q: UnitQuaternion<f64>, p: UnitQuaternion<f64>) -> f64 {
    p.w * p.w + q.w * q.w
}

fn main() {}
