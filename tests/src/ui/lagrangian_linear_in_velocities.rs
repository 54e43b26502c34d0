use geoint_runtime::prelude::*;

#[lagrangian]
fn odd(q: [f64; 3], v: [f64; 3]) -> f64 {
    q[1] * v[0] - q[2] * v[1] - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
}

#[lagrangian]
fn total_derivative(q: [f64; 2], v: [f64; 2]) -> f64 {
    q[1] * v[0] + q[0] * v[1] - (q[0] * q[0] + q[1] * q[1])
}

#[lagrangian]
fn singular(q: [f64; 4], v: [f64; 4]) -> f64 {
    (q[1] + q[3]) * v[0] + (q[1] + q[3]) * v[2] - q[0] * q[0] - q[2] * q[3]
}

#[lagrangian]
fn timed(q: [f64; 2], v: [f64; 2], t: f64) -> f64 {
    (1.0 + t) * q[1] * v[0] - (q[0] * q[0] + q[1] * q[1])
}

#[lagrangian(rayleigh = v[0] * v[0], require(separable))]
fn rubbed(q: [f64; 2], v: [f64; 2]) -> f64 {
    q[1] * v[0] - (q[0] * q[0] + q[1] * q[1])
}

fn main() {}
