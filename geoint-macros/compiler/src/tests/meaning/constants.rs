//! Constants, integers, and numbers that are not finite.

use super::*;

#[test]
fn constants_of_the_user_may_be_called_like_those_of_the_library() {
    agrees!(|q, p, t, a| { E * q[0] + TAU * p[1] });
    agrees!(|q, p, t, a| { consts::PI * q[0] });
    agrees!(|q, p, t, a| {
        const PI: f64 = 3.0;
        PI * q[0]
    });
    agrees!(|q, p, t, a| {
        use std::f64::consts::PI;
        PI * q[0]
    });
    agrees!(|q, p, t, a| {
        use std::f64::consts::{E, PI as HALF_TURN};
        E * q[0] + HALF_TURN
    });
    agrees!(|q, p, t, a| {
        use core::f64::consts::*;
        E * q[0] + TAU
    });
    agrees!(|q, p, t, a| {
        use core::f64::consts::*;
        const E: f64 = 2.0;
        E * q[0] + TAU
    });
    agrees!(|q, p, t, a| {
        let x = {
            use std::f64::consts::E;
            E * q[0]
        };
        x + E
    });
    agrees!(|q, p, t, a| { std::f64::consts::TAU * q[0] + core::f64::consts::FRAC_PI_6 });
    agrees!(|q, p, t, a| { OUTSIDE[1] * q[0] + OUTSIDE[3 - 2] * p[0] });
}

#[test]
fn integers_outside_divide_as_integers() {
    agrees!(|q, p, t, a| { (N / M) as f64 * q[0] });
    agrees!(|q, p, t, a| { ((N / M) * M) as f64 * q[0] });
    agrees!(|q, p, t, a| { (-N) as f64 + f64::from(-N / M) * q[0] });
    agrees!(|q, p, t, a| { (N - 1) as f64 * q[0] });
    agrees!(|q, p, t, a| { E * TAU * q[0] });
    refuses!("leave the cast out", |q, p, t, a| { (if q[0] > 0.0 { N } else { M }) as f64 });
    refuses!("rustc alone", |q, p, t, a| { (N.max(M) / M) as f64 });
}

#[test]
fn integers() {
    agrees!(|q, p, t, a| { (7 / 2) as f64 * q[0] });
    agrees!(|q, p, t, a| { (-7 / 2) as f64 * q[0] + (-7 % 3) as f64 });
    agrees!(|q, p, t, a| { 7 as f64 / 2 as f64 * q[0] });
    agrees!(|q, p, t, a| { -1_i32 as f64 * q[0] });
    agrees!(|q, p, t, a| { 2 as f64 * q[0] - 3_u8 as f64 });
    agrees!(|q, p, t, a| { (300_i32 as u8) as f64 + (-1_i32 as u16) as f64 + (200_u8 as i8) as f64 });
    agrees!(|q, p, t, a| { (2_i64.pow(40) as i32) as f64 + 2_i32.pow(10) as f64 });
    agrees!(|q, p, t, a| {
        let n = 5;
        let k = n / 2 * 2;
        (n - k) as f64 * q[k - 3]
    });
    agrees!(|q, p, t, a| { (-3_i32).rem_euclid(2) as f64 + (-3_i32).abs() as f64 + 3.max(5).min(4) as f64 });
    agrees!(|q, p, t, a| { 0xff as f64 + 0b101 as f64 + 1_000 as f64 + 1_000.5 });
    refuses!("no derivative", |q, p, t, a| { (q[0] as i32) as f64 });
    refuses!("no derivative", |q, p, t, a| { 2.7 as i32 as f64 });
    refuses!("in whose bounds they lie", |q, p, t, a| { (-1_i32 as usize) as f64 });
}

#[test]
fn numbers_of_another_type_are_refused() {
    refuses!("one type", |q, p, t, a| { f64::from(0.1_f32) });
    refuses!("one type", |q, p, t, a| { q[0] as f32 as f64 });
    refuses!("one type", |q, p, t, a| {
        let x: f32 = 0.1;
        x as f64 * q[0]
    });
    refuses!("one type", |q, p, t, a| {
        fn third() -> f32 {
            1.0 / 3.0
        }
        third() as f64
    });
    refuses!("one type", |q, p, t, a| { f32::sin(0.1).into() });
    agrees!(|q, p, t, a| { 2.0_f64 * q[0] + 2f64 + 1e-3 });
}

#[test]
fn constants_that_are_not_finite_are_refused() {
    refuses!("not a finite number", |q, p, t, a| { q[0] / 0.0 });
    refuses!("not a finite number", |q, p, t, a| { (1.0 / 0.0) / 2.0 });
    refuses!("not a finite number", |q, p, t, a| { 1e300 * 1e300 * q[0] });
    refuses!("not a finite number", |q, p, t, a| { q[0] + (-2.0_f64).sqrt() });
    refuses!("not a finite number", |q, p, t, a| { q[0] + (2.0_f64 - 3.0).ln() });
}
