//! Conditions that differ on a boundary alone. A solution that leaves the boundary at once is no counterexample; a solution that stays is one.

use super::messages::{messages, messages_of};
use crate::parse::Form;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the messages for a field in the plane with an integral.
fn plane(integral: TokenStream, first: TokenStream, second: TokenStream) -> String {
    let item = quote! { fn f(x: [f64; 2], t: f64, a: f64) -> [f64; 2] { [#first, #second] } };
    messages(quote!(keeps(i = #integral)), item)
}

/// `0 < x` and `0 ≤ x` differ on x = 0 only, and solutions cross this boundary.
#[test]
fn sides_without_an_interior_are_no_counterexample() {
    let one = quote!(1.0);
    for (integral, first, second) in [
        (quote!(x[1] - x[0].max(0.0)), one.clone(), quote!(if x[0] > 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1] - (x[0].max(1.0) - x[0].min(1.0) - (x[0] - 1.0).abs())), one.clone(), quote!(0.0)),
        (quote!(x[1] - x[0].abs()), one.clone(), quote!(if x[0] > 0.0 { 1.0 } else { -1.0 })),
        (
            quote!(x[0].max(x[1]) - t),
            quote!(if x[0] > x[1] { 1.0 } else { 2.0 }),
            quote!(if x[0] > x[1] { 3.0 } else { 1.0 }),
        ),
        (quote!(x[0].max(x[1]) + x[0].min(x[1]) - t), quote!(0.0), one.clone()),
        (quote!(x[1] - t.max(0.0)), one.clone(), quote!(if t > 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1] - (t - 5.0).max(0.0)), one.clone(), quote!(if t > 5.0 { 1.0 } else { 0.0 })),
        (quote!(x[1] - (x[0] - a).max(0.0)), one.clone(), quote!(if x[0] > a { 1.0 } else { 0.0 })),
        // The difference has the other sign and a positive factor.
        (quote!(x[1] - x[0].max(0.0)), one.clone(), quote!(if -2.0 * x[0] < 0.0 { 1.0 } else { 0.0 })),
        // More than two conditions, which exclude each other.
        (quote!(x[1]), one.clone(), quote!(if x[0] > 1.0 && x[1] > 1.0 && x[0] + x[1] < 2.0 { 1.0 } else { 0.0 })),
        (quote!(x[1]), one.clone(), quote!(if x[0] * x[0] + x[1] * x[1] < 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1]), one.clone(), quote!(if x[0] >= 0.0 && x[0] <= 0.0 { 1.0 } else { 0.0 })),
    ] {
        let found = plane(integral.clone(), first, second);
        assert_eq!(found, "", "{integral}");
    }
}

/// The control: sides with an interior, a boundary along which solutions move, and a condition on parameters only.
#[test]
fn true_counterexamples_are_refused() {
    let one = quote!(1.0);
    for (integral, first, second) in [
        (quote!(x[1] - x[0].max(0.0)), one.clone(), quote!(if x[0] > 0.5 { 1.0 } else { 0.0 })),
        (quote!(x[1] - x[0].max(0.0)), one.clone(), quote!(if x[0] < 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1] - x[0].max(0.0)), one.clone(), quote!(if x[0] > 0.0 && x[1] > 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1] - x[0].abs()), one.clone(), quote!(if x[0] > 0.0 { -1.0 } else { 1.0 })),
        (quote!(x[1]), one.clone(), quote!(if x[0] > 1.0 && x[1] > 1.0 && x[0] + x[1] < 3.0 { 1.0 } else { 0.0 })),
        // x₀ = 0 at all times.
        (quote!(x[1]), quote!(0.0), quote!(if x[0] >= 0.0 && x[0] <= 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1]), quote!(x[0]), quote!(if x[0] >= 0.0 && x[0] <= 0.0 { 1.0 } else { 0.0 })),
        (
            quote!(x[1]),
            quote!(if x[1] > 0.0 { x[0] } else { 1.0 }),
            quote!(if x[0] >= 0.0 && x[0] <= 0.0 { 1.0 } else { 0.0 }),
        ),
        // x₁ = 0 at all times. There x₀·x₁ is zero as well.
        (quote!(x[0] - t), quote!(if x[0] * x[1] >= 0.0 && x[0] * x[1] <= 0.0 { 2.0 } else { 1.0 }), quote!(0.0)),
        (quote!(x[1]), one.clone(), quote!(if a >= 0.0 && a <= 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1]), one.clone(), quote!(if x[0] == 0.0 { 1.0 } else { 0.0 })),
    ] {
        let found = plane(integral.clone(), first, second.clone());
        assert!(found.contains("`i` is not constant along the field"), "{integral}, {second}: {found}");
    }
}

