//! Types and their shapes.

use crate::messages::BY_HAND;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Expr, ExprLit, GenericArgument, Lit, Path, PathArguments, Type};

/// Extents from outside in; none for a scalar.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    pub(crate) extents: Vec<usize>,
    /// What the innermost level is.
    pub(crate) leaf: Leaf,
}

/// The innermost level of a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Leaf {
    /// A number, or an array of numbers.
    Plain,
    /// A vector of nalgebra.
    Vector,
    /// A unit quaternion of nalgebra: i, j, k, w.
    Quaternion,
}

impl Shape {
    /// The number of scalars.
    pub(crate) fn len(&self) -> usize {
        self.extents.iter().product()
    }

    /// The indices of the `i`-th scalar, from outside in.
    pub(crate) fn indices(&self, i: usize) -> Vec<usize> {
        let mut rest = i;
        let mut indices = vec![];
        for extent in self.extents.iter().rev() {
            indices.push(rest % extent);
            rest /= extent;
        }
        indices.reverse();
        indices
    }
}

const TYPES: &str = "`f64`, `f32`, `[f64; N]`, `[[f64; D]; N]`, vectors of nalgebra such as `Vector3<f64>` or \
                     `SVector<f64, 4>`, attitudes `UnitQuaternion<f64>`, and arrays of them";

const INTEGERS: [&str; 12] = ["u8", "u16", "u32", "u64", "u128", "usize", "i8", "i16", "i32", "i64", "i128", "isize"];

/// Names of types of the standard library, which are no aliases.
const FAMILIAR: [&str; 4] = ["String", "bool", "char", "Self"];

/// The shape of a type.
pub(super) fn shape(ty: &Type, float: &Ident) -> syn::Result<Shape> {
    let refuse =
        |syntax: &dyn ToTokens, message: String| Err(syn::Error::new_spanned(syntax.to_token_stream(), message));
    match ty {
        Type::Paren(inner) => shape(&inner.elem, float),
        Type::Group(inner) => shape(&inner.elem, float),
        Type::Array(array) => {
            let extent = length(&array.len)?;
            let mut inner = shape(&array.elem, float)?;
            inner.extents.insert(0, extent);
            if inner.extents.len() > 2 {
                return refuse(ty, format!("arrays may be nested twice at most; an argument may be {TYPES}"));
            }
            Ok(inner)
        }
        Type::Path(path) => {
            if let Some(other) = float_type(ty) {
                if other != *float {
                    return refuse(ty, format!("all numbers of an energy have one type, here `{float}`"));
                }
                return Ok(Shape { extents: vec![], leaf: Leaf::Plain });
            }
            match vector(path, float)? {
                Some(extent) => Ok(Shape { extents: vec![extent], leaf: Leaf::Vector }),
                None if is_quaternion(path, float) => Ok(Shape { extents: vec![4], leaf: Leaf::Quaternion }),
                None if INTEGERS.iter().any(|integer| path.path.is_ident(integer)) => refuse(
                    ty,
                    "an argument is a number or made of numbers, not an integer: write that as a `const` in the body"
                        .into(),
                ),
                None if scalar_within(path).is_some_and(|other| other != *float) => {
                    refuse(ty, format!("all numbers of an energy have one type, here `{float}`"))
                }
                None if path
                    .path
                    .segments
                    .last()
                    .is_some_and(|last| last.ident == "Vec" || last.ident == "DVector") =>
                {
                    refuse(
                        ty,
                        format!(
                            "a length is known when the program is compiled: write `[{float}; N]`; a system whose size is read at run time is \
                         written by hand, see {BY_HAND}"
                        ),
                    )
                }
                None => {
                    let may_be_alias = match path.path.segments.last() {
                        Some(last) => last.arguments.is_none() && !FAMILIAR.iter().any(|name| last.ident == name),
                        None => false,
                    };
                    let hint = match path.path.get_ident() {
                        _ if !may_be_alias => String::new(),
                        Some(name) => format!(
                            "; if `{name}` is another name of one, repeat it in the attribute: `type {name} = …`"
                        ),
                        None => {
                            "; if this is another name of one, take it by `use`, and repeat it: `type P = …`".into()
                        }
                    };
                    refuse(ty, format!("an argument may be {TYPES}{hint}"))
                }
            }
        }
        Type::Reference(_) => refuse(ty, format!("arguments are taken by value; an argument may be {TYPES}")),
        _ => refuse(ty, format!("an argument may be {TYPES}")),
    }
}

