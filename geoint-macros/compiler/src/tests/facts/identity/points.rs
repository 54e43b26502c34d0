//! The rules of a proof by points of a finite field, and false identities that must not pass.

use super::{arrays, length};
use crate::analyze::{Identity, Proof, Why, identity};
use proc_macro2::TokenStream;
use quote::quote;

/// A word for the answer to each entry of an array.
fn answers(array: &TokenStream) -> Vec<String> {
    let (mut graph, roots) = arrays(4, &quote!(let [q, p, u, v] = x;), &[array]);
    roots[0].iter().map(|root| word(&identity(&mut graph, *root)).into()).collect()
}

pub(super) fn word(verdict: &Identity) -> &'static str {
    match verdict {
        Identity::Zero(Proof::Multiplied) => "multiplied",
        Identity::Zero(Proof::Points(_)) => "points",
        Identity::Wrong(wrong) if wrong.branch => "wrong, a branch",
        Identity::Wrong(_) => "wrong",
        Identity::Open(open) => match open.why {
            Why::Relation => "relation",
            Why::Branch => "branch",
            Why::TooLong => "too long",
            Why::Nowhere => "nowhere",
        },
    }
}

macro_rules! check {
    ($($difference:expr, $answer:expr;)*) => {{
        let all = quote!([$($difference),*]);
        let expected = [$($answer),*];
        assert_eq!(length(&all), expected.len());
        let texts = [$(stringify!($difference)),*];
        for ((found, expected), text) in answers(&all).into_iter().zip(expected).zip(texts) {
            let right = found == expected || expected == "zero" && (found == "multiplied" || found == "points");
            assert!(right, "{text} is {found}, not {expected}");
        }
    }};
}

#[test]
fn what_vanishes_for_one_choice_of_signs_only_is_not_proven() {
    check! {
        // The first is wrong where q is negative; the second holds wherever the roots are real.
        (q * q).sqrt() - q, "wrong, a branch";
        q.sqrt() * p.sqrt() - (q * p).sqrt(), "branch";
        (q + 1.0).sqrt() * (q - 1.0).sqrt() - (q * q - 1.0).sqrt(), "branch";
        ((q - 1.0) * (q - 1.0)).sqrt() - (q - 1.0), "wrong, a branch";
        (u * u + 1.0).sqrt() * (v * v + 1.0).sqrt() - ((u * u + 1.0) * (v * v + 1.0)).sqrt(), "branch";
        // Zero unless q, p, u and v are all negative, which is one of sixteen combinations.
        ((q * q).sqrt() - q) * ((p * p).sqrt() - p) * ((u * u).sqrt() - u) * ((v * v).sqrt() - v), "wrong, a branch";
        // A product over both signs of a root is zero for each sign.
        ((q * q).sqrt() - q) * ((q * q).sqrt() + q), "zero";
        ((1.0 + u.sqrt()).sqrt()).powi(2) - 1.0 - u.sqrt(), "zero";
        (1.0 + u.sqrt()).sqrt() * (1.0 - u.sqrt()).sqrt() - (1.0 - u).sqrt(), "branch";
        ((q * q + p * p).sqrt() + q) * ((q * q + p * p).sqrt() - q) - p * p, "zero";
        1.0 / ((q * q + p * p).sqrt() - q) - ((q * q + p * p).sqrt() + q) / (p * p), "zero";
        q.abs() * p.abs() - (q * p).abs(), "relation";
        q.abs() * q.signum() - q, "zero";
        (q - p).abs() - (p - q).abs(), "zero";
        q.max(p) + q.min(p) - q - p, "zero";
        q.max(p) - q.min(p) - (p - q).abs(), "zero";
        q.hypot(p).powi(2) - q * q - p * p, "zero";
    }
}

/// Square roots of ratios are exact: √3 is not 1.7320508075688772.
#[test]
fn roots_of_numbers_are_roots() {
    check! {
        (3.0_f64).sqrt() * (3.0_f64).sqrt() * q - 3.0 * q, "zero";
        ((3.0_f64).sqrt() * q + p) * ((3.0_f64).sqrt() * q - p) - 3.0 * q * q + p * p, "zero";
        (1.0 + (2.0_f64).sqrt() * q) * (1.0 - (2.0_f64).sqrt() * q) - 1.0 + 2.0 * q * q, "zero";
        (6.0_f64).sqrt() * q - (2.0_f64).sqrt() * (3.0_f64).sqrt() * q, "zero";
        (12.0_f64).sqrt() * q - 2.0 * (3.0_f64).sqrt() * q, "zero";
        q / (3.0_f64).sqrt() - (3.0_f64).sqrt() * q / 3.0, "zero";
        ((0.75_f64).sqrt() * q + u.sin()).powi(2) - 0.75 * q * q - (3.0_f64).sqrt() * q * u.sin() - u.sin().powi(2), "zero";
        // √3·q + √2·p and its conjugates.
        ((3.0_f64).sqrt() * q + (2.0_f64).sqrt() * p).powi(8) * ((3.0_f64).sqrt() * q - (2.0_f64).sqrt() * p).powi(8)
            - (3.0 * q * q - 2.0 * p * p).powi(8), "zero";
        // One sign is wrong, or the last digits are.
        (3.0_f64).sqrt() * (3.0_f64).sqrt() * q + 3.0 * q, "wrong";
        (6.0_f64).sqrt() * q + (2.0_f64).sqrt() * (3.0_f64).sqrt() * q, "wrong";
        ((3.0_f64).sqrt() * q + (2.0_f64).sqrt() * p).powi(2) - 3.0 * q * q - 2.0 * p * p + 2.0 * (6.0_f64).sqrt() * q * p, "wrong";
    }
}

