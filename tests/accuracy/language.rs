//! Every function and every form of the language: the generated energy is the user's, its derivatives are right.

#![allow(clippy::eq_op, reason = "what cancels is part of the language")]

use crate::derivatives::{assert_near, check_field, check_gradient, gradient};
use geoint_runtime::private::Collocation;
use geoint_runtime::{Hamiltonian, Real, hamiltonian};
use geoint_tests::measure::Noise;
use geoint_tests::scalars::Dual;
use nalgebra::Vector3;

/// Compares the derivatives of an energy of one degree of freedom with the same expression over dual numbers.
fn compare<S>(system: S, written: fn(f64, f64) -> f64, restated: fn(Dual, Dual) -> Dual, low: f64, high: f64)
where
    S: Collocation<f64> + Collocation<Dual> + Hamiltonian<f64> + Hamiltonian<Dual>,
{
    let mut noise = Noise::new(11).map(|x| 0.5 * (low + high) + 0.5 * (high - low) * x);
    for (q, p) in (0..40).filter_map(|_| noise.next().zip(noise.next())) {
        check_gradient::<S, S>(&system, &system, &|q, p| written(q[0], p[0]), 0.0, &[q], &[p]);
        let slopes = gradient::<S, f64>(&system, 0.0, &[q], &[p]);
        assert_near("∂H/∂q", slopes[0], restated(Dual::variable(q), p.into()).derivative(), 1e-13);
        assert_near("∂H/∂p", slopes[1], restated(q.into(), Dual::variable(p)).derivative(), 1e-13);
        check_field::<S, S>(&system, &system, 0.0, &[q], &[p]);
    }
}

/// One energy per function, with both coordinates in its argument.
macro_rules! functions {
    ($($name:ident($q:ident, $p:ident) in $low:literal, $high:literal: $body:expr;)*) => { $(
        mod $name {
            use super::*;

            #[hamiltonian(name = System)]
            fn energy($q: f64, $p: f64) -> f64 {
                $body
            }

            #[test]
            fn agrees() {
                compare(System, energy, |$q: Dual, $p: Dual| $body, $low, $high);
            }
        }
    )* };
}

functions! {
    sin(q, p) in -3.0, 3.0: (0.7 * q + 0.4 * p).sin() * q;
    cos(q, p) in -3.0, 3.0: (0.7 * q - 0.4 * p).cos() * p;
    tan(q, p) in -1.0, 1.0: (0.7 * q + 0.4 * p).tan() + q * p;
    asin(q, p) in -0.9, 0.9: (0.6 * q + 0.3 * p).asin() * q;
    acos(q, p) in -0.9, 0.9: (0.6 * q - 0.3 * p).acos() * p;
    atan(q, p) in -3.0, 3.0: (0.7 * q + 0.4 * p).atan() * q;
    atan2(q, p) in 0.3, 2.0: (q + 0.2).atan2(p - 1.1) * p + (-q).atan2(p);
    sinh(q, p) in -1.5, 1.5: (0.7 * q + 0.4 * p).sinh() * q;
    cosh(q, p) in -1.5, 1.5: (0.7 * q + 0.4 * p).cosh() * p;
    tanh(q, p) in -2.0, 2.0: (0.7 * q + 0.4 * p).tanh() * q;
    asinh(q, p) in -3.0, 3.0: (0.7 * q + 0.4 * p).asinh() * p;
    acosh(q, p) in 1.1, 3.0: (0.7 * q + 0.4 * p).acosh() * q;
    atanh(q, p) in -0.8, 0.8: (0.6 * q + 0.3 * p).atanh() * p;
    exp(q, p) in -1.5, 1.5: (0.7 * q + 0.4 * p).exp() * q;
    exp2(q, p) in -1.5, 1.5: (0.7 * q + 0.4 * p).exp2() * p;
    exp_m1(q, p) in -1.5, 1.5: (0.7 * q + 0.4 * p).exp_m1() * q;
    ln(q, p) in 0.2, 3.0: (0.7 * q + 0.4 * p).ln() * p;
    ln_1p(q, p) in -0.7, 2.0: (0.7 * q + 0.4 * p).ln_1p() * q;
    log2(q, p) in 0.2, 3.0: (0.7 * q + 0.4 * p).log2() * p;
    log10(q, p) in 0.2, 3.0: (0.7 * q + 0.4 * p).log10() * q;
    sqrt(q, p) in 0.2, 3.0: (0.7 * q + 0.4 * p).sqrt() * p;
    cbrt(q, p) in 0.2, 3.0: (0.7 * q + 0.4 * p).cbrt() * q + (-q).cbrt() * p;
    hypot(q, p) in -3.0, -0.2: (0.7 * q).hypot(0.4 * p) * q;
    powi(q, p) in 0.4, 1.6: q.powi(5) * p + p.powi(-3) * q + (q - p).powi(2) + q.powi(0) + p.powi(1);
    powf(q, p) in 0.4, 1.6: q.powf(2.5) * p + p.powf(-0.5) + q.powf(1.7) * p.powf(-0.3) + q.powf(2.0) + q.powf(p);
    recip(q, p) in 0.4, 1.6: (0.7 * q + 0.4 * p).recip() * q;
    abs(q, p) in 0.2, 3.0: (0.7 * q + 0.4 * p).abs() * q * p + (-q - p * p).abs() * p;
    mul_add(q, p) in -2.0, 2.0: q.mul_add(p * q, q * p * p);
    min(q, p) in -2.0, 2.0: (q * q * q).min(p * p) * p;
    max(q, p) in -2.0, 2.0: (q * q * q).max(q * p) * p;
    clamp(q, p) in -2.0, 2.0: (q.clamp(-3.0, -2.5) * q + p.clamp(2.5, 3.0) * q * q + q.clamp(-2.5, 2.5)) * p;
    signum(q, p) in 0.1, 2.0: (q - p - 3.0).signum() * q * q * p + (q + p).signum() * p;
    to_radians(q, p) in -180.0, 180.0: q.to_radians().sin() * p;
    to_degrees(q, p) in -0.01, 0.01: q.to_degrees().sin() + p.to_degrees() * q;
    division(q, p) in 0.3, 2.0: (q - p) / (1.0 + q * p) / (2.0 + p) - -q / 3.0;
    shared(q, p) in 0.3, 2.0: (q * p).sin() / (q * p) + (q * p).cos() * (q * p).sin() + (q * p).sqrt();
    deep(q, p) in 0.3, 1.2: ((q * p).sin().exp() + (1.0 + q).ln().sqrt()).tanh() * (p.cosh() - q).atan();
    cancelling(q, p) in 0.3, 1.2: q * p - p * q + (q + p) * (q - p) - q * q + 0.0 * q.exp() + q / q + p * 1.0;
}

