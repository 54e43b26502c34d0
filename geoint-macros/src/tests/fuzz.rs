//! Can input make the macro panic, hang, lose the user's function, or emit what is not Rust? Random tokens, random
//! functions in random arithmetic, and valid energies with random damage.

use crate::parse::Form;
use crate::{expand, lower, parse};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use proptest::prelude::*;
use proptest::test_runner::Config;
use quote::quote;

/// What holds for all input.
fn holds(args: TokenStream, item: TokenStream) {
    let emitted = expand::expand(Form::Hamiltonian, args, item.clone());
    if syn::parse2::<syn::Item>(item.clone()).is_ok()
        && let Err(error) = syn::parse2::<syn::File>(emitted.clone())
    {
        panic!("{error}: {emitted}");
    }
    let same = emitted.into_iter().zip(item.clone()).all(|(out, input)| out.to_string() == input.to_string());
    assert!(same, "the function does not come first: {item}");
}

fn tokens(text: &str) -> Option<TokenStream> {
    text.parse().ok()
}

/// Few cases, unless a long hunt is asked for.
pub(super) fn config() -> Config {
    let cases = std::env::var("PROPTEST_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(300);
    Config { cases, failure_persistence: None, ..Config::default() }
}

// ---------------------------------------------------------------------------------------------------- random tokens

fn word() -> impl Strategy<Value = String> {
    let words = [
        "fn", "let", "mut", "for", "in", "if", "else", "while", "match", "return", "const", "async", "unsafe",
        "struct", "pub", "use", "as", "q", "p", "t", "x", "f64", "f32", "usize", "Vector3", "self", "1", "2.5",
        "1e400", "0", "+", "-", "*", "/", "%", "=", "+=", "==", "<", ">", "..", "..=", "&", "|", "!", "->", "=>", ",",
        ";", ":", "::", ".", "#", "'a", "\"s\"", "'c'", "require", "name", "crate", "sin", "sum", "map", "iter",
        "r#type", "_",
    ];
    prop::sample::select(words.to_vec()).prop_map(str::to_string)
}

fn token_text() -> impl Strategy<Value = String> {
    let leaf = prop::collection::vec(word(), 0..8).prop_map(|words| words.join(" "));
    leaf.prop_recursive(4, 64, 6, |inner| {
        (prop::collection::vec(inner, 0..4), 0..3_usize).prop_map(|(parts, kind)| {
            let [open, close] = [["(", ")"], ["[", "]"], ["{", "}"]][kind];
            format!("{open} {} {close}", parts.join(" "))
        })
    })
}

// ------------------------------------------------------------------------------------------------- random functions

fn leaf() -> impl Strategy<Value = String> {
    let leaves = [
        "q",
        "p",
        "t",
        "a",
        "w",
        "w[0]",
        "w[1]",
        "w[7]",
        "w[-1]",
        "w[a]",
        "G",
        "W[1]",
        "x",
        "y",
        "e",
        "f",
        "i",
        "0",
        "1",
        "2",
        "-1",
        "64",
        "-65",
        "1.0",
        "0.0",
        "-0.0",
        "1e300",
        "1e400",
        "1e-400",
        "5e-324",
        "123456789012345678901234567890.0",
        "99999999999999999999999999999999999999999",
        "true",
        "()",
        "[]",
        "[0.0; 0]",
        "[0.0; 3]",
        "f64::MAX",
        "f64::NAN",
        "std::f64::consts::PI",
        "170141183460469231731687303715884105727",
        "'c'",
        "\"s\"",
        "(1.0, q)",
        "|z| z",
        "return q",
        "break",
        "0..3",
        "1..0",
        "0..1000000000",
        "0..=170141183460469231731687303715884105727",
        "w.iter()",
    ];
    prop::sample::select(leaves.to_vec()).prop_map(str::to_string)
}

fn expression() -> impl Strategy<Value = String> {
    let methods = [
        "sin",
        "cos",
        "tan",
        "exp",
        "ln",
        "sqrt",
        "abs",
        "recip",
        "sum",
        "norm",
        "floor",
        "sin_cos",
        "to_radians",
        "iter",
        "rev",
        "len",
        "signum",
        "atanh",
        "cbrt",
        "count",
        "enumerate",
        "clone",
        "unwrap",
    ];
    let binary =
        ["+", "-", "*", "/", "%", "<", "<=", "==", "!=", "&&", "||", "..", "..=", "&", "<<", "+=", "-=", "*=", "="];
    leaf().prop_recursive(5, 48, 4, move |inner| {
        let pair = (inner.clone(), inner.clone());
        prop_oneof![
            4 => (pair.clone(), prop::sample::select(binary.to_vec())).prop_map(|((a, b), op)| format!("({a}) {op} ({b})")),
            3 => (inner.clone(), prop::sample::select(methods.to_vec())).prop_map(|(a, m)| format!("({a}).{m}()")),
            2 => (pair.clone(), prop::sample::select(vec!["powi", "powf", "pow", "min", "max", "hypot", "atan2", "map",
                "zip", "take", "skip", "windows", "filter", "flat_map", "dot", "rem_euclid"]))
                .prop_map(|((a, b), m)| format!("({a}).{m}({b})")),
            1 => inner.clone().prop_map(|a| format!("-({a})")),
            1 => inner.clone().prop_map(|a| format!("!({a})")),
            1 => inner.clone().prop_map(|a| format!("&mut ({a})")),
            1 => inner.clone().prop_map(|a| format!("*&({a})")),
            1 => (inner.clone(), prop::sample::select(vec!["f64", "f32", "i32", "u8", "usize", "i128", "Foo"]))
                .prop_map(|(a, ty)| format!("(({a}) as {ty})")),
            1 => (pair.clone(), inner.clone()).prop_map(|((a, b), c)| format!("if {a} {{ {b} }} else {{ {c} }}")),
            1 => pair.clone().prop_map(|(a, b)| format!("if {a} {{ {b} }}")),
            1 => pair.clone().prop_map(|(a, b)| format!("{{ let x = {a}; {b} }}")),
            1 => pair.clone().prop_map(|(a, b)| format!("({a})[{b}]")),
            1 => pair.clone().prop_map(|(a, b)| format!("[{a}, {b}]")),
            1 => pair.clone().prop_map(|(a, b)| format!("[{a}; {b}]")),
            1 => pair.clone().prop_map(|(a, b)| format!("f({a}, {b})")),
            1 => pair.clone().prop_map(|(a, b)| format!("(|x, y| {a})({b}, q)")),
            1 => pair.clone().prop_map(|(a, b)| format!("(0..3).map(|i| {a}).zip({b}).map(|(x, y)| x * y).sum::<f64>()")),
            1 => pair.prop_map(|(a, b)| format!("(({a}, {b}).0)")),
            1 => inner.clone().prop_map(|a| format!("f64::sin({a})")),
            1 => inner.prop_map(|a| format!("Vector3::new({a}, q, p).norm()")),
        ]
    })
}

fn statement() -> impl Strategy<Value = String> {
    let expr = expression;
    prop_oneof![
        expr().prop_map(|a| format!("let x = {a};")),
        expr().prop_map(|a| format!("let (x, mut y) = {a};")),
        expr().prop_map(|a| format!("let [x, y] = {a};")),
        expr().prop_map(|a| format!("let mut e = {a};")),
        expr().prop_map(|a| format!("e += {a};")),
        expr().prop_map(|a| format!("e = {a};")),
        expr().prop_map(|a| format!("const G: f64 = {a};")),
        expr().prop_map(|a| format!("const W: f64 = G; const G: f64 = W * ({a});")),
        expr().prop_map(|a| format!("fn f(x: f64, y: f64) -> f64 {{ {a} }}")),
        expr().prop_map(|a| format!("let f = |x, y| {a};")),
        (expr(), expr()).prop_map(|(a, b)| format!("for i in {a} {{ e += {b}; }}")),
        (expr(), expr()).prop_map(|(a, b)| format!("for (i, x) in ({a}).iter().enumerate() {{ {b}; }}")),
        (expr(), expr()).prop_map(|(a, b)| format!("if {a} {{ e -= {b}; }}")),
        expr().prop_map(|a| format!("while {a} {{}}")),
        expr().prop_map(|a| format!("assert!({a});")),
    ]
}

fn function() -> impl Strategy<Value = String> {
    let ty = [
        "f64",
        "f64",
        "f64",
        "[f64; 2]",
        "[f64; 0]",
        "[[f64; 2]; 2]",
        "Vector3<f64>",
        "f32",
        "i32",
        "&f64",
        "[f64; N]",
    ];
    let ty = || prop::sample::select(ty.to_vec());
    (ty(), prop::bool::weighted(0.9), ty(), prop::collection::vec(statement(), 0..4), expression()).prop_map(
        |(q, equal, p, statements, last)| {
            let p = if equal { q } else { p };
            let body = statements.join(" ");
            format!("fn energy(q: {q}, p: {p}, t: f64, a: f64, w: [f64; 2]) -> f64 {{ {body} {last} }}")
        },
    )
}

/// What is easy to compute with, and what is not.
const LEAVES: [&str; 13] = ["q", "p", "t", "a", "w[0]", "w[1]", "2.0", "0.5", "3.0e-5", "0.0", "1.0", "K", "f64::MAX"];

/// An energy that is valid for the most part.
pub(super) fn arithmetic(leaves: &'static [&'static str]) -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(leaves.to_vec()).prop_map(str::to_string);
    let methods = [
        "sin",
        "cos",
        "tan",
        "exp",
        "ln",
        "sqrt",
        "abs",
        "recip",
        "tanh",
        "atan",
        "cosh",
        "cbrt",
        "exp2",
        "ln_1p",
        "asinh",
        "signum",
        "powi(2)",
        "powi(-3)",
        "powf(1.5)",
        "powf(0.3)",
        "to_degrees",
        "asin",
        "acos",
        "acosh",
        "atanh",
        "sinh",
        "exp_m1",
        "log2",
        "log10",
        "powi(5)",
        "powf(-1.5)",
        "powf(-0.7)",
        "powf(p)",
        "powf(a)",
        "max(a)",
        "min(q)",
        "hypot(p)",
        "atan2(a)",
    ];
    let expr = leaf.prop_recursive(6, 40, 3, move |inner| {
        prop_oneof![
            3 => (inner.clone(), inner.clone(), prop::sample::select(vec!["+", "-", "*", "/"]))
                .prop_map(|(a, b, op)| format!("({a} {op} {b})")),
            3 => (inner.clone(), prop::sample::select(methods.to_vec())).prop_map(|(a, m)| {
                if m.ends_with(')') { format!("({a}).{m}") } else { format!("({a}).{m}()") }
            }),
            1 => inner.clone().prop_map(|a| format!("(-{a})")),
            1 => (inner.clone(), inner.clone(), inner).prop_map(|(a, b, c)| format!("(if {a} < {b} {{ {c} }} else {{ {b} }})")),
        ]
    });
    expr.prop_map(|e| {
        format!("fn energy(q: f64, p: f64, t: f64, a: f64, w: [f64; 2]) -> f64 {{ const K: f64 = 1.5; {e} }}")
    })
}

