//! Operators, conditions, blocks, iterators, functions.

use super::*;

#[test]
fn precedence() {
    agrees!(|q, p, t, a| { -q[0].powi(2) });
    agrees!(|q, p, t, a| { -2.0_f64.powi(2) + q[0] });
    agrees!(|q, p, t, a| { (-q[0]).powi(2) + a });
    agrees!(|q, p, t, a| { a - q[0] - p[0] - 1.0 });
    agrees!(|q, p, t, a| { a / p[0] / q[0] * p[1] });
    agrees!(|q, p, t, a| { 2.0 * -q[0] - -a });
    agrees!(|q, p, t, a| { if !(q[0] < 0.0) && p[0] > 0.0 || a > 1.0 { 1.0 } else { 2.0 } });
    agrees!(|q, p, t, a| {
        let x = q[0] < 0.0 || p[0] > 0.0 && a > 1.0;
        if !x { a } else { 0.0 }
    });
}

#[test]
fn conditions_are_lazy() {
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            if i > 0 && q[i - 1] < q[i] {
            } else {
            }
            e += if i > 0 && q[i - 1] < q[i] { 1.0 } else { a };
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            e += if i == 2 || q[i + 1] < 0.0 { 1.0 } else { a };
        }
        e
    });
    agrees!(|q, p, t, a| {
        let nan = a * f64::NAN.max(2.0).min(2.0);
        if nan != nan { 1.0 } else { nan }
    });
}

#[test]
fn iterators() {
    agrees!(|q, p, t, a| { (0..0).map(|i| q[i]).sum::<f64>() + a });
    agrees!(|q, p, t, a| { (2..1).map(|i| q[i]).sum::<f64>() + a });
    agrees!(|q, p, t, a| { (-1..=1).map(|i| i as f64 * q[(i + 1) as usize]).sum::<f64>() });
    agrees!(|q, p, t, a| { q.iter().zip(&[2.0, 3.0]).map(|(x, y)| x * y).sum::<f64>() });
    agrees!(|q, p, t, a| { q.iter().zip(p.iter()).enumerate().map(|(i, (x, y))| i as f64 * x * y).sum::<f64>() });
    agrees!(|q, p, t, a| { q.windows(2).map(|w| (w[1] - w[0]).powi(2)).sum::<f64>() + q.windows(4).count() as f64 });
    agrees!(|q, p, t, a| { q.iter().skip(1).take(7).rev().enumerate().map(|(i, x)| i as f64 * x).sum::<f64>() });
    agrees!(|q, p, t, a| { (0..3).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| q[i] * p[j]).sum::<f64>() });
    agrees!(|q, p, t, a| { (0..3).filter(|i| i % 2 == 0).map(|i| q[i]).sum::<f64>() });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for (i, (x, y)) in q.iter().zip(p).enumerate() {
            e += i as f64 * x * y;
        }
        e
    });
    agrees!(|q, p, t, a| {
        let [x, y, z] = q.map(|x| x * x);
        x - y * z
    });
    agrees!(|q, p, t, a| { q.len() as f64 + (0..5).len() as f64 + q.iter().count() as f64 });
    agrees!(|q, p, t, a| {
        let pairs = [(1.0, q[0]), (2.0, p[0])];
        let mut e = 0.0;
        for &(c, x) in pairs.iter() {
            e += c * x;
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for row in [[q[0], q[1]], [p[0], p[1]]] {
            for x in row {
                e += x;
            }
            e -= row[0];
        }
        e
    });
    refuses!("out of bounds", |q, p, t, a| { (0..3).map(|i| q[i + 1]).sum::<f64>() });
}

/// A trait for arrays whose methods have the names of iterator and vector methods.
trait Norms {
    fn sum(&self) -> f64;
    fn norm(&self) -> f64;
}

impl Norms for [f64; 3] {
    fn sum(&self) -> f64 {
        self[0]
    }
    fn norm(&self) -> f64 {
        7.0
    }
}

#[test]
fn methods_of_the_user_are_not_those_of_iterators_and_vectors() {
    refuses!("arrays have", |q, p, t, a| { q.sum() });
    refuses!("arrays have", |q, p, t, a| { q.norm() });
}

#[test]
fn functions() {
    agrees!(|q, p, t, a| { q[0].max(f64::NAN) + f64::NAN.min(a) });
    agrees!(|q, p, t, a| { q[0].min(p[0]).max(a) + q[1].abs() + q[1].signum() });
    agrees!(|q, p, t, a| { q[0].clamp(-0.5, 0.2) + p[0].clamp(-a, a) * (3.0 * q[1]).clamp(-2.0, 1.0) });
    agrees!(|q, p, t, a| {
        let (s, c) = q[0].sin_cos();
        s * a - c
    });
    agrees!(|q, p, t, a| { q[0].mul_add(a, p[0]) + q[0].hypot(p[0]) + q[0].atan2(p[0]) + p[0].atan2(q[0]) });
    agrees!(|q, p, t, a| { f64::sin(q[0]) + f64::powi(q[1], -3) + f64::max(q[0], a) + f64::from(3) });
    agrees!(|q, p, t, a| { a.powf(0.5) + a.powf(q[0]) + a.powf(-1.5) + a.powf(2.0) + q[0].powi(0) });
    agrees!(|q, p, t, a| { (q[0] * q[0]).sqrt() + (a * a * a).sqrt() + (q[0].powi(2) * a).sqrt() });
    agrees!(|q, p, t, a| { q[0].to_radians() + q[0].to_degrees() + q[0].recip() + q[0].cbrt() + q[0].exp2() });
    agrees!(|q, p, t, a| { a.ln() + a.ln_1p() + a.log2() + a.log10() + a.exp_m1() + q[0].tan() + q[0].asinh() });
}

#[test]
fn blocks_and_tuples() {
    agrees!(|q, p, t, a| {
        let x = {
            let y = q[0];
            y * y
        };
        let (u, (v, w)) = (x, (a, p[0]));
        u - v * w
    });
    agrees!(|q, p, t, a| {
        let pair = (q[0], a);
        let nested = (pair, [p[0], p[1]]);
        nested.0.1 * nested.1[1] + pair.0
    });
    agrees!(|q, p, t, a| {
        let x = if q[0] > 0.0 { (a, 1.0) } else { (2.0, q[0]) };
        x.0 - x.1
    });
    refuses!("here", |q, p, t, a| {
        let x;
        x = q[0];
        x
    });
    refuses!("not supported", |q, p, t, a| {
        'block: {
            break 'block q[0];
        }
    });
    refuses!("not supported", |q, p, t, a| { if let Some(x) = Some(q[0]) { x } else { a } });
    refuses!("not supported", |q, p, t, a| {
        let Some(x) = Some(q[0]) else { return a };
        x
    });
}
