//! Messages and reports about the functions that a field conserves.

use crate::parse::Form;
use crate::tests::expansion;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the messages for a field.
pub(super) fn messages(args: TokenStream, item: TokenStream) -> String {
    messages_of(Form::Field, args, item)
}

/// Returns the messages for a function under an attribute, one a line. Empty if the macro accepts it.
pub(super) fn messages_of(form: Form, args: TokenStream, item: TokenStream) -> String {
    expansion(form, args, item)
        .split("compile_error ! {")
        .skip(1)
        .filter_map(|rest| rest.split('}').next())
        .collect::<Vec<_>>()
        .join("\n")
}

#[test]
fn a_wrong_integral_is_refused_with_its_remainder() {
    let top = |keeps: TokenStream| {
        let item = quote! { fn f(x: [f64; 3], a: f64) -> [f64; 3] { [a * x[1] * x[2], -x[0] * x[2], 0.0] } };
        messages(quote!(keeps(#keeps)), item)
    };
    assert_eq!(top(quote!(energy = x[0] * x[0] + a * x[1] * x[1])), "");
    let found = top(quote!(energy = x[0] * x[0] + 2.0 * a * x[1] * x[1]));
    assert!(found.contains("what remains of its derivative is -2·x[0]·x[1]·x[2]·a"), "{found}");
    let found = top(quote!(height = x[2], again = x[2] * x[2] + 1.0));
    assert!(found.contains("`again` is a function of the others"), "{found}");
    let found = top(quote!(one = 1.0));
    assert!(found.contains("`one` is constant everywhere"), "{found}");
    // The verdict does not depend on the unit.
    for unit in [quote!(1e200), quote!(1e-40), quote!(1e-200)] {
        assert_eq!(top(quote!(energy = #unit * (x[0] * x[0] + a * x[1] * x[1]))), "");
        let found = top(quote!(energy = #unit * (x[0] * x[0] - a * x[1] * x[1])));
        assert!(
            found.contains("`energy` is not constant along the field: what remains of its derivative is 4e"),
            "{found}"
        );
    }
    // An integral that may hold in a part of phase space can be assumed. An integral that holds almost nowhere can not.
    assert_eq!(top(quote!(assume(energy = x[0] * (1.0 - x[0].atan() - (1.0 / x[0]).atan())))), "");
    assert_eq!(top(quote!(assume(energy = (x[0] * x[0]).sqrt() - x[0]))), "");
    assert_eq!(top(quote!(assume(energy = x[0].abs() - x[0]))), "");
    for (wrong, rest) in [
        (quote!(x[0] * x[0]), "2·x[0]·x[1]·x[2]·a"),
        (quote!(x[0].cos() + x[1]), "-x[0]·x[2] - x[1]·x[2]·a·sin(x[0])"),
        (quote!(x[1] * (a * x[2]).exp()), "-x[0]·x[2]·exp(x[2]·a)"),
        (quote!((x[0] * x[0] - a * x[1] * x[1]).sqrt()), "2·x[0]·x[1]·x[2]·a/√(x[0]² - x[1]²·a)"),
        (quote!(x[2] + (x[0] * x[0]).sqrt()), "x[0]·x[1]·x[2]·a/√(x[0]²)"),
    ] {
        let found = top(quote!(assume(energy = #wrong)));
        assert!(found.contains(&format!("what remains of its derivative is {rest}")), "{found}");
    }
}

/// The test points do not reach a > 3. The message names the remainder, and states that no test point showed it.
#[test]
fn a_remainder_that_no_test_point_shows_is_named() {
    let item = quote! { fn f(x: [f64; 2], a: f64) -> [f64; 2] { [if a > 3.0 { x[1] } else { 0.0 }, 1.0] } };
    let found = messages(quote!(keeps(first = x[0])), item);
    let expected = "no state was met at which what remains is not zero; if you know that it is, say `keeps(assume(first = …))`; \
                    what remains of its derivative where 3 < a is x[1]";
    assert!(found.contains(expected), "{found}");
}

/// H is constant on both sides of the gate, and jumps between them. Solutions pass the gate.
#[test]
fn an_energy_that_jumps_on_the_way_is_not_kept() {
    let report = |item: TokenStream| expansion(Form::Field, quote!(), item);
    let gate = report(quote! { fn f(x: [f64; 2]) -> [f64; 2] { [if x[0] > 0.0 { 1.0 } else { 2.0 }, 0.0] } });
    assert!(
        gate.contains("on each side, proven by multiplying out; not kept, because it may jump where x[0] = 0"),
        "{gate}"
    );
    assert!(!gate.contains("the energy of the field"), "{gate}");
    let wedge = report(quote! { fn f(x: [f64; 2]) -> [f64; 2] { [x[1], if x[0] > 0.0 { -1.0 } else { 1.0 }] } });
    assert!(wedge.contains("kept, the energy of the field"), "{wedge}");
}

/// A field is split by the first function that it conserves. This need not be its energy, and may have any unit.
#[test]
fn the_conserved_function_of_a_splitting_is_named() {
    let report = |keeps: TokenStream| {
        let item = quote! { fn f(x: [f64; 2]) -> [f64; 2] { [x[1], -x[0]] } };
        expansion(Form::Field, quote!(#keeps), item)
    };
    for unit in [quote!(0.1), quote!(1e200), quote!(1e-200)] {
        let found = report(quote!(keeps(radius = #unit * (x[0] * x[0] + x[1] * x[1]))));
        assert!(found.contains("- radius is kept to rounding, Casimirs to the order"), "{found}");
        assert!(found.contains("Casimirs are kept to rounding, radius to the order"), "{found}");
    }
    assert!(report(quote!()).contains("- the energy is kept to rounding, Casimirs to the order"));
}

/// A derivative is zero on both sides of a jump as well.
#[test]
fn an_integral_that_jumps_on_the_way_is_refused() {
    let ring = |keeps: TokenStream| {
        let item = quote! { fn f(x: [f64; 3], l: f64) -> [f64; 3] { [x[1], -x[0], x[2] * x[0]] } };
        messages(quote!(keeps(#keeps)), item)
    };
    let refused = |keeps: TokenStream, edge: &str| {
        let found = ring(keeps);
        assert!(found.contains(&format!("it may jump where {edge};")), "{found}");
    };
    refused(quote!(radius = x[0] * x[0] + x[1] * x[1] + x[0].signum()), "x[0] = 0");
    refused(quote!(radius = x[0] * x[0] + x[1] * x[1] + if x[0] > l { 1.0 } else { 0.0 }), "l = x[0]");
    refused(quote!(radius = if x[0] + x[1] < 1.0 { x[0] * x[0] + x[1] * x[1] } else { 2.0 }), "x[0] + x[1] = 1");
    assert_eq!(ring(quote!(assume(radius = x[0] * x[0] + x[1] * x[1] + x[0].signum()))), "");
    // x₂ keeps its sign, and stays exactly zero if it is zero.
    assert_eq!(ring(quote!(radius = (x[0] * x[0] + x[1] * x[1]) * x[2].signum())), "");
    // If the radius equals l, rounding decides the comparison.
    let found = ring(quote!(radius = x[0].hypot(x[1]).max(l) + if x[0].hypot(x[1]) > l { 1.0 } else { 2.0 }));
    assert!(found.contains("`radius` jumps where l = hypot(x[0], x[1]), and solutions stay there"), "{found}");
    // Both sides have equal values at the boundary: a plane, a circle, two boundaries. A jump in time is refused.
    let wall = |keeps: TokenStream, force: TokenStream| {
        let item = quote! { fn f(x: [f64; 3], t: f64, l: f64) -> [f64; 3] { [x[1], #force, 0.0 * t * l] } };
        messages(quote!(keeps(#keeps)), item)
    };
    let spring = quote!(energy = x[1] * x[1] + if x[0] > l { (x[0] - l).powi(2) } else { 0.0 });
    assert_eq!(wall(spring, quote!(if x[0] > l { l - x[0] } else { 0.0 })), "");
    let overlap = quote!({
        let d = (x[0] * x[0] + l).sqrt() - 1.0;
        if d > 0.0 { d * d } else { 0.0 }
    });
    let force = quote!({
        let r = (x[0] * x[0] + l).sqrt();
        if r - 1.0 > 0.0 { -x[0] * (r - 1.0) / r } else { 0.0 }
    });
    assert_eq!(wall(quote!(energy = x[1] * x[1] + #overlap), force.clone()), "");
    let found = wall(quote!(energy = x[1] * x[1] + #overlap + if t > 1.0 { 1.0 } else { 0.0 }), force);
    assert!(found.contains("it may jump where t = 1;"), "{found}");
    let between = quote!(
        energy = x[1] * x[1]
            + if x[0] > 0.0 && x[0] < 1.0 {
                0.0
            } else if x[0] >= 1.0 {
                (x[0] - 1.0).powi(2)
            } else {
                x[0] * x[0]
            }
    );
    let force = quote!(if x[0] > 0.0 && x[0] < 1.0 {
        0.0
    } else if x[0] >= 1.0 {
        1.0 - x[0]
    } else {
        -x[0]
    });
    assert_eq!(wall(between, force), "");
}

/// The expansion contains the text of the report.
#[test]
fn assumed_integrals_are_never_called_kept() {
    let item = quote! { fn f(x: [f64; 2]) -> [f64; 2] { [x[1], -x[0]] } };
    let report = |keeps: TokenStream| expansion(Form::Field, quote!(keeps(#keeps)), item.clone());
    let assumed = report(quote!(assume(size = x[0] * x[0] + x[1] * x[1])));
    assert!(assumed.contains(": assumed") && !assumed.contains("keep size"), "{assumed}");
    assert!(assumed.contains("levels of size, which the flow is assumed to do"), "{assumed}");
    let proven = report(quote!(size = x[0] * x[0] + x[1] * x[1]));
    assert!(proven.contains("keep size, to rounding") && !proven.contains("assumed"), "{proven}");
}

#[test]
fn angles_are_conserved_up_to_turns() {
    let item = quote! { fn f(x: [f64; 3], w: f64) -> [f64; 3] { [-w * x[1], w * x[0], w] } };
    let args = quote!(keeps(phase = x[1].atan2(x[0]) - x[2]));
    let found = expansion(Form::Field, args, item);
    assert!(found.contains("kept, proven by multiplying out, but for turns of `atan2` by 2π"), "{found}");
}

/// Nothing moves, so there are no pieces.
#[test]
fn flows_at_rest() {
    let at_rest = [
        (Form::Field, quote!(keeps(a = x[0], b = x[1])), quote! { fn f(x: [f64; 2]) -> [f64; 2] { [0.0, 0.0] } }),
        (Form::Hamiltonian, quote!(structure = so3), quote! { fn f(x: [f64; 3], a: f64) -> f64 { a } }),
    ];
    for (form, args, item) in at_rest {
        let found = expansion(form, args, item);
        assert!(
            !found.contains("compile_error") && found.contains("nothing moves, so that there are no pieces"),
            "{found}"
        );
    }
}

/// An energy at rest is valid. A structure that moves nothing for any energy is a mistake.
#[test]
fn structures_that_are_zero() {
    let zero = [
        (
            quote!([[0.0, 0.0], [0.0, 0.0]]),
            2_usize,
            "write its entries S[i][j] = −S[j][i], or x' = −C ∇H by `damping = C`",
        ),
        (quote!([[0.0]]), 1, "one coordinate has no other structure"),
        (quote!(nambu(a)), 3, "the function in `nambu(…)` has to read `x`"),
    ];
    for (structure, n, advice) in zero {
        let item = quote! { fn f(x: [f64; #n], a: f64) -> f64 { a * x[0] * x[0] } };
        let refused = expansion(Form::Hamiltonian, quote!(structure = #structure), item.clone());
        assert!(refused.contains("S is zero, so that nothing moves; ") && refused.contains(advice), "{refused}");
        let downhill = expansion(Form::Hamiltonian, quote!(structure = #structure, damping = 1.5), item);
        assert!(!downhill.contains("compile_error"), "{downhill}");
    }
}

/// Integrals can not have the names of generated functions, or names that differ in `r#` only.
#[test]
fn names_of_integrals_are_free() {
    let named = |keeps: TokenStream| {
        let item = quote! { fn f(x: [f64; 3], a: f64) -> [f64; 3] { [a * x[1], -a * x[0], 0.0] } };
        messages(quote!(keeps(#keeps)), item)
    };
    for name in ["integrator", "adaptive", "taylor", "field", "r#field"] {
        let name: TokenStream = name.parse().expect("a name");
        let found = named(quote!(#name = x[2]));
        assert!(found.contains("is a function of generated code; give the integral another name"), "{found}");
    }
    let found = named(quote!(height = x[2], r#height = x[0] * x[0] + x[1] * x[1]));
    assert!(found.contains("`r#height` is given twice"), "{found}");
    assert_eq!(named(quote!(r#type = x[2])), "");
}

/// The search finds squares and logarithms. The function C of `nambu(C)` is always a Casimir.
#[test]
fn the_function_of_nambu_is_a_casimir() {
    let item = quote! { fn f(x: [f64; 3], a: f64) -> f64 { x[0] * x[1] + x[2] * x[2] / 2.0 } };
    let report = |args: TokenStream| expansion(Form::Hamiltonian, args, item.clone());
    let found = report(quote!(structure = nambu(x[0] + x[1] * x[1] / 2.0 - a * x[2].cos())));
    assert!(found.contains("x[0] + x[1]²/2 - a·cos(x[2]): kept, a Casimir"), "{found}");
    // The search finds the logarithm of this function, which is defined at fewer states.
    let found = report(quote!(structure = nambu(x[0] * x[1] * x[2])));
    assert!(found.contains("x[0]·x[1]·x[2]: kept, a Casimir"), "{found}");
    // A Casimir that the search has found is listed once.
    let found = report(quote!(structure = nambu((x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0)));
    assert_eq!(found.matches("kept, a Casimir").count(), 2, "{found}");
}

#[test]
fn an_energy_that_reads_time_is_not_said_to_be_kept() {
    let report = |item: TokenStream| expansion(Form::Hamiltonian, quote!(structure = so3), item);
    let driven = report(quote! { fn f(x: [f64; 3], t: f64) -> f64 { x[0] * x[0] + x[1] * x[1] * t.cos() } });
    assert!(
        driven.contains("`DiscreteGradient` keeps every C(x) of degree 2 at most with S ∇C = 0, to rounding"),
        "{driven}"
    );
    assert!(!driven.contains("the energy to rounding"), "{driven}");
    let steady = report(quote! { fn f(x: [f64; 3]) -> f64 { x[0] * x[0] + x[1] * x[1] * 3.0 } });
    assert!(steady.contains("`DiscreteGradient` keeps the energy to rounding, and every C(x)"), "{steady}");
}