#[test]
fn relations_between_functions() {
    check! {
        q.sin().powi(2) + q.cos().powi(2) - 1.0, "zero";
        (q + p).exp() - q.exp() * p.exp(), "zero";
        (q / 2.0).exp().powi(2) - q.exp(), "zero";
        (2.0 * q).exp() - q.exp(), "wrong";
        (q - p).sin() + (p - q).sin(), "zero";
        (q - p).sin() - q.sin() * p.cos() + q.cos() * p.sin(), "points";
        (q - p).cos() - q.cos() * p.cos() - q.sin() * p.sin(), "points";
        (q - p).cos() - q.cos() * p.cos() + q.sin() * p.sin(), "wrong";
        (3.0 * q).sin() - 3.0 * q.sin() + 4.0 * q.sin().powi(3), "points";
        (a * (q + p)).sin() - (a * q).sin() * (a * p).cos() - (a * q).cos() * (a * p).sin(), "points";
        (0.1 * q).cos().powi(2) - (1.0 + (0.2 * q).cos()) / 2.0, "points";
        // Coefficients with long denominators.
        (std::f64::consts::TAU * q).sin() - 2.0 * (std::f64::consts::PI * q).sin() * (std::f64::consts::PI * q).cos(), "points";
        (std::f64::consts::PI * (q + p)).exp() - (std::f64::consts::PI * q).exp() * (p * std::f64::consts::PI).exp(), "zero";
        (std::f64::consts::TAU * q).sin() - 2.0 * (std::f64::consts::PI * q).sin() * (std::f64::consts::E * q).cos(), "wrong";
        q.tan() - q.sin() / q.cos(), "zero";
        (2.0 * q).tan() * (1.0 - q.tan().powi(2)) - 2.0 * q.tan(), "points";
        q.tanh() - q.sinh() / q.cosh(), "zero";
        q.cosh().powi(2) - q.sinh().powi(2) - 1.0, "zero";
        (q + p).tanh() * (1.0 + q.tanh() * p.tanh()) - q.tanh() - p.tanh(), "zero";
        q.exp_m1() + 1.0 - q.exp(), "zero";
        q.exp2() * p.exp2() - (q + p).exp2(), "zero";
        (q + 3.0).exp2() - 8.0 * q.exp2(), "points";
        (q * p).ln() - q.ln() - p.ln(), "points";
        (q / p.powi(2)).ln() - q.ln() + 2.0 * p.ln(), "points";
        (2.0 * q + 2.0 * p).ln() - (q + p).ln() - (3.0 * u + 3.0 * v).ln() + (u + v).ln(), "wrong";
        (2.0 * q + 2.0 * p).ln() - (q + p).ln() - (2.0 * u + 2.0 * v).ln() + (u + v).ln(), "points";
        q.ln_1p() - (1.0 + q).ln(), "zero";
        (q * q.exp()).ln() - q.ln() - q, "points";
        (3.0 * q.ln()).exp() - q.powi(3), "points";
        q.log2() - (q / p).log2() - p.log2(), "points";
        q.powf(a) * q.powf(b) - q.powf(a + b), "points";
        q.powf(a + 1.0) - q * q.powf(a), "points";
        q.powf(0.3) * q.powf(0.7) - q, "zero";
        q.cbrt().powi(3) - q, "zero";
        (q * p).atan() - (p * q).atan(), "zero";
        (q - p).atan() + (p - q).atan(), "zero";
        (q * q + 1.0).atan() + (1.0 / (q * q + 1.0)).atan() - std::f64::consts::FRAC_PI_2, "relation";
        q.asin().sin() - q, "relation";
        // A zero inside of a function.
        ((2.0 * q).sin() - 2.0 * q.sin() * q.cos()).atan(), "points";
        ((2.0 * q).cos() + 2.0 * q.sin().powi(2) + p).ln() - (1.0 + p).ln(), "points";
        p.atan2(q) - (p / q).atan(), "wrong";
    }
}

