//! Types of arguments and their shapes.

use crate::messages::BY_HAND;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Expr, ExprLit, GenericArgument, Lit, Path, PathArguments, Type};

/// Extents of nested arrays, and the type of the innermost level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    /// Extents from outside in. Empty for a scalar.
    pub(crate) extents: Vec<usize>,
    /// Innermost level of the type.
    pub(crate) leaf: Leaf,
}

/// The innermost level of a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Leaf {
    /// A number, or an array of numbers.
    Plain,
    /// A vector of nalgebra.
    Vector,
    /// A unit quaternion of nalgebra, in the order i, j, k, w.
    Quaternion,
}

impl Shape {
    /// Returns the number of scalars.
    pub(crate) fn len(&self) -> usize {
        self.extents.iter().product()
    }

    /// Returns the indices of the `i`-th scalar, from outside in.
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

/// Types of the standard library. A user would not define an alias with such a name.
const FAMILIAR: [&str; 4] = ["String", "bool", "char", "Self"];

/// Returns the shape of a type. Errors: the type is no argument of an energy, or its numbers have another type than `float`.
///
/// Precondition: `Outside::resolve` has removed parentheses, aliases and known constants.
pub(super) fn shape(ty: &Type, float: &Ident) -> syn::Result<Shape> {
    let message = match ty {
        Type::Array(array) => {
            let extent = length(&array.len)?;
            let mut shape = shape(&array.elem, float)?;
            shape.extents.insert(0, extent);
            if shape.extents.len() <= 2 {
                return Ok(shape);
            }
            format!("arrays may be nested twice at most; an argument may be {TYPES}")
        }
        Type::Path(path) if path.path.is_ident(float) => return Ok(Shape { extents: vec![], leaf: Leaf::Plain }),
        Type::Path(path) => match of_nalgebra(&path.path, float)? {
            Some(shape) => return Ok(shape),
            None => refusal(&path.path, float),
        },
        Type::Reference(_) => format!("arguments are taken by value; an argument may be {TYPES}"),
        _ => format!("an argument may be {TYPES}"),
    };
    Err(syn::Error::new_spanned(ty, message))
}

/// Returns the shape of a vector or a unit quaternion of nalgebra.
fn of_nalgebra(path: &Path, float: &Ident) -> syn::Result<Option<Shape>> {
    let Some(last) = path.segments.last().filter(|_| scalar_within(path).as_ref() == Some(float)) else {
        return Ok(None);
    };
    let PathArguments::AngleBracketed(arguments) = &last.arguments else { return Ok(None) };
    let vector = |extent: usize| Some(Shape { extents: vec![extent], leaf: Leaf::Vector });
    match (last.ident.to_string().as_str(), arguments.args.iter().nth(1)) {
        ("UnitQuaternion", _) => Ok(Some(Shape { extents: vec![4], leaf: Leaf::Quaternion })),
        ("SVector", Some(GenericArgument::Const(n))) => length(n).map(vector),
        ("SVector", Some(n)) => Err(unknown_length(n)),
        (name, None) => Ok(vector_length(name).and_then(vector)),
        _ => Ok(None),
    }
}

/// Returns the length in the name of a vector type of nalgebra, `Vector1` to `Vector6`.
pub(crate) fn vector_length(name: &str) -> Option<usize> {
    name.strip_prefix("Vector")?.parse().ok().filter(|n| (1..=6).contains(n))
}

/// Returns the message for a path that is no type of an argument.
fn refusal(path: &Path, float: &Ident) -> String {
    let is_float = path.is_ident("f64") || path.is_ident("f32");
    let last = path.segments.last();
    if is_float || scalar_within(path).is_some_and(|scalar| scalar != *float) {
        format!("all numbers of an energy have one type, here `{float}`")
    } else if INTEGERS.iter().any(|integer| path.is_ident(integer)) {
        "an argument is a number or made of numbers, not an integer: write that as a `const` in the body".into()
    } else if last.is_some_and(|last| last.ident == "Vec" || last.ident == "DVector") {
        format!(
            "a length is known when the program is compiled: write `[{float}; N]`; a system whose size is read at run time is \
             written by hand, see {BY_HAND}"
        )
    } else {
        let may_be_alias =
            last.is_some_and(|last| last.arguments.is_none() && !FAMILIAR.iter().any(|name| last.ident == name));
        let hint = match path.get_ident() {
            _ if !may_be_alias => String::new(),
            Some(name) => {
                format!("; if `{name}` is another name of one, repeat it in the attribute: `type {name} = …`")
            }
            None => "; if this is another name of one, take it by `use`, and repeat it: `type P = …`".into(),
        };
        format!("an argument may be {TYPES}{hint}")
    }
}

/// Returns the float type in the first argument of a generic type.
fn scalar_within(path: &Path) -> Option<Ident> {
    let PathArguments::AngleBracketed(arguments) = &path.segments.last()?.arguments else { return None };
    match arguments.args.first()? {
        GenericArgument::Type(ty) => float_type(ty),
        _ => None,
    }
}

/// Returns the value of a length.
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

/// Returns the error for a length with unknown constants. The message is an advice to repeat them.
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

/// Returns the type if it is `f64` or `f32`.
pub(super) fn float_type(ty: &Type) -> Option<Ident> {
    let Type::Path(path) = ty else { return None };
    let ident = path.path.get_ident()?;
    (ident == "f64" || ident == "f32").then(|| ident.clone())
}

/// Returns the text of a type with the usual spaces.
pub(super) fn plain(ty: &impl ToTokens) -> String {
    ty.to_token_stream().to_string().replace(" < ", "<").replace(" >", ">").replace(" :: ", "::").replace(" ,", ",")
}

/// Replaces the float type by another identifier, for generic code.
pub(crate) fn over_scalar(ty: &impl ToTokens, float: &Ident, with: &Ident) -> TokenStream {
    let replace = |tree| match tree {
        TokenTree::Ident(ident) if ident == *float => TokenTree::Ident(with.clone()),
        TokenTree::Group(group) => {
            let stream = over_scalar(&group.stream(), float, with);
            let mut replaced = proc_macro2::Group::new(group.delimiter(), stream);
            replaced.set_span(group.span());
            TokenTree::Group(replaced)
        }
        other => other,
    };
    ty.to_token_stream().into_iter().map(replace).collect()
}