const STIFFNESS: f64 = 1.75;
const WEIGHTS: [f64; 3] = [0.5, 1.25, 2.5];

/// Items, closures, tuples, blocks, shadowing.
#[hamiltonian]
fn items_and_bindings(q: [f64; 3], p: [f64; 3], k: [f64; 2]) -> f64 {
    const OFFSET: f64 = 0.3;
    fn spring(x: f64, k: f64) -> f64 {
        let x2 = x * x;
        k * (x2 / 2.0 + x2 * x2 / 8.0)
    }
    let square = |x: f64| x * x;
    let (first, (second, third)) = (q[0] - OFFSET, (q[1], q[2]));
    let [a, _, c] = p;
    let energy = 0.5 * (square(a) + square(p[1]) + square(c));
    let energy = {
        let x = first * second;
        energy + spring(x, k[0]) + std::f64::consts::FRAC_1_PI * x.sin()
    };
    let (energy, rest) = (energy + STIFFNESS * third.powi(2), spring(second - third, k[1]));
    energy + rest * WEIGHTS[1] + core::f64::consts::LN_2 * a * third
}

/// Loops and iterators over constant domains.
#[hamiltonian]
fn loops(q: [f64; 4], p: [f64; 4], m: [f64; 4], k: [[f64; 2]; 2]) -> f64 {
    let mut kinetic = 0.0;
    for (i, p) in p.iter().enumerate() {
        kinetic += p * p / (2.0 * m[i]);
    }
    let mut potential = 0.0;
    for i in 0..4 {
        for j in (i + 1)..4 {
            let r = q[i] - q[j];
            potential += (1.0 + r * r).sqrt() * k[i % 2][j % 2];
        }
    }
    let neighbours = q.windows(2).map(|w| (w[1] - w[0]) * (w[1] - w[0])).sum::<f64>();
    let mixed: f64 = q.iter().zip(p.iter()).map(|(q, p)| q * p).sum();
    let weighted: f64 = (0..3).map(|i| WEIGHTS[i] * q[i + 1].cos()).sum();
    kinetic + potential + 0.3 * neighbours + 0.1 * mixed * mixed - weighted
}

