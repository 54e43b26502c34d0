//! Conditions that differ on a boundary alone. A solution that leaves the boundary at once is no counterexample; a solution that stays is one.

use super::messages::{messages, messages_of};
use crate::parse::Form;
use proc_macro2::TokenStream;
use quote::quote;

fn plane(integral: TokenStream, first: TokenStream, second: TokenStream) -> String {
    let item = quote!(
        fn f(x: [f64; 2], t: f64, a: f64) -> [f64; 2] {
            [#first, #second]
        }
    );
    messages(quote!(keeps(i = #integral)), item)
}

/// `0 < x` and `0 ≤ x` differ on x = 0 alone, which a solution crosses.
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
        // A difference with another sign and a positive factor.
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

/// The control: sides with an interior, a boundary on which solutions stay, and a condition on parameters alone.
#[test]
fn true_counterexamples_are_refused() {
    let one = quote!(1.0);
    for (integral, first, second) in [
        (quote!(x[1] - x[0].max(0.0)), one.clone(), quote!(if x[0] > 0.5 { 1.0 } else { 0.0 })),
        (quote!(x[1] - x[0].max(0.0)), one.clone(), quote!(if x[0] < 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1] - x[0].max(0.0)), one.clone(), quote!(if x[0] > 0.0 && x[1] > 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1] - x[0].abs()), one.clone(), quote!(if x[0] > 0.0 { -1.0 } else { 1.0 })),
        (quote!(x[1]), one.clone(), quote!(if x[0] > 1.0 && x[1] > 1.0 && x[0] + x[1] < 3.0 { 1.0 } else { 0.0 })),
        // x₀ = 0 for all time.
        (quote!(x[1]), quote!(0.0), quote!(if x[0] >= 0.0 && x[0] <= 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1]), quote!(x[0]), quote!(if x[0] >= 0.0 && x[0] <= 0.0 { 1.0 } else { 0.0 })),
        (
            quote!(x[1]),
            quote!(if x[1] > 0.0 { x[0] } else { 1.0 }),
            quote!(if x[0] >= 0.0 && x[0] <= 0.0 { 1.0 } else { 0.0 }),
        ),
        // x₁ = 0 for all time, where x₀·x₁ is zero as well.
        (quote!(x[0] - t), quote!(if x[0] * x[1] >= 0.0 && x[0] * x[1] <= 0.0 { 2.0 } else { 1.0 }), quote!(0.0)),
        (quote!(x[1]), one.clone(), quote!(if a >= 0.0 && a <= 0.0 { 1.0 } else { 0.0 })),
        (quote!(x[1]), one.clone(), quote!(if x[0] == 0.0 { 1.0 } else { 0.0 })),
    ] {
        let found = plane(integral.clone(), first, second.clone());
        assert!(found.contains("`i` is not constant along the field"), "{integral}, {second}: {found}");
    }
}

/// S and its transpose cancel on both sides of x₀ = 0. x₀ = 0 is crossed, x₂ = 0 is kept.
#[test]
fn structures_are_skew_on_both_sides_of_a_boundary() {
    let structured = |above: TokenStream, below: TokenStream| {
        let structure = quote!(structure = [[0.0, #above, 0.0], [#below, 0.0, 0.0], [0.0, 0.0, 0.0]]);
        let item = quote!(
            fn h(x: [f64; 3]) -> f64 {
                (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0
            }
        );
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
