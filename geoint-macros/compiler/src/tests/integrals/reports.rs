//! Reports about numbers in fields, shapes of structures, and functions that split a field.

use crate::parse::Form;
use crate::tests::expansion;
use proc_macro2::TokenStream;
use quote::quote;

/// Roots of numbers are exact in both spellings. Decimals near a root are different numbers.
#[test]
fn a_decimal_is_no_root() {
    let line = |keeps: TokenStream, slope: TokenStream| {
        let item = quote! { fn f(x: [f64; 2]) -> [f64; 2] { [1.0, #slope] } };
        expansion(Form::Field, quote!(keeps(e = #keeps * x[0] - x[1])), item)
    };
    let all =
        [quote!(std::f64::consts::SQRT_2), quote!(2.0_f64.sqrt()), quote!((2.0 * std::f64::consts::FRAC_1_SQRT_2))];
    for one in &all {
        for other in &all {
            let found = line(one.clone(), other.clone());
            // H is a function of the listed integral.
            assert!(
                found.contains("kept, proven by multiplying out") && !found.contains("energy of the field"),
                "{found}"
            );
        }
        for found in [line(one.clone(), quote!(1.4142135623730951)), line(quote!(1.4142135623730951), one.clone())] {
            assert!(found.contains("it holds to rounding, and numbers in it are rounded"), "{found}");
        }
    }
}

/// m and γ are two vectors, or six numbers.
#[test]
fn a_top_may_be_written_in_vectors() {
    let report = |item: TokenStream| expansion(Form::Hamiltonian, quote!(structure = se3), item);
    let vectors = report(quote! { fn f(x: [Vector3<f64>; 2], r: Vector3<f64>) -> f64 {
        x[0].norm_squared() / 2.0 + r.dot(&x[1])
    } });
    for line in [
        "x[0][0]' = x[1][1]·r[2] - x[1][2]·r[1]",
        "{x[0][0], x[0][1]} = -x[0][2]",
        "{x[0][0], x[1][1]} = -x[1][2]",
        "x[0][0]·x[1][0] + x[0][1]·x[1][1] + x[0][2]·x[1][2]: kept, a Casimir",
        "a Poisson structure: Jacobi's identity holds",
    ] {
        assert!(vectors.contains(line), "{line}: {vectors}");
    }
    let four = report(quote! { fn f(x: [[f64; 2]; 3]) -> f64 { x[0][0] * x[2][1] } });
    assert!(four.contains("`se3` is a structure of 6 coordinates, or of 2 vectors"), "{four}");
}

/// A refused expression has no length.
#[test]
fn an_unsupported_expression_is_refused_once() {
    let item = quote! { fn f(x: [f64; 3]) -> [f64; 3] { std::array::from_fn(|i| x[i]) } };
    let found = expansion(Form::Field, quote!(), item);
    assert!(found.contains("`with(std::array::from_fn)`"), "{found}");
    assert_eq!(found.matches("compile_error !").count(), 1, "{found}");
}

/// A function that a part of the field changes splits nothing. It must not be named as the obstacle of a splitting by conserved functions.
#[test]
fn fields_are_split_by_conserved_functions() {
    let report = |keeps: TokenStream| {
        let item = quote! { fn f(x: [f64; 4], g: f64) -> [f64; 4] {
            [x[1] - g * x[0], -x[0], x[3] * x[0], -x[2] * x[0]]
        } };
        expansion(Form::Field, quote!(keeps(#keeps)), item)
    };
    let changed = quote!(half = x[0] * x[0] + x[1] * x[1], but = [-g * x[0], 0.0, 0.0, 0.0]);
    let both = report(quote!(#changed, other = x[2] * x[2] + x[3] * x[3]));
    assert!(both.contains("- none, because of x[2]² + x[3]²"), "{both}");
    assert!(both.contains("no S was found for this I") && !both.contains("changes this I"), "{both}");
    let alone = report(changed);
    assert!(alone.contains("- none, because of x[0]² + x[1]²"), "{alone}");
    assert!(alone.contains("changes this I") && !alone.contains("no S was found for this I"), "{alone}");
}