/// Vectors: sums, products with scalars, dot, norm, cross, components.
#[hamiltonian]
fn vectors(q: [Vector3<f64>; 2], p: [Vector3<f64>; 2], m: f64, axis: Vector3<f64>) -> f64 {
    let r = q[0] - q[1] * 0.5;
    let spin = q[0].cross(&p[0]) + q[1].cross(&p[1]);
    let kinetic = (p[0].norm_squared() + 2.0 * p[1].dot(&p[1])) / (2.0 * m);
    kinetic + spin.dot(&axis) - 1.0 / (r.norm() + 0.2) + r.x * r[1] + (-r).z.sin() + (r / m).norm_squared()
}

/// A branch within a branch, and conditions of several parts.
#[hamiltonian]
fn branches(q: [f64; 2], p: [f64; 2], edge: f64) -> f64 {
    let x = q[0] * q[1];
    let well = if x > edge && q[0] > 0.0 {
        if p[0] * p[0] < 0.5 || q[1] <= -0.1 { x * x } else { x * x + x.sin() }
    } else if x < -edge {
        (1.0 - x).ln()
    } else {
        let y = x + p[1];
        y.exp()
    };
    0.5 * (p[0] * p[0] + p[1] * p[1]) + well
}

fn check<S, D>(plain: S, dual: D, n: usize, written: &dyn Fn(&[f64], &[f64]) -> f64)
where
    S: Collocation<f64> + Hamiltonian<f64>,
    D: Collocation<Dual> + Hamiltonian<Dual>,
{
    let mut noise = Noise::new(3);
    for _ in 0..60 {
        let q: Vec<f64> = noise.by_ref().take(n).map(|x| 1.3 * x).collect();
        let p: Vec<f64> = noise.by_ref().take(n).collect();
        check_gradient(&plain, &dual, written, 0.0, &q, &p);
        check_field(&plain, &dual, 0.0, &q, &p);
    }
}

fn dual<const N: usize>(x: [f64; N]) -> [Dual; N] {
    x.map(Dual::from)
}

fn fixed<const N: usize>(x: &[f64]) -> [f64; N] {
    core::array::from_fn(|i| x[i])
}

#[test]
fn items_and_bindings_agree() {
    let k = [1.3, 0.6];
    check(ItemsAndBindings { k }, ItemsAndBindings { k: dual(k) }, 3, &|q, p| {
        items_and_bindings(fixed(q), fixed(p), k)
    });
}

#[test]
fn loops_agree() {
    let (m, k) = ([1.3, 0.6, 2.1, 0.9], [[0.7, 1.1], [1.6, 0.4]]);
    check(Loops { m, k }, Loops { m: dual(m), k: k.map(dual) }, 4, &|q, p| loops(fixed(q), fixed(p), m, k));
}

#[test]
fn vectors_agree() {
    let (m, axis) = (1.7, Vector3::new(0.3, -0.8, 0.5));
    let pair = |x: &[f64]| [Vector3::from_column_slice(&x[..3]), Vector3::from_column_slice(&x[3..])];
    let lifted = Vectors { m: Dual::from(m), axis: axis.map(Dual::from) };
    check(Vectors { m, axis }, lifted, 6, &|q, p| vectors(pair(q), pair(p), m, axis));
}

#[test]
fn branches_agree() {
    let edge = 0.15;
    check(Branches { edge }, Branches { edge: Dual::from(edge) }, 2, &|q, p| branches(fixed(q), fixed(p), edge));
}

/// Another way to the same numbers: the gradient of the loops, written out by hand.
#[test]
fn loops_by_hand() {
    let (m, k) = ([1.3, 0.6, 2.1, 0.9], [[0.7, 1.1], [1.6, 0.4]]);
    let (q, p) = ([0.3, -0.8, 0.5, 1.1], [0.2, 0.7, -0.4, 0.9]);
    let mixed: f64 = (0..4).map(|i| q[i] * p[i]).sum();
    let slopes = gradient::<_, f64>(&Loops { m, k }, 0.0, &q, &p);
    for i in 0..4 {
        let pull = |j: usize| {
            let (r, (a, b)) = (q[i] - q[j], (i.min(j), i.max(j)));
            k[a % 2][b % 2] * r / (1.0 + r * r).sqrt()
        };
        let mut dq = (0..4).filter(|j| *j != i).map(pull).sum::<f64>() + 0.2 * mixed * p[i];
        if i > 0 {
            dq += 0.6 * (q[i] - q[i - 1]) + WEIGHTS[i - 1] * q[i].sin();
        }
        if i < 3 {
            dq -= 0.6 * (q[i + 1] - q[i]);
        }
        assert_near("∂H/∂q", slopes[i], dq, 1e-14);
        assert_near("∂H/∂p", slopes[4 + i], p[i] / m[i] + 0.2 * mixed * q[i], 1e-14);
    }
}
