//! Attributes of `geoint-runtime`. Each attribute passes its tokens to the compiler `geoint-compiler`.
//!
//! Depend on `geoint-runtime`. It re-exports the attributes, and the generated code uses it.

use proc_macro::TokenStream;

/// Makes an integrable system from an energy H(q, p), or H(q, p, t) if it has an argument `t`.
///
#[doc = include_str!("../docs/hamiltonian.md")]
#[proc_macro_attribute]
pub fn hamiltonian(args: TokenStream, item: TokenStream) -> TokenStream {
    geoint_compiler::hamiltonian(args.into(), item.into()).into()
}

/// Makes an integrable system from a vector field, x' = f(x) or x' = f(x, t). Named first integrals are proven and kept.
///
#[doc = include_str!("../docs/vector_field.md")]
#[proc_macro_attribute]
pub fn vector_field(args: TokenStream, item: TokenStream) -> TokenStream {
    geoint_compiler::vector_field(args.into(), item.into()).into()
}

/// Makes an integrable system from a contact Hamiltonian H(q, p, s) or H(q, p, s, t), for friction and driving.
///
#[doc = include_str!("../docs/contact_hamiltonian.md")]
#[proc_macro_attribute]
pub fn contact_hamiltonian(args: TokenStream, item: TokenStream) -> TokenStream {
    geoint_compiler::contact_hamiltonian(args.into(), item.into()).into()
}

/// Makes an integrable system from a Lagrangian L(q, v) with the velocities v = q', or L(q, v, t), or L(q, v, s, t).
///
#[doc = include_str!("../docs/lagrangian.md")]
#[proc_macro_attribute]
pub fn lagrangian(args: TokenStream, item: TokenStream) -> TokenStream {
    geoint_compiler::lagrangian(args.into(), item.into()).into()
}

/// Makes a function callable in energies. Each energy inlines and differentiates the function.
///
#[doc = include_str!("../docs/energy_function.md")]
#[proc_macro_attribute]
pub fn energy_function(args: TokenStream, item: TokenStream) -> TokenStream {
    geoint_compiler::energy_function(args.into(), item.into()).into()
}

/// Asks for the text of a function. If the function is not under `#[energy_function]`, rustc prints the name of this macro as advice.
#[doc(hidden)]
#[proc_macro]
pub fn put_energy_function_above_it(input: TokenStream) -> TokenStream {
    geoint_compiler::put_energy_function_above_it(input.into()).into()
}

/// Continues an expansion with the text of a function under `#[energy_function]`.
#[doc(hidden)]
#[proc_macro]
pub fn resume(input: TokenStream) -> TokenStream {
    geoint_compiler::resume(input.into()).into()
}
