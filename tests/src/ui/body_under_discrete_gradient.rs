use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
use geoint_runtime::prelude::*;

#[hamiltonian(attitude = r)]
fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, i: f64) -> f64 {
    m.norm_squared() / (2.0 * i) + r.w * r.k
}

fn main() {
    let start = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.1, 0.2, 0.3));
    let _ = Top { i: 1.0 }.integrator(DiscreteGradient, 0.1, start);
}
