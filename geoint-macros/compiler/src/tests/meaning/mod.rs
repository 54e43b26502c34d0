//! Does lowering understand Rust as rustc does? Each body is compiled by rustc and lowered to a graph, and both are
//! evaluated; or it is one that the macro has to refuse, because it could not follow what rustc makes of it.

use crate::ir::Symbol;
use crate::tests::eval::eval;
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

/// The body means to the graph what it means to rustc.
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

// Below the macros, which they use.
mod assignments;
mod constants;
mod elements;
mod expressions;
mod loops;
mod names;
