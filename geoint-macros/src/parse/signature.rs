//! The signature as a whole: what kind of function it is, and what it returns.

use super::Outside;
use super::shape::float_type;
use crate::diagnostics::Diagnostics;
use proc_macro2::Ident;
use quote::{ToTokens, format_ident};
use syn::{ItemFn, ReturnType, Type};

/// An energy is a plain function of numbers.
pub(super) fn plain_function(item: &ItemFn, outside: &Outside, errors: &mut Diagnostics) {
    let signature = &item.sig;
    let mut refuse = |syntax: &dyn ToTokens, message: &str| errors.at(&syntax.to_token_stream(), message);
    if let Some(token) = &signature.asyncness {
        refuse(token, "an energy cannot be async: it is a plain function of numbers");
    }
    if let Some(abi) = &signature.abi {
        refuse(abi, "an energy cannot have a foreign ABI: it is a plain function of numbers");
    }
    if let syn::Safety::Unsafe(token) = &signature.safety {
        refuse(token, "an energy cannot be unsafe: it is a plain function of numbers");
    }
    if let Some(clause) = &signature.generics.where_clause {
        refuse(clause, "an energy is not generic, so that `where` has nothing to say: leave it out");
    }
    for parameter in &signature.generics.params {
        refuse(
            parameter,
            match parameter {
                syn::GenericParam::Const(_) => {
                    "an energy has one length: make it a constant above the function, and repeat it in the attribute: `const N = 3`"
                }
                _ => "an energy cannot be generic: write `f64` or `f32`; the generated code is generic by itself",
            },
        );
    }
    if let Some(receiver) = signature.receiver() {
        refuse(receiver, "an energy cannot have a receiver: make every quantity an argument");
    }
    if let ReturnType::Type(_, ty) = &signature.output
        && has_several(&outside.resolve(ty))
    {
        refuse(ty, VECTOR_FIELD);
    }
}

/// The float type that the function returns; every other number must have it too.
pub(super) fn returned_float(item: &ItemFn, outside: &Outside, errors: &mut Diagnostics) -> Ident {
    match &item.sig.output {
        ReturnType::Type(_, ty) => match float_type(&outside.resolve(ty)) {
            Some(float) => return float,
            None => errors.at(ty, ONE_NUMBER),
        },
        ReturnType::Default => errors.at(&item.sig.ident, ONE_NUMBER),
    }
    format_ident!("f64")
}

/// Whether a type is one of several numbers.
fn has_several(ty: &Type) -> bool {
    match ty {
        Type::Array(_) | Type::Slice(_) => true,
        Type::Tuple(tuple) => !tuple.elems.is_empty(),
        Type::Path(path) => path.path.segments.last().is_some_and(|last| {
            let name = last.ident.to_string();
            name.contains("Vector") || name == "Vec"
        }),
        Type::Paren(inner) => has_several(&inner.elem),
        Type::Group(inner) => has_several(&inner.elem),
        Type::Reference(inner) => has_several(&inner.elem),
        _ => false,
    }
}

const ONE_NUMBER: &str = "an energy returns one number: `-> f64` or `-> f32`";

const VECTOR_FIELD: &str = "an energy returns one number: `-> f64` or `-> f32`. A vector field X has one too: q' = X(q) follows from the \
                            energy p·X(q), by implicit methods under `#[hamiltonian]`, and by flows of its terms, without \
                            momenta, under `#[contact_hamiltonian(lift)]`";
