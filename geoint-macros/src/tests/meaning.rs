//! Does lowering understand Rust as rustc does? Each body is compiled by rustc and lowered to a graph, and both are
//! evaluated; or it is one that the macro has to refuse, because it could not follow what rustc makes of it.

use crate::ir::{Symbol, eval::eval};
use crate::{lower, parse};
use quote::quote;

/// The value of the constant below, and how the graph is told of it.
const OUTSIDE: [f64; 3] = [1.5, -2.5, 0.25];
const N: i32 = 7;
const M: i32 = 2;
/// Names that the standard library uses as well.
const E: f64 = 210.0;
const TAU: f64 = 0.125;
mod consts {
    pub(super) const PI: f64 = 3.0;
}

fn lowered(body: &str) -> Result<lower::Lowered, Vec<String>> {
    let body: proc_macro2::TokenStream = body.parse().expect("tokens");
    let item = quote!(fn energy(q: [f64; 3], p: [f64; 3], t: f64, a: f64) -> f64 { #body });
    let energy = parse::energy(parse::Form::Hamiltonian, quote!(), syn::parse2(item).expect("a function"))
        .map_err(|e| e.messages())?;
    lower::body(&energy).map_err(|errors| errors.messages())
}

/// The value of a constant outside of the energy, as rustc evaluates the tokens that are emitted for it.
fn outside(tokens: &str) -> f64 {
    match tokens.replace(' ', "").as_str() {
        "E" => E,
        "TAU" => TAU,
        "f64::NAN" => f64::NAN,
        "consts::PI" => consts::PI,
        "OUTSIDE[1]" => OUTSIDE[1],
        "(N/M)" => f64::from(N / M),
        "((N/M)*M)" => f64::from((N / M) * M),
        "(-N)" => f64::from(-N),
        "((-N)/M)" => f64::from(-N / M),
        "(N-1)" => f64::from(N - 1),
        "(E*TAU)" => E * TAU,
        other => panic!("no value for {other}"),
    }
}

fn compare(body: &str, rust: fn([f64; 3], [f64; 3], f64, f64) -> f64) {
    let lowered = lowered(body).unwrap_or_else(|messages| panic!("{body}\nis refused: {messages:?}"));
    let points = [([0.3, -1.2, 2.5], [0.7, 0.1, -0.4], 0.9, 1.7), ([-0.8, 0.6, 0.2], [-1.1, 2.3, 0.5], -0.4, 0.35)];
    for (q, p, t, a) in points {
        let value = |symbol: Symbol| match symbol {
            Symbol::Q(i) => q[i as usize],
            Symbol::P(i) => p[i as usize],
            Symbol::T => t,
            Symbol::Parameter(0) => a,
            Symbol::Parameter(n) => outside(&lowered.constants[n as usize - 1].to_string()),
            other => panic!("an energy has no {other:?}"),
        };
        let (expected, found) = (rust(q, p, t, a), eval(&lowered.graph, lowered.energy, &value));
        let same = (expected - found).abs() <= 1e-14 * expected.abs().max(1.0) || expected.is_nan() && found.is_nan();
        assert!(same, "{body}\nrustc: {expected}, graph: {found}");
    }
}

/// The body means to the graph what it means to rustc.
macro_rules! agrees {
    (|$q:ident, $p:ident, $t:ident, $a:ident| { $($body:tt)* }) => {{
        #[allow(
            unused, clippy::all, clippy::pedantic, non_upper_case_globals,
            reason = "odd code is the point"
        )]
        fn energy($q: [f64; 3], $p: [f64; 3], $t: f64, $a: f64) -> f64 { $($body)* }
        compare(stringify!($($body)*), energy);
    }};
}

/// The body compiles, but is refused with one message, of which this is a part.
macro_rules! refuses {
    ($message:literal, |$q:ident, $p:ident, $t:ident, $a:ident| { $($body:tt)* }) => {{
        #[allow(
            unused, clippy::all, clippy::pedantic, non_upper_case_globals,
            reason = "odd code is the point"
        )]
        fn energy($q: [f64; 3], $p: [f64; 3], $t: f64, $a: f64) -> f64 { $($body)* }
        let _: fn([f64; 3], [f64; 3], f64, f64) -> f64 = energy;
        let messages = lowered(stringify!($($body)*)).err().unwrap_or_default();
        assert_eq!(messages.len(), 1, "{}\nis said to be {messages:?}", stringify!($($body)*));
        assert!(messages[0].contains($message), "{}", messages[0]);
    }};
}

