use geoint_runtime::nalgebra::UnitQuaternion;
use geoint_runtime::prelude::*;

#[hamiltonian(attitude = r)]
fn tops(r: [UnitQuaternion<f64>; 2], m: [f64; 6]) -> f64 {
    m[0] * m[0] + r[0].w + r[1].w
}

fn main() {}
