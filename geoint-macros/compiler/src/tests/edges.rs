//! Divided differences at poles, kinks, zeros and the ends of domains.

use super::slopes::{Case, around_zero};
use crate::ir::{Function, Graph, Id, Number, Ratio};

type Build = Box<dyn Fn(&mut Graph, Id) -> Id>;

/// Each step starts inside the domain of a function. It ends outside, or beyond a pole.
#[test]
fn there_is_no_slope_across_a_pole() {
    let power = |n, m| move |g: &mut Graph, x| g.pow(x, Ratio { numerator: n, denominator: m });
    let call = |f| move |g: &mut Graph, x| g.call(f, &[x]);
    let quotient = |g: &mut Graph, x| {
        let (above, one) = (g.call(Function::Cos, &[x]), g.integer(1));
        let below = g.sub(x, one);
        g.div(above, below)
    };
    let powf = |g: &mut Graph, x| {
        let exponent = g.number(Number::float(-1.3));
        g.call(Function::Powf, &[x, exponent])
    };
    let steps: Vec<(&str, Build, f64, f64)> = vec![
        ("1/x", Box::new(power(-1, 1)), 0.3, -0.4),
        ("1/x²", Box::new(power(-2, 1)), 0.3, -0.4),
        ("1/x³", Box::new(power(-3, 1)), -0.3, 0.4),
        ("1/x⁶", Box::new(power(-6, 1)), 0.3, -0.1),
        ("1/x onto the pole", Box::new(power(-1, 1)), 0.3, 0.0),
        ("1/√x", Box::new(power(-1, 2)), 0.3, -0.4),
        ("√x", Box::new(power(1, 2)), 0.3, -0.4),
        ("√x³", Box::new(power(3, 2)), 0.3, -0.4),
        ("cos x/(x − 1)", Box::new(quotient), 0.8, 1.2),
        ("x^(−1.3)", Box::new(powf), 0.3, -0.1),
        ("tan x", Box::new(call(Function::Tan)), 1.4, 1.7),
        ("ln x", Box::new(call(Function::Ln)), 0.2, -0.1),
        ("ln(1 + x)", Box::new(call(Function::Ln1p)), -0.8, -1.1),
        ("asin x", Box::new(call(Function::Asin)), 0.8, 1.1),
        ("acos x", Box::new(call(Function::Acos)), -0.8, -1.1),
        ("acosh x", Box::new(call(Function::Acosh)), 1.2, 0.9),
        ("atanh x", Box::new(call(Function::Atanh)), 0.8, 1.1),
        ("atanh x, below", Box::new(call(Function::Atanh)), -0.8, -1.1),
    ];
    for (name, build, a, b) in steps {
        let case = Case::new(name.into(), around_zero(1.0), build);
        assert!(case.at(case.slope, a, b - a).is_nan(), "{name}");
        assert!(case.at(case.slope, a, 1e-3 * (b - a)).is_finite(), "{name}");
    }
}

/// At a kink, or where a power has no second derivative, a zero step gives the derivative.
#[test]
fn slopes_at_zero_are_those_of_the_limit() {
    let half = |n| move |g: &mut Graph, x| g.pow(x, Ratio { numerator: n, denominator: 2 });
    let powf = |exponent| {
        move |g: &mut Graph, x| {
            let (exponent, size) = (g.number(Number::float(exponent)), g.call(Function::Abs, &[x]));
            g.call(Function::Powf, &[size, exponent])
        }
    };
    // The overlap of two grains, which is zero most of the time.
    let contact = |g: &mut Graph, x| {
        let zero = g.zero();
        let overlap = g.call(Function::Max, &[x, zero]);
        g.pow(overlap, Ratio { numerator: 5, denominator: 2 })
    };
    let functions: [(&str, Build); 7] = [
        ("x^(3/2)", Box::new(half(3))),
        ("x^(5/2)", Box::new(half(5))),
        ("|x|^1.7", Box::new(powf(1.7))),
        ("|x|^2.7", Box::new(powf(2.7))),
        ("max(x, 0)^(5/2)", Box::new(contact)),
        ("|x|", Box::new(|g, x| g.call(Function::Abs, &[x]))),
        ("signum x", Box::new(|g, x| g.call(Function::Signum, &[x]))),
    ];
    for (name, build) in functions {
        let case = Case::new(name.into(), around_zero(1.0), build);
        let (met, derivative) = (case.at(case.slope, 0.0, 0.0), case.at(case.derivative, 0.0, 0.0));
        assert!((met - derivative).abs() < 1e-99, "{name}: {met:e} {derivative:e}");
        // The slope across a jump has no limit, so `signum` has no second derivative.
        assert!(name == "signum x" || case.at(case.second, 0.0, 0.0).is_finite(), "{name}");
        for d in [1e-310, 1e-9, 0.25, 3.0] {
            let (found, change) = (case.at(case.slope, 0.0, d) * d, case.at(case.value, d, 0.0));
            let change = change - case.at(case.value, 0.0, 0.0);
            assert!(
                (found - change).abs() <= 4.0 * f64::EPSILON * change.abs() + 1e-308,
                "{name}: {found:e} {change:e}"
            );
        }
    }
}
