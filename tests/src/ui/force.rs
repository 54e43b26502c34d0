use geoint_runtime::prelude::*;

#[hamiltonian(force = [1.0, 2.0, 3.0])]
fn wrong_length(q: [f64; 2], p: [f64; 2]) -> f64 {
    p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + q[1] * q[1]
}

#[hamiltonian(force = -v)]
fn taken(q: f64, p: f64, v: f64) -> f64 {
    p * p + v * q * q
}

#[lagrangian(force = t.cos(), require(conservative))]
fn required(q: f64, v: f64, t: f64) -> f64 {
    v * v - q * q
}

#[hamiltonian(force = -v * v.abs())]
fn kicked(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.powi(4)
}

fn main() {
    let _ = Kicked { m: 1.0 }.integrator(StormerVerlet, 0.1, State::new(1.0, 0.0)).advance(1);
}
