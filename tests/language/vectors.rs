//! Vectors of nalgebra: as coordinates, as parameters, in arrays.
use geoint_runtime::nalgebra::{self, SVector, Vector2, Vector3};
use geoint_runtime::prelude::*;

#[hamiltonian]
fn charge(q: Vector3<f64>, p: Vector3<f64>, field: nalgebra::Vector3<f64>) -> f64 {
    let kinetic = p - field.cross(&q) * 0.5;
    0.5 * kinetic.norm_squared() + 1.0 / q.norm() + q.x * field[2]
}

#[hamiltonian]
fn plane(q: Vector2<f64>, p: Vector2<f64>) -> f64 {
    let tilt = Vector2::new(0.5, -1.0);
    p.dot(&p) / 2.0 + (q / 2.0).norm_squared() - tilt.dot(&q) + (-q).y
}

#[hamiltonian]
fn long(q: SVector<f64, 5>, p: SVector<f64, 5>) -> f64 {
    0.5 * p.norm_squared() + q.iter().map(|x| x.powi(4)).sum::<f64>()
}

#[hamiltonian]
fn bodies(q: [Vector2<f64>; 3], p: [Vector2<f64>; 3], m: [f64; 3]) -> f64 {
    let mut e = 0.0;
    for i in 0..3 {
        e += p[i].norm_squared() / (2.0 * m[i]);
        for j in 0..i {
            e -= m[i] * m[j] / (q[i] - q[j]).norm();
        }
    }
    e
}

#[hamiltonian]
fn nested(q: [[f64; 2]; 2], p: [[f64; 2]; 2]) -> f64 {
    let mut e = 0.0;
    for (x, v) in q.iter().zip(&p) {
        e += 0.5 * (v[0] * v[0] + v[1] * v[1]) + x[0].powi(2) * x[1].powi(2);
    }
    e
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-13 * a.abs().max(1.0), "{a} {b}");
}

#[test]
fn compiles_and_means_what_it_says() {
    let (q, p, b) = (Vector3::new(0.3, 0.4, -0.5), Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.1, 0.2, 0.7));
    close(Charge { field: b }.energy(&State::new(q, p)), charge(q, p, b));
    let (q, p) = (Vector2::new(0.3, 0.4), Vector2::new(1.0, 2.0));
    close(Plane.energy(&State::new(q, p)), plane(q, p));
    let (q, p) = (SVector::from([0.1, 0.2, 0.3, 0.4, 0.5]), SVector::from([1.0; 5]));
    close(Long.energy(&State::new(q, p)), long(q, p));
    let q = [Vector2::new(0.0, 0.0), Vector2::new(1.0, 0.5), Vector2::new(-1.0, 2.0)];
    let (p, m) = ([Vector2::new(0.1, 0.2); 3], [1.0, 2.0, 3.0]);
    close(Bodies { m }.energy(&State::new(q, p)), bodies(q, p, m));
    let (q, p) = ([[0.1, 0.2], [0.3, 0.4]], [[1.0, 2.0], [3.0, 4.0]]);
    close(Nested.energy(&State::new(q, p)), nested(q, p));
    Bodies { m }.integrator(StormerVerlet, 0.01, State::new(Bodies::START.0, Bodies::START.1));
}

impl Bodies {
    const START: ([Vector2<f64>; 3], [Vector2<f64>; 3]) =
        ([Vector2::new(0.0, 0.0), Vector2::new(1.0, 0.5), Vector2::new(-1.0, 2.0)], [Vector2::new(0.0, 0.0); 3]);
}