#[test]
fn decimals_are_as_they_are_written() {
    check! {
        (3.0 * 0.1 - 0.3) * q, "zero";
        (0.1 * q).exp().powi(3) - (0.3 * q).exp(), "zero";
        (0.1 * q + 0.2 * p).sin() - (0.1 * q).sin() * (0.2 * p).cos() - (0.1 * q).cos() * (0.2 * p).sin(), "points";
        1e-20 * q * q, "wrong";
        // The cube root of a number is rounded when the code is lowered.
        3.0_f64.cbrt().powi(3) * q - 3.0 * q, "relation";
        (3.0_f64.sqrt() * q) * (3.0_f64.sqrt() * p) - 3.0 * q * p, "zero";
    }
}

#[test]
fn roots_that_are_not_residues_are_drawn_nevertheless() {
    check! {
        u.sqrt() * (3.0 * u).sqrt() * u.sqrt() * (3.0 * u).sqrt() - 3.0 * u * u, "zero";
        (3.0 * u + 3.0).sqrt().powi(2) - 3.0 * u - 3.0, "zero";
        (u + 1.0).sqrt() * (3.0 * u + 3.0).sqrt() - (3.0 * (u + 1.0).powi(2)).sqrt(), "branch";
        (u + 1.0).sqrt() * (6.0 * u + 6.0).sqrt() - 2.0 * (u + 1.0), "wrong";
        (2.0 + (3.0 * u * u).sqrt()).sqrt().powi(4) - (2.0 + (3.0 * u * u).sqrt()).powi(2), "zero";
    }
}

#[test]
fn both_sides_of_conditions_are_seen() {
    check! {
        if q < 0.0 { -q } else { q } - q.abs(), "points";
        if q < p { (q + p).sin() } else { q.sin() * p.cos() + q.cos() * p.sin() } - (q + p).sin(), "points";
        if q < p { (q + p).sin() } else { q.sin() * p.cos() - q.cos() * p.sin() } - (q + p).sin(), "wrong";
        if q < 0.0 { 0.0 } else { q.abs() - q }, "points";
        if q > 0.0 { 0.0 } else { q.signum() + 1.0 }, "wrong";
        // The boundary is a separate case.
        if q < 0.0 { 0.0 } else if q <= 0.0 { (q + p).sin() } else { 0.0 }, "wrong";
        if q == 0.0 { (q + p).sin() } else { 0.0 }, "wrong";
        if q == 0.0 { p.sin().powi(2) - (1.0 - (2.0 * p).cos()) / 2.0 } else { 0.0 }, "points";
    }
}

#[test]
fn what_is_divided_by_is_not_zero_for_any_choice() {
    // For q > 0 the second term is not defined although the first one is, so there is no proof.
    check! {
        if q < 0.0 { a / (q.abs() - q) } else { q } - a / (q.abs() - q), "too long";
    }
}

#[test]
fn what_is_too_long_is_evaluated() {
    check! {
        (q + p + u + v).powi(20) * (a + b + c + d).powi(20) - ((q + p + u + v) * (a + b + c + d)).powi(20), "points";
        (q + p + u + v).powi(30) * (a + b - c).powi(30) - ((q + p + u + v) * (a - b - c)).powi(30), "wrong";
    }
}

#[test]
fn more_roots_than_are_combined_are_unknowns() {
    // An identity with ten roots is proven if it does not depend on their values; otherwise it is not decided.
    let sum = |signs: [i32; 10]| {
        let terms = signs.iter().enumerate().map(|(k, sign)| {
            let (k, sign) = (f64::from(k as u32) + 1.0, f64::from(*sign));
            quote!(#sign * (q * q + #k).sqrt() * p)
        });
        quote!((#(#terms)+*))
    };
    let one = sum([1; 10]);
    let squares = (1..=10).map(|k| {
        let k = f64::from(k);
        quote!((((q * q + #k).sqrt() + u).powi(2) - (q * q + #k) - 2.0 * u * (q * q + #k).sqrt() - u * u))
    });
    let found = answers(&quote!([
        (#one + u).powi(9) * (#one - v).powi(9) - ((#one + u) * (#one - v)).powi(9),
        ((#one + u).powi(9) - (#one - v).powi(9)) * #(#squares *)* 1.0
    ]));
    assert_eq!(found[0], "points");
    assert!(found[1] == "multiplied" || found[1] == "too long", "{}", found[1]);
}

#[test]
fn the_bound_is_stated() {
    let (mut graph, roots) = arrays(1, &quote!(), &[&quote!([(2.0 * x[0]).sin() - 2.0 * x[0].sin() * x[0].cos()])]);
    let Identity::Zero(Proof::Points(bound)) = identity(&mut graph, roots[0][0]) else { panic!("not proven") };
    assert_eq!(bound.points, 4);
    assert!(bound.degree >= 8 && bound.degree < 10_000, "{bound:?}");
    assert!(bound.bits > 120 && bound.bits < 240, "{bound:?}");
}
