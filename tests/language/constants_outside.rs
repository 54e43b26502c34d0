//! Constants outside of the function, with the names that the standard library uses too.
use geoint_runtime::prelude::*;
use std::f64::consts::PI;

const E: f64 = 210.0;
const R: f64 = 8.314;
const H: f64 = 0.5;
const N: i32 = 7;
const MASSES: [f64; 2] = [1.5, 2.5];
const COUPLING: [[f64; 2]; 2] = [[1.0, 0.25], [0.25, 3.0]];

mod consts {
    pub(crate) const TAU: f64 = 0.125;
}

#[hamiltonian]
fn rods(q: [f64; 2], p: [f64; 2]) -> f64 {
    const SOFTENING: f64 = 2.0 * E;
    let mut e = 0.0;
    for i in 0..2 {
        e += p[i] * p[i] / (2.0 * MASSES[i]);
        for j in 0..2 {
            e += COUPLING[i][j] * q[i] * q[j];
        }
    }
    e + PI * q[0].cos()
        + E * R * q[1].sin()
        + H * consts::TAU * q[0]
        + (N / 2) as f64 * q[1]
        + SOFTENING
        + std::f64::consts::E
        + f64::EPSILON
}

#[hamiltonian]
fn inside(q: f64, p: f64) -> f64 {
    use std::f64::consts::{E, TAU};
    const G: f64 = 9.81;
    p * p * E + (TAU * q).cos() * G
}

#[test]
fn compiles_and_means_what_it_says() {
    let (q, p) = ([0.3, -0.4], [0.5, 0.6]);
    assert!((Rods.energy(&State::new(q, p)) - rods(q, p)).abs() < 1e-11);
    assert!((Inside.energy(&State::new(0.3, 0.5)) - inside(0.3, 0.5)).abs() < 1e-13);
}