#[test]
fn the_comparison_can_fail() {
    let wrong = std::panic::catch_unwind(|| compare("q[0] + 1e-12", |q, _, _, _| q[0]));
    assert!(wrong.is_err());
}

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
fn shadowing() {
    agrees!(|q, p, t, a| {
        let a = a + 1.0;
        let a = a * a;
        a + {
            let a = 0.5;
            q[0] * a
        }
    });
    agrees!(|q, p, t, a| {
        let q = q[0];
        let x = {
            let q = q * q;
            q + 1.0
        };
        x * q
    });
    agrees!(|q, p, t, a| {
        let mut e = a;
        {
            let mut e = 1.0;
            e += q[0];
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = a;
        {
            e += q[0];
            let mut e = 1.0;
            e += 100.0;
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for a in 0..3 {
            let e2 = a as f64;
            e += e2 * q[a];
        }
        e + a
    });
    agrees!(|q, p, t, a| {
        fn q(x: f64) -> f64 {
            2.0 * x
        }
        q(a)
    });
    agrees!(|q, p, t, a| {
        let f = |a: f64| a * q[0];
        let a = f(2.0);
        f(a)
    });
    agrees!(|q, p, t, a| {
        let mut s = 0.0;
        for i in 0..3 {
            let mut s2 = 0.0;
            for j in 0..3 {
                s2 += q[j];
            }
            s += s2 * p[i];
        }
        s
    });
}

#[test]
fn items_see_items_where_they_are_written() {
    agrees!(|q, p, t, a| {
        const K: f64 = 2.0;
        fn f(x: f64) -> f64 {
            K * x
        }
        {
            const K: f64 = 3.0;
            f(q[0]) + K
        }
    });
    agrees!(|q, p, t, a| {
        const A: f64 = B + 1.0;
        const B: f64 = 2.0;
        A * q[0]
    });
    agrees!(|q, p, t, a| {
        const E: f64 = TAU;
        const TAU: f64 = 2.0;
        E * q[0]
    });
    agrees!(|q, p, t, a| {
        const X: f64 = E * 2.0;
        {
            const E: f64 = 1.0;
            X * E
        }
    });
    agrees!(|q, p, t, a| {
        fn f(x: f64) -> f64 {
            g(x) + 1.0
        }
        fn g(x: f64) -> f64 {
            x * x
        }
        {
            fn g(x: f64) -> f64 {
                9.0
            }
            f(q[0]) + g(a)
        }
    });
    agrees!(|q, p, t, a| {
        fn f(x: f64) -> f64 {
            fn f(x: f64) -> f64 {
                x + 1.0
            }
            2.0 * f(x)
        }
        f(q[0])
    });
    agrees!(|q, p, t, a| {
        let h = |x: f64| {
            const K: f64 = 4.0;
            fn g(x: f64) -> f64 {
                K * x
            }
            g(x) + a
        };
        h(q[0])
    });
    agrees!(|q, p, t, a| {
        let x = f(q[0]);
        fn f(x: f64) -> f64 {
            x + K
        }
        const K: f64 = 0.5;
        x
    });
    agrees!(|q, p, t, a| {
        const W: [f64; 3] = [1.0, 2.0, 3.0];
        let mut e = 0.0;
        for i in 0..3 {
            e += W[i] * q[i];
        }
        e
    });
    agrees!(|q, p, t, a| {
        const R: usize = 3;
        let mut e = 0.0;
        for i in 0..R {
            e += q[i];
        }
        e
    });
    refuses!("cannot be generic", |q, p, t, a| {
        fn f<const N: usize>(x: [f64; N]) -> f64 {
            N as f64
        }
        f(q)
    });
    refuses!("calls itself", |q, p, t, a| {
        fn f(x: f64) -> f64 {
            if x > 0.0 { f(x - 1.0) } else { x }
        }
        f(q[0])
    });
    refuses!("calls itself", |q, p, t, a| {
        fn f(x: f64) -> f64 {
            g(x)
        }
        fn g(x: f64) -> f64 {
            if x > 0.0 { f(x - 1.0) } else { x }
        }
        g(q[0])
    });
    refuses!("this item", |q, p, t, a| {
        static K: f64 = 2.0;
        K * q[0]
    });
    refuses!("move this above", |q, p, t, a| {
        use super::meaning::E as PI;
        PI * q[0]
    });
    refuses!("move this above", |q, p, t, a| {
        use super::meaning::consts::*;
        PI * q[0]
    });
}

#[test]
fn closures() {
    agrees!(|q, p, t, a| {
        let k = 2.0;
        let f = move |x: f64| k * x;
        let k = 5.0;
        f(q[0]) + k
    });
    agrees!(|q, p, t, a| {
        let f = |x: f64| move |y: f64| x - y;
        let g = f(q[0]);
        g(p[0])
    });
    agrees!(|q, p, t, a| {
        let f = |[x, y, _]: [f64; 3], (u, v): (f64, f64)| x * u - y * v;
        f(q, (p[0], a))
    });
    agrees!(|q, p, t, a| {
        let mut s = a;
        let c = s;
        s += 1.0;
        let f = move || s;
        s += 1.0;
        f() * c + s
    });
    agrees!(|q, p, t, a| {
        let f = |mut x: f64| {
            x += 1.0;
            x
        };
        f(a) + a
    });
    refuses!("outside", |q, p, t, a| {
        let mut s = 0.0;
        let mut f = |x: f64| {
            s += x;
            s
        };
        f(q[0])
    });
    refuses!("outside", |q, p, t, a| {
        let mut s = 0.0;
        q.iter()
            .map(|x| {
                s += x;
                s
            })
            .sum::<f64>()
    });
}

#[test]
fn accumulation() {
    agrees!(|q, p, t, a| {
        let mut s = a;
        let r = s;
        s += q[0];
        s -= 2.0 * p[0];
        r * s
    });
    agrees!(|q, p, t, a| {
        let mut s = a;
        s += {
            s += 1.0;
            s * q[0]
        };
        s
    });
    agrees!(|q, p, t, a| {
        let mut s = a;
        let x = s + {
            s += 1.0;
            s
        };
        x * s
    });
    agrees!(|q, p, t, a| {
        let mut k = 0;
        for i in 0..3 {
            k += i;
        }
        k as f64 * q[0]
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            if i == 1 {
                e += q[i];
            } else {
                e -= p[i];
            }
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            for j in (i + 1)..3 {
                e += (q[i] - q[j]).powi(2);
            }
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            e += if q[i] > 0.0 { q[i] } else { -p[i] };
        }
        e
    });
    agrees!(|q, p, t, a| {
        let (mut x, mut y) = (q[0], a);
        x += y;
        y -= x;
        x * y
    });
    refuses!("outside", |q, p, t, a| {
        let mut e = 0.0;
        if q[0] > 0.0 {
            e += 1.0;
        }
        e
    });
    refuses!("outside", |q, p, t, a| {
        let mut e = 0.0;
        if q[0] > 0.0 && {
            e += 1.0;
            true
        } {
            e
        } else {
            2.0 * e
        }
    });
    refuses!("outside", |q, p, t, a| {
        let mut e = 0.0;
        let b = q[0] > 0.0 || {
            e += 1.0;
            true
        };
        e
    });
    refuses!("not followed", |q, p, t, a| {
        let mut x = a;
        let ref mut y = x;
        *y += 1.0;
        x
    });
    refuses!("no value before its end", |q, p, t, a| {
        let mut e = a;
        for i in 0..3 {
            e += e * q[i];
        }
        e
    });
    refuses!("no value before its end", |q, p, t, a| {
        let mut e = a;
        for i in 0..3 {
            let f = |x: f64| x * e;
            e += f(q[i]);
        }
        e
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

/// A trait whose methods have the names of methods of iterators, on something that is none.
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
        let mut e = 0.0;
        for i in 0..3 {
            if i == 1 {
                continue;
            }
            e += q[i];
        }
        e
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

#[test]
fn code_that_others_may_change_is_refused() {
    refuses!("may change or remove", |q, p, t, a| {
        #[cfg(any())]
        let a = 2.0;
        a
    });
    refuses!("may change or remove", |q, p, t, a| {
        let x = [
            #[cfg(any())]
            1.0,
            a,
        ];
        x[0]
    });
    refuses!("may change or remove", |q, p, t, a| {
        #[cfg(any())]
        fn f() -> f64 {
            1.0
        }
        q[0]
    });
    agrees!(|q, p, t, a| {
        #[allow(unused_variables)]
        let b = 2.0;
        #[rustfmt::skip] let c = a;
        c
    });
}

#[test]
fn constants_that_are_no_numbers_are_refused() {
    refuses!("not a finite number", |q, p, t, a| { q[0] / 0.0 });
    refuses!("not a finite number", |q, p, t, a| { (1.0 / 0.0) / 2.0 });
    refuses!("not a finite number", |q, p, t, a| { 1e300 * 1e300 * q[0] });
    refuses!("not a finite number", |q, p, t, a| { q[0] + (-2.0_f64).sqrt() });
    refuses!("not a finite number", |q, p, t, a| { q[0] + (2.0_f64 - 3.0).ln() });
}