// ----------------------------------------------------------------------------------------------------------- damage

const ENERGIES: [&str; 3] = [
    "/// Pendulum.
    pub fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 { p * p / (2.0 * m * l * l) - m * g * l * q.cos() }",
    "fn bodies(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], t: f64) -> f64 {
        const G: f64 = 6.67e-11;
        fn square(x: [f64; 2]) -> f64 { x.iter().map(|x| x * x).sum() }
        let mut e = t.sin() * q[0][0];
        for i in 0..3 {
            e += square(p[i]) / (2.0 * m[i]);
            for j in 0..i { e -= G * m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); }
        }
        e
    }",
    "fn chain(q: Vector3<f64>, p: Vector3<f64>, k: f64) -> f64 {
        let [a, b, c] = [q.x, q[1], q.z];
        let soft = |x: f64| if x > 0.0 && k < 1.0 { k * x.ln_1p() } else { x.powi(2) };
        let ring: f64 = (0..3).map(|i| soft(q[i] - q[(i + 1) % 3])).sum();
        0.5 * p.norm_squared() + ring + (a - b).powi(4) + c.abs()
    }",
];

/// What is done to the tokens of an energy.
#[derive(Clone, Debug)]
enum Damage {
    Remove,
    Double,
    Replace(String),
    Swap,
    Insert(String),
}