/// Whether a type is a unit quaternion of nalgebra.
fn is_quaternion(path: &syn::TypePath, float: &Ident) -> bool {
    let is_named = path.path.segments.last().is_some_and(|last| last.ident == "UnitQuaternion");
    is_named && scalar_within(path).as_ref() == Some(float)
}

/// The type of the numbers of a type of nalgebra.
fn scalar_within(path: &syn::TypePath) -> Option<Ident> {
    let PathArguments::AngleBracketed(arguments) = &path.path.segments.last()?.arguments else { return None };
    match arguments.args.first()? {
        GenericArgument::Type(ty) => float_type(ty),
        _ => None,
    }
}

/// The length of a vector of nalgebra.
fn vector(path: &syn::TypePath, float: &Ident) -> syn::Result<Option<usize>> {
    let Some(last) = path.path.segments.last() else { return Ok(None) };
    let PathArguments::AngleBracketed(arguments) = &last.arguments else { return Ok(None) };
    let name = last.ident.to_string();
    let mut arguments = arguments.args.iter();
    match arguments.next() {
        Some(GenericArgument::Type(ty)) if float_type(ty).as_ref() == Some(float) => {}
        _ => return Ok(None),
    }
    let fixed = name.strip_prefix("Vector").and_then(|n| n.parse().ok()).filter(|n| (1..=6).contains(n));
    match (fixed, name.as_str(), arguments.next()) {
        (Some(n), _, None) => Ok(Some(n)),
        (None, "SVector", Some(GenericArgument::Const(n))) => length(n).map(Some),
        (None, "SVector", Some(n)) => Err(unknown_length(n)),
        _ => Ok(None),
    }
}

/// A length that is a number: constants have been written out.
fn length(expr: &Expr) -> syn::Result<usize> {
    match expr {
        Expr::Lit(ExprLit { lit: Lit::Int(n), .. }) => match n.base10_parse() {
            Ok(n @ 1..=1000) => Ok(n),
            _ => Err(syn::Error::new_spanned(n, "a length goes from 1 to 1000: all loops over it are unrolled")),
        },
        Expr::Group(group) => length(&group.expr),
        other => Err(unknown_length(other)),
    }
}

fn unknown_length(length: &impl ToTokens) -> syn::Error {
    let message = match syn::parse2::<Path>(length.to_token_stream()) {
        Ok(path) if path.segments.len() > 1 => {
            let name = path.segments.last().map(|last| last.ident.to_string()).unwrap_or_default();
            format!(
                "the attribute cannot see constants outside of the function: name this one by `use`, and repeat it there, \
                 `const {name} = …`; rustc checks that both agree"
            )
        }
        Ok(name) => format!(
            "the attribute cannot see constants outside of the function: repeat this one there, `const {} = …`; rustc checks \
             that both agree",
            plain(&name)
        ),
        Err(_) => "a length is made of numbers and constants that the attribute repeats: `const N = …`".into(),
    };
    syn::Error::new_spanned(length, message)
}

pub(super) fn float_type(ty: &Type) -> Option<Ident> {
    let Type::Path(path) = ty else { return None };
    let ident = path.path.get_ident()?;
    (ident == "f64" || ident == "f32").then(|| ident.clone())
}

/// A type as one writes it.
pub(super) fn plain(ty: &impl ToTokens) -> String {
    ty.to_token_stream().to_string().replace(" < ", "<").replace(" >", ">").replace(" :: ", "::").replace(" ,", ",")
}

/// The type with `with` in place of the float type.
pub(crate) fn over_scalar(ty: &Type, float: &Ident, with: &Ident) -> TokenStream {
    fn replace(tokens: TokenStream, float: &Ident, with: &Ident) -> TokenStream {
        tokens
            .into_iter()
            .map(|tree| match tree {
                TokenTree::Ident(ident) if ident == *float => TokenTree::Ident(with.clone()),
                TokenTree::Group(group) => {
                    let stream = replace(group.stream(), float, with);
                    let mut replaced = proc_macro2::Group::new(group.delimiter(), stream);
                    replaced.set_span(group.span());
                    TokenTree::Group(replaced)
                }
                other => other,
            })
            .collect()
    }
    replace(ty.to_token_stream(), float, with)
}
