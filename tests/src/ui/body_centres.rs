use geoint_runtime::prelude::*;
use nalgebra::{UnitQuaternion, Vector3};

/// Momenta are missing.
#[hamiltonian(attitude = r)]
fn thrown(r: UnitQuaternion<f64>, m: Vector3<f64>, q: Vector3<f64>) -> f64 {
    m.norm_squared() + q.z + r.w
}

/// Two bodies have two centres.
#[hamiltonian(attitude = r)]
fn one_centre(r: [UnitQuaternion<f64>; 2], m: [Vector3<f64>; 2], q: Vector3<f64>, p: Vector3<f64>) -> f64 {
    m[0].norm_squared() + m[1].norm_squared() + p.norm_squared() + q.z + r[0].w
}

/// Rolling couples both momenta.
#[hamiltonian(attitude = r)]
fn rolling(r: UnitQuaternion<f64>, m: Vector3<f64>, q: Vector3<f64>, p: Vector3<f64>, mass: f64) -> f64 {
    m.norm_squared() / 2.0 + p.norm_squared() / (2.0 * mass) + m.x * p.y + q.z + r.w
}

fn main() {}