fn damage() -> impl Strategy<Value = (usize, Damage)> {
    let kind = prop_oneof![
        Just(Damage::Remove),
        Just(Damage::Double),
        Just(Damage::Swap),
        word().prop_map(Damage::Replace),
        leaf().prop_map(Damage::Replace),
        word().prop_map(Damage::Insert),
    ];
    (0..400_usize, kind)
}

/// The tokens with some damage at the token number `at`, counted through all groups.
fn damaged(stream: TokenStream, at: &mut usize, damage: &Damage) -> TokenStream {
    let mut out: Vec<TokenTree> = vec![];
    for tree in stream {
        let here = *at == 0;
        *at = at.wrapping_sub(1);
        let tree = match tree {
            TokenTree::Group(group) if !here => {
                TokenTree::Group(Group::new(group.delimiter(), damaged(group.stream(), at, damage)))
            }
            other => other,
        };
        match damage {
            Damage::Remove if here => {}
            Damage::Double if here => out.extend([tree.clone(), tree]),
            Damage::Replace(text) if here => out.extend(tokens(text).unwrap_or_default()),
            Damage::Insert(text) if here => out.extend(tokens(text).unwrap_or_default().into_iter().chain([tree])),
            Damage::Swap if here => {
                let before = out.pop();
                out.push(tree);
                out.extend(before);
            }
            _ => out.push(tree),
        }
    }
    out.into_iter().collect()
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn random_tokens(args in token_text(), item in token_text()) {
        if let (Some(args), Some(item)) = (tokens(&args), tokens(&item)) {
            holds(args, item);
        }
    }

    #[test]
    fn random_functions(text in function()) {
        if let Some(item) = tokens(&text) {
            holds(quote!(), item);
        }
    }

    #[test]
    fn random_arithmetic(text in arithmetic(&LEAVES)) {
        holds(quote!(), tokens(&text).expect("tokens"));
    }

    #[test]
    fn damaged_energies(which in 0..ENERGIES.len(), harm in prop::collection::vec(damage(), 1..4)) {
        let mut item = tokens(ENERGIES[which]).expect("tokens");
        for (at, damage) in harm {
            let mut at = at;
            item = damaged(item, &mut at, &damage);
        }
        holds(quote!(), item);
    }
}