/// S and its transpose cancel on both sides of x₀ = 0. Solutions cross x₀ = 0 and stay on x₂ = 0.
#[test]
fn structures_are_skew_on_both_sides_of_a_boundary() {
    let structured = |above: TokenStream, below: TokenStream| {
        let structure = quote!(structure = [[0.0, #above, 0.0], [#below, 0.0, 0.0], [0.0, 0.0, 0.0]]);
        let item = quote! { fn h(x: [f64; 3]) -> f64 { (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0 } };
        messages_of(Form::Hamiltonian, structure, item)
    };
    let crossed = structured(quote!(if x[0] > 0.0 { 1.0 } else { 2.0 }), quote!(if x[0] >= 0.0 { -1.0 } else { -2.0 }));
    assert_eq!(crossed, "");
    let apart = structured(quote!(if x[0] > 0.0 { 1.0 } else { 2.0 }), quote!(if x[0] >= 0.5 { -1.0 } else { -2.0 }));
    assert!(apart.contains("S is skew, but S[0][1] + S[1][0]"), "{apart}");
    let kept = structured(quote!(if x[2] > 0.0 { 1.0 } else { 2.0 }), quote!(if x[2] >= 0.0 { -1.0 } else { -2.0 }));
    assert!(kept.contains("S is skew, but S[0][1] + S[1][0]"), "{kept}");
}

/// x₀² = 1 has two solutions, and the integral jumps at one of them.
#[test]
fn an_integral_that_jumps_at_one_of_two_roots_is_refused() {
    let jumps = quote!(x[1] + if x[0] * x[0] > 1.0 { x[0].signum() } else { 1.0 });
    let found = plane(jumps, quote!(1.0), quote!(0.0));
    assert!(found.contains("it may jump where"), "{found}");
    let meets = quote!(x[1] + if x[0] * x[0] > 1.0 { x[0] * x[0] } else { 1.0 });
    assert_eq!(
        plane(
            meets,
            quote!(if x[0] * x[0] > 1.0 { 1.0 } else { 1.0 }),
            quote!(if x[0] * x[0] > 1.0 { -2.0 * x[0] } else { 0.0 })
        ),
        ""
    );
}

/// Rounding decides on which side of the boundary a solution moves.
#[test]
fn an_integral_that_jumps_along_solutions_is_refused() {
    let ring = |integral: TokenStream| plane(integral, quote!(x[1]), quote!(-x[0]));
    let square = quote!((x[0] * x[0] + x[1] * x[1]));
    for jump in [
        quote!(if #square > 1.0 { #square } else { 2.0 * #square }),
        quote!(#square * if #square > a { 2.0 } else { 1.0 }),
        quote!(#square + (#square - 1.0).signum()),
        quote!(#square + if x[0].hypot(x[1]) < 1.0 { 1.0 } else { 0.0 }),
    ] {
        let found = ring(jump.clone());
        assert!(found.contains("and solutions stay there, so that rounding decides its value"), "{jump}: {found}");
    }
    // Both sides are equal at the boundary. In the second integral, the boundary does not move.
    assert_eq!(ring(quote!(if #square > 1.0 { #square } else { 2.0 * #square - 1.0 })), "");
    assert_eq!(ring(quote!(#square * if a > 1.0 { 2.0 } else { 1.0 })), "");
    let resting = quote!(x[1] * if x[0] > 1.0 { 2.0 } else { 1.0 });
    assert_eq!(plane(resting, quote!(0.0), quote!(0.0)), "");
    let found = plane(quote!(x[1] + if x[0] > 0.0 { 1.0 } else { 0.0 }), quote!(1.0), quote!(0.0));
    assert!(found.contains("it may jump where x[0] = 0"), "{found}");
    let assumed = quote!(keeps(assume(i = if #square > 1.0 { #square } else { 2.0 * #square })));
    let item = quote! { fn f(x: [f64; 2]) -> [f64; 2] { [x[1], -x[0]] } };
    assert_eq!(messages(assumed, item), "");
}

/// The boundary x·y·(x² + y² − 1) = 0 has axes, on which rounded states stay, and a circle, off which rounding moves them.
#[test]
fn every_factor_of_a_boundary_counts() {
    let of_boundary = |boundary: TokenStream| {
        let integral = quote!((x[0] * x[0] + x[1] * x[1]) * if #boundary > 0.0 { 2.0 } else { 1.0 });
        plane(integral, quote!(-x[0] * x[1] * x[1]), quote!(x[0] * x[0] * x[1]))
    };
    for boundary in [quote!(x[0]), quote!(x[0] * x[1]), quote!(x[0].powi(3)), quote!(a * x[0])] {
        assert_eq!(of_boundary(boundary), "");
    }
    assert_eq!(of_boundary(quote!(-3.0 * x[0].powi(3) * x[1])), "");
    let found = of_boundary(quote!(x[0] * x[1] * (x[0] * x[0] + x[1] * x[1] - 1.0)));
    assert!(found.contains("and solutions stay there"), "{found}");
}

/// Every part of a boundary counts, and the values on the boundary do, too.
#[test]
fn jumps_on_parts_of_a_boundary_are_refused() {
    let (zero, one, x, y) = (quote!(0.0), quote!(1.0), quote!(x[0]), quote!(x[1]));
    for (integral, first, second) in [
        // The jump x vanishes on x = 0 only, and solutions cross y = 0.
        (quote!(if #x * #y > 0.0 { #x } else { 2.0 * #x }), &zero, &one),
        (quote!(if #x * #y + #x > 0.0 { #x } else { 2.0 * #x }), &zero, &one),
        (quote!(if #x * #x * #y > 0.0 { #x } else { 2.0 * #x }), &zero, &one),
        (quote!(if #x.sin() * #y > 0.0 { #x.sin() } else { 2.0 * #x.sin() }), &zero, &one),
        // `==` holds on neither side.
        (quote!(#y + if #x == 0.0 { 1.0 } else if #x < 0.0 { -1.0 } else { 1.0 }), &one, &zero),
        (quote!(#y + if #x <= 0.0 && !(#x < 0.0) { 1.0 } else { 0.0 }), &one, &zero),
        (quote!(#y + if #x != 0.0 { 1.0 } else { 0.0 }), &one, &zero),
        // Several conditions change on one surface.
        (quote!(#y + if #x > 0.0 && 2.0 * #x > 0.0 { 1.0 } else { 0.0 }), &one, &zero),
        (quote!(#y + if #x > 0.0 && #x.powi(3) > 0.0 { 1.0 } else { 0.0 }), &one, &zero),
        (quote!(#y + if #x < a && #x / a < 1.0 { 1.0 } else { 0.0 }), &one, &zero),
        (quote!(#y + if #x > 0.0 && #x.sinh() > 0.0 { 1.0 } else { 0.0 }), &one, &zero),
        // Solutions leave or reach x = 0, although the rate vanishes there: it has no finite slope, or jumps.
        (quote!((2.0 + #y) * if #x < 0.0 { 1.0 } else { 2.0 }), &quote!(if x[0] < 0.0 { 1.0 } else { x[0] }), &zero),
        (quote!((2.0 + #y) * if #x > 0.0 { 1.0 } else { 2.0 }), &quote!((x[0] * x[0]).cbrt()), &zero),
        (quote!((2.0 + #y) * if #x > 0.0 { 1.0 } else { 2.0 }), &quote!(x[0].abs().sqrt()), &zero),
        (quote!((2.0 + #y) * if #x > 0.0 { 1.0 } else { 2.0 }), &quote!(x[0].abs().powf(0.25)), &zero),
        (quote!((2.0 + #y) * if (#x - 1.0).powi(3) > 0.0 { 1.0 } else { 2.0 }), &one, &zero),
    ] {
        let found = plane(integral.clone(), first.clone(), second.clone());
        assert!(found.contains(" jump where") || found.contains("solutions stay there"), "{integral}: {found}");
    }
}

/// A turn of an angle may add a multiple of one constant to an integral, and nothing else.
#[test]
fn turns_that_change_more_than_a_constant_are_refused() {
    let angle = quote!(x[1].atan2(x[0]));
    let turning = |integral: TokenStream| plane(integral, quote!(-x[1]), quote!(x[0]));
    for integral in [quote!(#angle - t), quote!(a * #angle - a * t), quote!((2.0 * (#angle - t)).cos())] {
        assert_eq!(turning(integral), "");
    }
    for integral in [
        quote!((#angle - t).powi(2)),
        quote!((0.5 * (#angle - t)).cos()),
        quote!((#angle - t).max(0.0)),
        quote!((x[0] * x[0] + x[1] * x[1]) * (#angle - t)),
    ] {
        let found = turning(integral.clone());
        assert!(found.contains("jump"), "{integral}: {found}");
    }
}

/// An angle whose arguments have a common factor jumps by less than a turn.
#[test]
fn angles_of_two_zeros_are_refused() {
    let of_energy = |sine: &TokenStream, cosine: &TokenStream| {
        let item = quote! { fn h(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
            let x = q;
            (p[0] * p[0] + p[1] * p[1]) / 2.0 + k * (#sine).atan2(#cosine)
        } };
        messages_of(Form::Hamiltonian, quote!(), item)
    };
    let (x, y) = (quote!(x[0]), quote!(x[1]));
    for (sine, cosine) in [
        (quote!(#x * #x), x.clone()),
        (x.clone(), quote!(#x * #x)),
        (quote!(#x * #y), x.clone()),
        (quote!(#x * #y), quote!(-2.0 * #x)),
        (quote!(#x.powi(3) * #y), quote!(#x.powi(3))),
        (quote!(#x.powi(4)), quote!(#x.powi(3) * #y)),
        (quote!(0.0), x.clone()),
        (x.clone(), quote!(0.0)),
        (quote!(#x.abs()), x.clone()),
        (quote!(#x.max(0.0)), x.clone()),
        (quote!(#x * (1.0 + #y)), quote!(#x + #x * #x)),
        (quote!(#x * #x + #x * #y), quote!(#x * #x - #x * #y)),
        (quote!(#x.sin() * #y), quote!(#x.sin())),
        (quote!((#x - 1.0) * #y), quote!(1.0 - #x)),
        (quote!(#x * #x - #y * #y), quote!(#x - #y)),
        (quote!(#x.cbrt() * #y), quote!(#x.cbrt())),
        // The order of a zero is hidden: in a factor that vanishes on the same surface, and behind a relation that is not proven.
        (quote!(#x * #x - #y * #y), quote!(#x * #x - 2.0 * #x * #y + #y * #y)),
        (quote!(#x - #y - 1.0), quote!(#x * k.sqrt() - #y * k.sqrt() - k.sqrt())),
        (quote!((#x * #x) * (#x + #x * #y).powi(2)), quote!(#x.powi(3))),
        (quote!(#x * #x * (#y.sinh().asinh() - #y) + #x.powi(3)), quote!(#x.powi(4))),
    ] {
        let found = of_energy(&sine, &cosine);
        assert!(found.contains("both arguments of this `atan2` vanish where"), "{sine}, {cosine}: {found}");
    }
    for (sine, cosine) in [
        (y.clone(), x.clone()),
        (quote!(#x.sin()), quote!(#x.cos())),
        (quote!(#x * #x * #y), quote!(#x * #x)),
        (quote!(#x.powi(3)), quote!(#x * #x)),
        (quote!(#x.powi(3)), quote!(1.0 + #x)),
        (quote!(#x.abs() * #y), quote!(#x.abs())),
        (quote!(k * #y), quote!(k * #x)),
        (quote!(#x * #y), quote!(1.0 + #x * #x)),
        (quote!(k.sqrt() * (#x - #y)), quote!(#x + #y)),
        (quote!(#y.exp() * #x), quote!(#y.exp() * #y)),
    ] {
        assert_eq!(of_energy(&sine, &cosine), "", "{sine}, {cosine}");
    }
    // The solution crosses the jump, does not cross it, or the integral is assumed.
    let crossed = quote!(#y - ((#x * #x).atan2(#x) - #x.atan()));
    let found = plane(crossed.clone(), quote!(1.0), quote!(0.0));
    assert!(found.contains("both arguments of this `atan2` vanish where x[0] = 0"), "{found}");
    assert_eq!(plane(crossed.clone(), quote!(#x), quote!(0.0)), "");
    assert_eq!(
        messages(quote!(keeps(assume(i = #crossed))), quote! { fn f(x: [f64; 2]) -> [f64; 2] { [1.0, 0.0] } }),
        ""
    );
}
