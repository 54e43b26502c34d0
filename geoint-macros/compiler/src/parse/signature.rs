//! Checks of the whole signature and of the return type.

use super::Outside;
use super::shape::{float_type, plain, shape};
use super::{Argument, Form};
use crate::diagnostics::Diagnostics;
use proc_macro2::Ident;
use quote::{ToTokens, format_ident};
use syn::{GenericArgument, ItemFn, PathArguments, ReturnType, Type};

/// Refuses all functions except plain functions of numbers.
pub(super) fn plain_function(form: Form, item: &ItemFn, outside: &Outside, errors: &mut Diagnostics) {
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
        let message = match parameter {
            syn::GenericParam::Const(_) => ONE_LENGTH,
            _ => "an energy cannot be generic: write `f64` or `f32`; the generated code is generic by itself",
        };
        refuse(parameter, message);
    }
    if let Some(receiver) = signature.receiver() {
        refuse(receiver, "an energy cannot have a receiver: make every quantity an argument");
    }
    if form != Form::Field
        && let ReturnType::Type(_, ty) = &signature.output
        && has_several(&outside.resolve(ty))
    {
        refuse(ty, VECTOR_FIELD);
    }
}

/// Returns the float type of the return value. All other numbers must have the same type.
pub(super) fn returned_float(form: Form, item: &ItemFn, outside: &Outside, errors: &mut Diagnostics) -> Ident {
    let (float, message): (fn(&Type) -> Option<Ident>, _) =
        if form == Form::Field { (float_inside, FIELD) } else { (float_type, ONE_NUMBER) };
    match &item.sig.output {
        ReturnType::Type(_, ty) => match float(&outside.resolve(ty)) {
            Some(float) => return float,
            None => errors.at(ty, message),
        },
        ReturnType::Default => errors.at(&item.sig.ident, message),
    }
    format_ident!("f64")
}

/// Returns the float type inside of arrays and vectors. Precondition: `Outside::resolve` has removed parentheses.
fn float_inside(ty: &Type) -> Option<Ident> {
    match ty {
        Type::Array(array) => float_inside(&array.elem),
        Type::Path(path) => float_type(ty).or_else(|| match &path.path.segments.last()?.arguments {
            PathArguments::AngleBracketed(arguments) => arguments.args.iter().find_map(|argument| match argument {
                GenericArgument::Type(ty) => float_inside(ty),
                _ => None,
            }),
            _ => None,
        }),
        _ => None,
    }
}

/// Checks that a vector field returns one entry for each coordinate.
pub(super) fn returns_shape_of(
    x: &Argument,
    item: &ItemFn,
    outside: &Outside,
    float: &Ident,
    errors: &mut Diagnostics,
) {
    let ReturnType::Type(_, ty) = &item.sig.output else { return };
    let resolved = outside.resolve(ty);
    let fits = shape(&resolved, float).is_ok_and(|shape| shape == x.shape);
    // `returned_float` has refused types without a float.
    if !fits && float_inside(&resolved).is_some() {
        let (name, shape) = (&x.name, plain(&x.ty));
        let hint = if float_type(&resolved).is_some() { OF_AN_ENERGY } else { "" };
        errors.at(
            ty,
            format!("a vector field has an entry for every coordinate: it returns `{shape}`, as `{name}` is{hint}"),
        );
    }
}

const FIELD: &str = "a vector field returns an entry for every coordinate, in the type of `x`";

const OF_AN_ENERGY: &str =
    "; an energy H(x) goes under `#[hamiltonian(structure = …)]`, and H(q, p) under `#[hamiltonian]`";

/// Returns whether a value of the type has several numbers. Precondition: `Outside::resolve` has removed parentheses.
fn has_several(ty: &Type) -> bool {
    match ty {
        Type::Array(_) | Type::Slice(_) => true,
        Type::Tuple(tuple) => !tuple.elems.is_empty(),
        Type::Path(path) => path.path.segments.last().is_some_and(|last| {
            let name = last.ident.to_string();
            name.contains("Vector") || name == "Vec"
        }),
        Type::Reference(inner) => has_several(&inner.elem),
        _ => false,
    }
}

const ONE_LENGTH: &str =
    "an energy has one length: make it a constant above the function, and repeat it in the attribute: `const N = …`";

const ONE_NUMBER: &str = "an energy returns one number: `-> f64` or `-> f32`";

const VECTOR_FIELD: &str = "an energy returns one number: `-> f64` or `-> f32`. A vector field x' = f(x) goes under `#[vector_field]`; by \
                            flows of its terms, under `#[contact_hamiltonian(lift)]` as p·f(q)";
