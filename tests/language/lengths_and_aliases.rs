//! Lengths by constants of the file, and names for types: the attribute repeats what they are.
#![deny(warnings)]

use geoint_runtime::nalgebra::{SVector, Vector2};
use geoint_runtime::prelude::*;

const N: usize = 4;
const M: usize = 2 * N - 3;
const POWER: i32 = -2;

type Real = f64;
type Plane = Vector2<Real>;
type Chain = [Real; N];

/// The constant in types, bounds, indices, powers and casts.
#[hamiltonian(const N = 4, const POWER: i32 = -2)]
fn ring(q: [f64; N], p: [f64; N], m: [f64; N], k: f64) -> f64 {
    let mut e = 0.0;
    for i in 0..N {
        e += p[i] * p[i] / (2.0 * m[i]) + k * (2.0 + q[(i + 1) % N] - q[i]).powi(POWER);
    }
    e + q[N - 1].powi(4) / N as f64
}

/// Lengths that are computed, in vectors of nalgebra too.
#[hamiltonian(const N = 4, const M = 2 * N - 3)]
fn long(q: SVector<f64, M>, p: SVector<f64, { N + 1 }>, w: [[f64; N - 2]; M]) -> f64 {
    p.norm_squared() / 2.0 + (0..M).map(|i| w[i][0] * q[i].powi(4) + w[i][1] * q[i]).sum::<f64>()
}

/// Names for the number, the vector and the array.
#[contact_hamiltonian(type Real = f64, type Plane = Vector2<Real>)]
fn body(q: Plane, p: Plane, s: Real, m: Real) -> Real {
    let half = 1 as Real / 2.0;
    half * p.norm_squared() / m + Real::cos(q.x) + q.y.powi(2) + 0.1 * s
}

#[hamiltonian(name = Chain2, const N = 4, type Chain = [f64; N])]
fn chain(q: Chain, p: Chain, weights: Chain) -> f64 {
    q.iter().zip(p).zip(weights).map(|((q, p), w)| w * (p * p + q.powi(4))).sum()
}

/// A constant inside needs no repetition; it hides the one outside.
#[hamiltonian]
fn inside(q: [f64; 2], p: [f64; 2]) -> f64 {
    const N: usize = 2;
    let mut e = 0.0;
    for i in 0..N {
        e += p[i] * p[i] + q[i].powi(4);
    }
    e
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-14 * a.abs().max(1.0), "{a} {b}");
}

#[test]
fn compiles_and_means_what_it_says() {
    let (q, p, m) = ([0.1, 0.2, -0.3, 0.4], [1.0, 0.5, 0.25, -0.125], [1.5, 2.0, 0.7, 1.1]);
    close(Ring { m, k: 0.3 }.energy(&State::new(q, p)), ring(q, p, m, 0.3));
    close(Chain2 { weights: m }.energy(&State::new(q, p)), chain(q, p, m));
    close(Inside.energy(&State::new([0.1, 0.2], [0.3, 0.4])), inside([0.1, 0.2], [0.3, 0.4]));
    let (q, p, w) = (SVector::from([0.1, 0.2, 0.3, 0.4, 0.5]), SVector::from([1.0; M]), [[0.5, 0.3]; M]);
    close(Long { w }.energy(&State::new(q, p)), long(q, p, w));
    let (q, p) = (Plane::new(0.3, 0.4), Plane::new(0.5, -0.6));
    close(Body { m: 1.3 }.energy(&ContactState::new(q, p, 0.7)), body(q, p, 0.7, 1.3));
}

/// A system of a body may have the name of a system of the module. Names of the body count for it.
#[test]
fn constants_of_a_body_are_repeated() {
    const COUNT: usize = 2;
    type Pair = [f64; 2];

    #[hamiltonian(const COUNT = 2, type Pair = [f64; 2], name = Beside)]
    fn beside(q: [f64; COUNT], p: Pair) -> f64 {
        (0..COUNT).map(|i| p[i] * p[i] + q[i] * q[i]).sum::<f64>() / 2.0
    }

    assert_eq!(Beside.energy(&State::new([1.0, 0.0], [0.0, 1.0])), 1.0);
    assert_eq!(beside([1.0, 0.0], [0.0, 1.0]), 1.0);
    assert_eq!(self::Beside.energy(&State::new(1.0, 2.0)), 2.5);
}

#[hamiltonian]
fn beside(q: f64, p: f64) -> f64 {
    (p * p + q * q) / 2.0
}
