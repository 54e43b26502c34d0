//! Lowering must give Rust code the meaning that rustc gives it. rustc compiles each body, the compiler lowers it, and both results are compared. The
//! macro must refuse a body whose meaning it can not follow.

use crate::ir::Symbol;
use crate::tests::eval::eval;
use crate::{lower, parse};
use quote::quote;

/// The values of constants outside of the energy.
const OUTSIDE: [f64; 3] = [1.5, -2.5, 0.25];
const N: i32 = 7;
const M: i32 = 2;
/// Names that the standard library uses as well.
const E: f64 = 210.0;
const TAU: f64 = 0.125;
mod consts {
    pub(super) const PI: f64 = 3.0;
}

/// Lowers a body. Errors: messages.
fn lowered(body: &str) -> Result<lower::Lowered, Vec<String>> {
    let body: proc_macro2::TokenStream = body.parse().expect("tokens");
    let item = quote!(fn energy(q: [f64; 3], p: [f64; 3], t: f64, a: f64) -> f64 { #body });
    let energy = parse::energy(parse::Form::Hamiltonian, quote!(), syn::parse2(item).expect("a function"))
        .map_err(|e| e.messages())?;
    lower::body(&energy).map_err(|errors| errors.messages())
}

/// Returns the value of a constant outside of the energy, from the tokens that are emitted for it.
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

/// Asserts that a body has equal values as a graph and as compiled Rust, at two points.
fn compare(body: &str, rust: fn([f64; 3], [f64; 3], f64, f64) -> f64) {
    let lowered = lowered(body).unwrap_or_else(|messages| panic!("{body}\nis refused: {messages:?}"));
    let points = [([0.3, -1.2, 2.5], [0.7, 0.1, -0.4], 0.9, 1.7), ([-0.8, 0.6, 0.2], [-1.1, 2.3, 0.5], -0.4, 0.35)];
    for (q, p, t, a) in points {
        let value = |symbol: Symbol| match symbol {
            Symbol::Position(i) => q[i as usize],
            Symbol::Momentum(i) => p[i as usize],
            Symbol::Time => t,
            Symbol::Parameter(0) => a,
            Symbol::Parameter(n) => outside(&lowered.constants[n as usize - 1].to_string()),
            other => panic!("an energy has no {other:?}"),
        };
        let (expected, found) = (rust(q, p, t, a), eval(&lowered.graph, lowered.terms.energy, &value));
        let same = (expected - found).abs() <= 1e-14 * expected.abs().max(1.0) || expected.is_nan() && found.is_nan();
        assert!(same, "{body}\nrustc: {expected}, graph: {found}");
    }
}

/// Asserts that the graph of a body has the value that rustc computes.
macro_rules! agrees {
    (|$q:pat_param, $p:pat_param, $t:pat_param, $a:pat_param| { $($body:tt)* }) => {{
        #[allow(
            unused, clippy::all, clippy::pedantic, non_upper_case_globals,
            reason = "odd code is the point"
        )]
        fn energy($q: [f64; 3], $p: [f64; 3], $t: f64, $a: f64) -> f64 { $($body)* }
        compare(stringify!($($body)*), energy);
    }};
}

/// Asserts that a body compiles, and that the macro refuses it with one message that contains the given text.
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

// These modules use the macros above.
mod assignments;
mod constants;
mod elements;
mod expressions;
mod loops;
mod names;
