//! Everything that a body may say, against the value of the function itself.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use geoint_runtime::prelude::*;

#[hamiltonian]
fn lets(q: [f64; 3], p: [f64; 3], t: f64, a: f64) -> f64 {
    let [x, y, z] = q;
    let (s, c) = x.sin_cos();
    let x = x + (y * z);
    let block = {
        let inner = x * c;
        inner * inner
    };
    let pairs = [(1.0, x), (2.0, y)];
    let mut e = block - s * t;
    for (weight, value) in pairs {
        e += weight * value;
    }
    e += if y > 0.0 && z < 1.0 || x != 2.0 {
        a
    } else if !(x <= 0.0) {
        y
    } else {
        -z
    };
    e + p[0] * p[0] + p[1] * p[1] / 2.0 + p[2].powi(2)
}

#[hamiltonian]
fn loops(q: [f64; 3], p: [f64; 3]) -> f64 {
    const N: usize = 3;
    let mut e = 0.0;
    for i in 0..N {
        if i % 2 == 0 {
            e += p[i] * p[i];
        } else {
            e += 0.5 * p[i] * p[i];
        }
        for j in (i + 1)..=2 {
            e -= 1.0 / (1.0 + (q[i] - q[j]).powi(2));
        }
    }
    let chain: f64 = q.windows(2).map(|w| (w[1] - w[0]).powi(4)).sum();
    let crossed = q.iter().zip(p.iter()).map(|(x, y)| x * y).sum::<f64>();
    let ring = (0..N).map(|i| q[i] * q[(i + 1) % N]).sum::<f64>();
    let picked = (0..N).filter(|i| *i != 1).flat_map(|i| [q[i], p[i]]).sum::<f64>();
    let weighted = q.iter().enumerate().rev().skip(1).take(2).map(|(i, x)| i as f64 * x).sum::<f64>();
    e + chain + crossed + ring + picked + weighted
}

#[hamiltonian]
fn functions(q: f64, p: f64) -> f64 {
    fn square(x: f64) -> f64 {
        x * x
    }
    const HALF: f64 = 1.0 / 2.0;
    let scaled = |x: f64| HALF * square(x);
    let (a, b) = (q.abs() + 1.5, q.tanh());
    scaled(p)
        + a.acosh()
        + b.atanh()
        + b.asin()
        + b.acos()
        + q.atan()
        + q.atan2(a)
        + q.sinh()
        + q.cosh()
        + q.asinh()
        + q.exp()
        + q.exp2()
        + q.exp_m1()
        + a.ln()
        + a.ln_1p()
        + a.log2()
        + a.log10()
        + a.sqrt()
        + q.cbrt()
        + q.hypot(p)
        + a.powf(1.5)
        + a.powf(b)
        + a.recip()
        + q.mul_add(a, b)
        + q.min(a)
        + q.max(b)
        + q.clamp(-a, a)
        + q.signum()
        + q.to_radians()
        + q.to_degrees()
        + b.tan()
        + f64::sin(q)
        + f64::from(3)
        + (7 / 2) as f64
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-13 * a.abs().max(1.0), "{a} {b}");
}

#[test]
fn compiles_and_means_what_it_says() {
    for (q, p) in [([0.3, -0.4, 0.9], [1.0, 0.5, -2.0]), ([-1.2, 0.7, 2.0], [0.1, -0.2, 0.3])] {
        close(Lets { a: 1.5 }.energy(&State::at(0.7, q, p)), lets(q, p, 0.7, 1.5));
        close(Lets { a: 2.0 }.energy(&State::at(0.7, q, p)), lets(q, p, 0.7, 2.0));
        close(Loops.energy(&State::new(q, p)), loops(q, p));
        close(Functions.energy(&State::new(q[0], p[0])), functions(q[0], p[0]));
    }
}
