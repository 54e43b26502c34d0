//! Reports name the jumps of angles by `atan2`, in every form.

use crate::parse::Form;
use crate::tests::expansion;
use proc_macro2::TokenStream;
use quote::quote;

#[test]
fn turns_of_energies_are_reported() {
    let turn = |found: &str| {
        found.contains("the term jumps where the angle by `atan2` comes round, by 2π times the factor of the angle")
    };
    let kinetic = quote!((p[0] * p[0] + p[1] * p[1]) / 2.0);
    let of = |potential: TokenStream, args: TokenStream| {
        let item = quote! { fn h(q: [f64; 2], p: [f64; 2], k: f64) -> f64 { #kinetic + #potential } };
        expansion(Form::Hamiltonian, args, item)
    };
    let angle = quote!(q[1].atan2(q[0]));
    assert!(turn(&of(quote!(k * #angle), quote!())));
    assert!(turn(&of(quote!((k * #angle).cos()), quote!())));
    assert!(turn(&of(quote!((0.5 * #angle).cos()), quote!())));
    assert!(turn(&of(quote!(k * #angle), quote!(constraint = q[0] * q[0] + q[1] * q[1] - 1.0))));
    assert!(turn(&of(quote!(k * #angle), quote!(damping = k))));
    // A multiple inside a periodic function, and an angle of parameters, do not jump.
    assert!(!turn(&of(quote!(k * (2.0 * #angle + k).cos()), quote!())));
    assert!(!turn(&of(quote!(q[0] * k.atan2(2.0)), quote!())));
    for (form, args, item) in [
        (
            Form::Contact,
            quote!(),
            quote! { fn h(q: [f64; 2], p: [f64; 2], s: f64) -> f64 { #kinetic + #angle + 0.1 * s } },
        ),
        (
            Form::Lagrangian,
            quote!(),
            quote! { fn l(q: [f64; 2], v: [f64; 2]) -> f64 { (v[0] * v[0] + v[1] * v[1]) / 2.0 - #angle } },
        ),
        (
            Form::Lagrangian,
            quote!(),
            quote! { fn l(q: [f64; 2], v: [f64; 2], s: f64) -> f64 {
                (v[0] * v[0] + v[1] * v[1]) / 2.0 - #angle - 0.1 * s
            } },
        ),
        (
            Form::Lagrangian,
            quote!(),
            quote! { fn l(q: [f64; 2], v: [f64; 2]) -> f64 { (v[0] * v[0] + v[1] * v[1]).powi(2) - #angle } },
        ),
        (Form::Lagrangian, quote!(), quote! { fn l(q: [f64; 2], v: [f64; 2]) -> f64 { q[0] * v[1] - #angle } }),
        (Form::Hamiltonian, quote!(structure = so3), quote! { fn h(x: [f64; 3]) -> f64 { x[1].atan2(x[0]) } }),
        (
            Form::Hamiltonian,
            quote!(attitude = r),
            quote! { fn h(r: UnitQuaternion<f64>, m: Vector3<f64>) -> f64 {
                let axis = r * Vector3::new(1.0, 0.0, 0.0);
                (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]) / 2.0 + axis.y.atan2(axis.x)
            } },
        ),
    ] {
        let found = expansion(form, args, item.clone());
        assert!(!found.contains("compile_error") && turn(&found), "{item}: {found}");
    }
    // A field reports the turns of each integral.
    let item = quote! { fn f(x: [f64; 3]) -> [f64; 3] { [-x[1], x[0], 1.0] } };
    let found = expansion(Form::Field, quote!(keeps(i = x[1].atan2(x[0]) - x[2])), item);
    assert!(found.contains("but for turns of `atan2` by 2π") && !turn(&found), "{found}");
}
