//! Every recurrence against a table of 50 digits (Cauchy's integral with 110 digits), at t = 0 for u = 2/5 + sin(t)/3 + t²/7 and v = 13/10 + cos(2t)/5 −
//! t/4. Every kind of system is compared with truncated series as a scalar.

mod bodies;
mod masses;
mod systems;
mod table;

use geoint_runtime::prelude::*;
use geoint_runtime::private::Jets;
use table::TABLE;

/// x' = F(t) for every function of the table, with u and v by their coefficients: those of products with t are exact.
#[vector_field]
#[allow(unused_variables, reason = "the field depends on time alone")]
fn functions(x: [f64; 24], t: f64) -> [f64; 24] {
    const U: [f64; 32] = [
        0.4,
        0.3333333333333333,
        0.14285714285714285,
        -0.05555555555555555,
        0.0,
        0.002777777777777778,
        0.0,
        -6.613756613756614e-05,
        0.0,
        9.185773074661964e-07,
        0.0,
        -8.35070279514724e-09,
        0.0,
        5.3530146122738715e-11,
        0.0,
        -2.5490545772732723e-13,
        0.0,
        9.371524181151737e-16,
        0.0,
        -2.7402117488747765e-18,
        0.0,
        6.524313687797087e-21,
        0.0,
        -1.2893900568768947e-23,
        0.0,
        2.1489834281281578e-26,
        0.0,
        -3.0612299545985155e-29,
        0.0,
        3.7699876288159057e-32,
        0.0,
        -4.0537501385117263e-35,
    ];
    const V: [f64; 32] = [
        1.5,
        -0.25,
        -0.4,
        0.0,
        0.13333333333333333,
        0.0,
        -0.017777777777777778,
        0.0,
        0.0012698412698412698,
        0.0,
        -5.6437389770723105e-05,
        0.0,
        1.7102239324461546e-06,
        0.0,
        -3.758733917464076e-08,
        0.0,
        6.264556529106794e-10,
        0.0,
        -8.188962783146136e-12,
        0.0,
        8.619960824364354e-14,
        0.0,
        -7.463169544904202e-16,
        0.0,
        5.408093873118987e-18,
        0.0,
        -3.328057768073223e-20,
        0.0,
        1.7608771259646682e-22,
        0.0,
        -8.095986786044451e-25,
        0.0,
    ];
    let (mut u, mut v) = (0.0, 0.0);
    for k in (0..32).rev() {
        u = U[k] + t * u;
        v = V[k] + t * v;
    }
    [
        u * v,
        u * u,
        u / v,
        u.sqrt(),
        u.powf(-1.5),
        u.powf(0.7),
        u.cbrt(),
        u.exp(),
        u.ln(),
        u.sin(),
        u.cos(),
        u.sinh(),
        u.cosh(),
        u.tan(),
        u.tanh(),
        u.asin(),
        u.acos(),
        u.atan(),
        u.asinh(),
        (u + 2.0).acosh(),
        u.atanh(),
        u.atan2(v),
        u.hypot(v),
        u.powf(v),
    ]
}

#[test]
fn every_recurrence() {
    const P: usize = 32;
    let zero = geoint_runtime::space::PerCoordinate { z: [0.0; 24], s: () };
    let (mut jet, mut switches) = ([zero; P], [[0.0; 0]; P]);
    Functions.jet(1.0, 0.0, &[0.0; 24], &(), &mut jet, &mut switches);
    for (i, (name, expected, bar)) in TABLE.iter().enumerate() {
        let f = |n: usize| jet[n].z[i] * (n + 1) as f64;
        let radius = (20..=30).map(|n| f(n).abs().powf(-1.0 / n as f64)).fold(f64::INFINITY, f64::min);
        for (n, expected) in [5, 10, 30].into_iter().zip(expected) {
            let scale = (0..=n).map(|j| f(j).abs() * radius.powi(j as i32 - n as i32)).fold(0.0, f64::max);
            let error = (f(n) - expected).abs() / (f64::EPSILON * scale);
            assert!(error <= *bar, "{name}, order {n}: {error}");
        }
    }
}
