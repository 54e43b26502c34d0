//! Messages for invalid Lagrangians and impossible requirements.

use crate::parse::Form;
use crate::tests::expansion;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the start of the message for a Lagrangian. Panics if the macro accepts it.
fn message(args: TokenStream, item: TokenStream) -> String {
    let expanded = expansion(Form::Lagrangian, args, item);
    let start = expanded.find("compile_error").unwrap_or_else(|| panic!("accepted: {expanded}"));
    expanded[start..].chars().take(400).collect()
}

#[test]
fn flawed_friction_is_refused() {
    let pendulum = quote! { fn f(q: f64, v: f64, m: f64, c: f64) -> f64 { m * v * v / 2.0 + q.cos() } };
    for (rayleigh, word) in [
        (quote!(c * v.powi(3)), "odd degree"),
        (quote!(c * v * v + c * v), "vanishes there"),
        (quote!(-v * v), "takes energy away"),
    ] {
        let message = message(quote!(rayleigh = #rayleigh), pendulum.clone());
        assert!(message.contains(word), "{rayleigh}: {message}");
    }
    let herglotz = quote! { fn f(q: f64, v: f64, s: f64, c: f64) -> f64 { v * v / 2.0 + q.cos() - c * s } };
    // With an action, friction does not change the rates, but it must still be valid.
    let flawed = message(quote!(rayleigh = -v * v), herglotz.clone());
    assert!(flawed.contains("takes energy away"), "{flawed}");
    let required = message(quote!(rayleigh = c * v * v, require(quadratic_kinetic)), herglotz);
    assert!(required.contains("leaves no contact map"), "{required}");
}

/// The message of a failed requirement names the term.
#[test]
fn requirements_name_the_term() {
    let bead = quote! { fn f(q: f64, v: f64, m: f64) -> f64 { 0.5 * m * (1.0 + 4.0 * q * q) * v * v - q * q } };
    let stiff = quote! { fn f(q: f64, v: f64, m: f64) -> f64 { 0.5 * m * v * v + 0.25 * v.powi(4) - q * q } };
    let vortex = quote! { fn f(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        m * q[0] * v[1] - q[0] * q[0] - q[1] * q[1]
    } };
    let chain = quote! { fn f(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
        m * (v[0] * v[0]
            + v[1] * v[1]
            + v[2] * v[2]
            + v[0] * v[1] * (q[0] - q[1]).cos()
            + v[1] * v[2] * (q[1] - q[2]).cos())
    } };
    let fading = quote! { fn f(q: f64, v: f64, s: f64, m: f64) -> f64 { 0.5 * m * (1.0 + q * q) * v * v - s } };
    for (required, of, words) in [
        (quote!(constant_mass), &bead, ["is not constant", "q²"]),
        (quote!(quadratic), &stiff, ["not quadratic in the velocities", "v⁴"]),
        (quote!(constant_mass), &stiff, ["not quadratic in the velocities", "v⁴"]),
        (quote!(regular), &vortex, ["do not follow from momenta", ""]),
        (quote!(quadratic), &vortex, ["no kinetic energy", ""]),
        (quote!(constant_mass), &chain, ["is not constant", "cos"]),
        (quote!(separable), &chain, ["kick and drift do not exist", "cos"]),
        (quote!(separable), &fading, ["T(p) + g·s + V(q)", "p"]),
        (quote!(conservative), &fading, ["reads the action", "s"]),
        (quote!(smooth), &chain, ["what can be required is", "`regular`"]),
    ] {
        let message = message(quote!(require(#required)), of.clone());
        assert!(words.iter().all(|word| message.contains(word)), "{required}: {message}");
    }
    for (required, of) in [
        (quote!(quadratic, regular), bead),
        (quote!(regular, conservative), stiff),
        (quote!(quadratic, regular, conservative), chain),
        (quote!(quadratic, regular), fading),
    ] {
        let expanded = expansion(Form::Lagrangian, quote!(require(#required)), of);
        assert!(!expanded.contains("compile_error"), "{required}: {expanded}");
    }
}

/// The message names a combination of velocities without inertia.
#[test]
fn singular_mass_matrices_name_a_motion() {
    let one_mass = quote! { fn f(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        0.5 * m * (v[0] + v[1] * q[0].cos()).powi(2) - q[1] * q[1]
    } };
    let message = message(quote!(), one_mass);
    assert!(message.contains("a motion with `v[0]` = -cos(q[0]), `v[1]` = 1 has no inertia"), "{message}");
}

/// A mass that depends on the direction of motion has no formula for H. Steps solve for velocities.
#[test]
fn branches_on_velocities_are_solved_for() {
    let ratchet = quote! { fn f(q: f64, v: f64, m: f64) -> f64 {
        (if v > 0.0 { m * v * v } else { 2.0 * m * v * v }) - q * q
    } };
    let expanded = expansion(Form::Lagrangian, quote!(), ratchet.clone());
    assert!(!expanded.contains("compile_error"), "{expanded}");
    assert!(expanded.contains("type Step = VelocityStages"), "{expanded}");
    assert!(message(quote!(require(separable)), ratchet).contains("kick and drift do not exist"));
}