// ---------------------------------------------------------------------------------------------- what stacks are for

/// What is said of a body within the stack of a thread of rustc, 8 MB; nothing if it is accepted.
fn said(body: String) -> String {
    let run = move || {
        let item = tokens(&format!("fn energy(q: f64, p: f64) -> f64 {{ {body} }}")).expect("tokens");
        holds(quote!(), item.clone());
        let energy = parse::energy(parse::Form::Hamiltonian, quote!(), syn::parse2(item).expect("a function"));
        let energy = energy.unwrap_or_else(|errors| panic!("{:?}", errors.messages()));
        lower::body(&energy).err().map_or_else(String::new, |errors| errors.messages().join("; "))
    };
    std::thread::Builder::new().stack_size(8 << 20).spawn(run).expect("a thread").join().expect("no panic")
}

#[test]
fn long_expressions_are_accepted() {
    assert_eq!(said(vec!["q * p"; 500].join(" + ")), "");
    assert_eq!(said(format!("{}{{ p }}", "if q < 1.0 { q } else ".repeat(50))), "");
    assert_eq!(said(format!("{}q{}", "(".repeat(100), ")".repeat(100))), "");
    assert_eq!(said(format!("let x = q; {} x", "let x = x.sin() * p + (x.sin() + 1.0) * q;".repeat(45))), "");
}

#[test]
fn deep_expressions_are_refused() {
    let deep = [
        format!("{}q{}", "(".repeat(300), ")".repeat(300)),
        format!("{}q", "- ".repeat(1000)),
        format!("{}q{}", "f64::sin(".repeat(300), ")".repeat(300)),
        format!("q{}", ".cos()".repeat(300)),
        format!("{}q{}", "{ let x = ".repeat(300), "; x }".repeat(300)),
        format!("{}{{ p }}", "if q < 1.0 { q } else ".repeat(300)),
        format!("let f = |x: f64| x; {} f(q)", "let f = |x: f64| f(x) + 1.0;".repeat(300)),
        format!("let x = q; {} x", "let x = x.sin() * p + (x.sin() + 1.0) * q;".repeat(70)),
    ];
    for body in deep {
        assert!(said(body).contains("nested too deeply"));
    }
}

#[test]
fn groups_without_delimiters() {
    // What a macro_rules! macro hands over as `$x:expr`.
    let inner = TokenTree::Group(Group::new(Delimiter::None, quote!(q + 1.0)));
    holds(quote!(), quote!(fn energy(q: f64, p: f64) -> f64 { p * p * #inner }));
}
