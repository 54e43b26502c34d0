//! Random functions: arbitrary expressions of the language, and energies that are mostly valid.

use crate::parse::Form;
use proptest::prelude::*;

/// Draws an entry of a list with the separator ", ".
pub(in crate::tests) fn one_of(list: &'static str) -> impl Strategy<Value = &'static str> + Clone {
    prop::sample::select(list.split(", ").collect::<Vec<_>>())
}

/// Draws a leaf of an expression: a name, a number, or a short expression.
pub(super) fn leaf() -> impl Strategy<Value = String> {
    let leaves = "q, p, t, a, w, w[0], w[1], w[7], w[-1], w[a], G, W[1], x, y, s, e, f, i, 0, 1, 2, -1, 64, -65, 1.0, 0.0, \
        -0.0, 1e300, 1e400, 1e-400, 5e-324, 123456789012345678901234567890.0, \
        99999999999999999999999999999999999999999, true, (), [], [0.0;0], [0.0;3], f64::MAX, f64::NAN, \
        std::f64::consts::PI, 170141183460469231731687303715884105727, 'c', \"s\", (1.0,q), |z| z, return q, \
        break, continue, 0..3, 1..0, 0..1000000000, 0..=170141183460469231731687303715884105727, w.iter()";
    one_of(leaves).prop_map(str::to_string)
}

/// Draws an arbitrary expression.
fn expression() -> impl Strategy<Value = String> {
    let methods = "sin, cos, tan, exp, ln, sqrt, abs, recip, sum, norm, floor, sin_cos, to_radians, iter, rev, len, signum, \
        atanh, cbrt, count, enumerate, clone, unwrap";
    let binary =
        ["+", "-", "*", "/", "%", "<", "<=", "==", "!=", "&&", "||", "..", "..=", "&", "<<", "+=", "-=", "*=", "="];
    leaf().prop_recursive(5, 48, 4, move |inner| {
        let pair = (inner.clone(), inner.clone());
        prop_oneof![
            4 => (pair.clone(), prop::sample::select(binary.to_vec())).prop_map(|((a, b), op)| format!("({a}) {op} ({b})")),
            3 => (inner.clone(), one_of(methods)).prop_map(|(a, m)| format!("({a}).{m}()")),
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

/// Draws an arbitrary statement.
fn statement() -> impl Strategy<Value = String> {
    let expr = expression;
    prop_oneof![
        expr().prop_map(|a| format!("let x = {a};")),
        expr().prop_map(|a| format!("let (x, mut y) = {a};")),
        expr().prop_map(|a| format!("let [x, y] = {a};")),
        expr().prop_map(|a| format!("let mut e = {a};")),
        expr().prop_map(|a| format!("e += {a};")),
        expr().prop_map(|a| format!("e = {a};")),
        expr().prop_map(|a| format!("e *= {a};")),
        (expr(), expr()).prop_map(|(a, b)| format!("y[{a}] = {b};")),
        (expr(), expr()).prop_map(|(a, b)| format!("(x, e) = ({a}, {b});")),
        (expr(), expr()).prop_map(|(a, b)| format!("{a} = {b};")),
        (expr(), expr()).prop_map(|(a, b)| format!(
            "'a: for i in 0..3 {{ for j in 0..i {{ if {a} {{ continue 'a; }} e -= {b}; }} }}"
        )),
        (expr(), expr()).prop_map(|(a, b)| format!("for _ in 0..4 {{ e = e * ({a}) - x; x = {b}; }}")),
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

/// Returns the argument for the action, if the form has one.
fn action(form: Form) -> &'static str {
    match form {
        Form::Contact => "s: f64,",
        _ => "",
    }
}

/// Draws a function of arbitrary statements.
pub(super) fn function(form: Form) -> impl Strategy<Value = String> {
    let ty = "f64, f64, f64, [f64;2], [f64;0], [[f64;2];2], Vector3<f64>, f32, i32, &f64, [f64;N]";
    let ty = || one_of(ty);
    (ty(), prop::bool::weighted(0.9), ty(), prop::collection::vec(statement(), 0..4), expression()).prop_map(
        move |(q, equal, p, statements, last)| {
            let p = if equal { q } else { p };
            let (s, body) = (action(form), statements.join(" "));
            format!("fn energy(q: {q}, p: {p}, {s} t: f64, a: f64, w: [f64; 2]) -> f64 {{ {body} {last} }}")
        },
    )
}

/// Symbols and numbers, among them zero and the largest number.
pub(super) const LEAVES: [&str; 13] =
    ["q", "p", "t", "a", "w[0]", "w[1]", "2.0", "0.5", "3.0e-5", "0.0", "1.0", "K", "f64::MAX"];

/// Returns a random energy that is mostly valid.
pub(super) fn arithmetic(form: Form, leaves: &'static [&'static str]) -> impl Strategy<Value = String> {
    let actions = if form == Form::Contact { &["s", "s"][..] } else { &[] };
    let leaf = prop::sample::select([leaves, actions].concat()).prop_map(str::to_string);
    let methods = "sin, cos, tan, exp, ln, sqrt, abs, recip, tanh, atan, cosh, cbrt, exp2, ln_1p, asinh, signum, powi(2), \
        powi(-3), powf(1.5), powf(0.3), to_degrees, asin, acos, acosh, atanh, sinh, exp_m1, log2, log10, \
        powi(5), powf(-1.5), powf(-0.7), powf(p), powf(a), max(a), min(q), hypot(p), atan2(a)";
    let expr = leaf.prop_recursive(6, 40, 3, move |inner| {
        prop_oneof![
            3 => (inner.clone(), inner.clone(), prop::sample::select(vec!["+", "-", "*", "/"]))
                .prop_map(|(a, b, op)| format!("({a} {op} {b})")),
            3 => (inner.clone(), one_of(methods)).prop_map(|(a, m)| {
                if m.ends_with(')') { format!("({a}).{m}") } else { format!("({a}).{m}()") }
            }),
            1 => inner.clone().prop_map(|a| format!("(-{a})")),
            1 => (inner.clone(), inner.clone(), inner).prop_map(|(a, b, c)| format!("(if {a} < {b} {{ {c} }} else {{ {b} }})")),
        ]
    });
    expr.prop_map(move |e| {
        let s = action(form);
        format!("fn energy(q: f64, p: f64, {s} t: f64, a: f64, w: [f64; 2]) -> f64 {{ const K: f64 = 1.5; {e} }}")
    })
}
