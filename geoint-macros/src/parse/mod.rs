//! Arguments and signature: who is q, p and t, who is a parameter, in which shape.

use crate::diagnostics::{Diagnostics, Result};
use crate::ir::Symbol;
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::{Expr, ExprLit, FnArg, GenericArgument, ItemFn, Lit, Pat, PathArguments, ReturnType, Token, Type};

/// An annotated function, understood up to its body.
pub(crate) struct Energy {
    pub(crate) item: ItemFn,
    /// The generated struct.
    pub(crate) name: Ident,
    /// The runtime as emitted code names it.
    pub(crate) runtime: TokenStream,
    /// `f64` or `f32`.
    pub(crate) float: Ident,
    /// The shape and type that q and p share.
    pub(crate) coordinates: Argument,
    /// All arguments in the order of the signature.
    pub(crate) arguments: Vec<(Role, Argument)>,
    pub(crate) requirements: Vec<(Requirement, Span)>,
}

/// What an argument of the function is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Position,
    Momentum,
    Time,
    Parameter,
}

/// An argument with its name and type.
#[derive(Clone)]
pub(crate) struct Argument {
    pub(crate) name: Ident,
    pub(crate) ty: Type,
    pub(crate) shape: Shape,
}

/// Extents from outside in; none for a scalar.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    pub(crate) extents: Vec<usize>,
    /// Whether the innermost level is a vector of nalgebra.
    pub(crate) vector: bool,
}

/// A property that the user asks the macro to prove.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Requirement {
    Separable,
    QuadraticKinetic,
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

impl Energy {
    pub(crate) fn parameters(&self) -> impl Iterator<Item = &Argument> {
        self.arguments.iter().filter(|(role, _)| *role == Role::Parameter).map(|(_, argument)| argument)
    }

    /// The number of degrees of freedom.
    pub(crate) fn degrees(&self) -> u32 {
        self.coordinates.shape.len() as u32
    }

    /// All scalars of an argument as symbols; parameters are numbered through.
    pub(crate) fn symbols(&self, role: Role, argument: &Argument) -> Vec<Symbol> {
        let before: usize =
            self.parameters().take_while(|other| other.name != argument.name).map(|other| other.shape.len()).sum();
        let symbol = |i: usize| match role {
            Role::Position => Symbol::Q(i as u32),
            Role::Momentum => Symbol::P(i as u32),
            Role::Time => Symbol::T,
            Role::Parameter => Symbol::Parameter((before + i) as u32),
        };
        (0..argument.shape.len()).map(symbol).collect()
    }
}

/// Groups inside groups, within a fraction of the stack of rustc.
const MAX_NESTING: usize = 256;

/// Refuses what could not be parsed without overflowing the stack.
pub(crate) fn nesting(item: &TokenStream) -> Result<()> {
    let mut level: Vec<TokenStream> = vec![item.clone()];
    for _ in 0..MAX_NESTING {
        let groups = level.into_iter().flatten().filter_map(|tree| match tree {
            TokenTree::Group(group) => Some(group.stream()),
            _ => None,
        });
        level = groups.collect();
        if level.is_empty() {
            return Ok(());
        }
    }
    let mut errors = Diagnostics::default();
    errors.at(&level.into_iter().flatten().next(), "this is nested too deeply: give parts of it a name with `let`");
    Err(errors)
}

/// The arguments of the attribute.
#[derive(Default)]
struct Options {
    name: Option<Ident>,
    runtime: Option<syn::Path>,
    roles: Vec<(Role, Ident)>,
    requirements: Vec<(Requirement, Span)>,
}

const OPTIONS: &str = "the arguments of this attribute are `name = Type`, `q = argument`, `p = argument`, `t = argument`, \
                       `crate = path` and `require(separable, quadratic_kinetic)`";

impl Parse for Options {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut options = Options::default();
        let mut given: Vec<Ident> = vec![];
        while !input.is_empty() {
            let key = input.call(Ident::parse_any)?;
            if key != "require" && given.contains(&key) {
                return Err(syn::Error::new_spanned(&key, format!("`{key}` is given twice")));
            }
            given.push(key.clone());
            match key.to_string().as_str() {
                "require" => {
                    let inner;
                    syn::parenthesized!(inner in input);
                    for name in Punctuated::<Ident, Token![,]>::parse_terminated(&inner)? {
                        let requirement = match name.to_string().as_str() {
                            "separable" => Requirement::Separable,
                            "quadratic_kinetic" => Requirement::QuadraticKinetic,
                            _ => {
                                let message = "what can be required is `separable` and `quadratic_kinetic`";
                                return Err(syn::Error::new_spanned(name, message));
                            }
                        };
                        options.requirements.push((requirement, name.span()));
                    }
                }
                "crate" => {
                    input.parse::<Token![=]>()?;
                    options.runtime = Some(input.parse()?);
                }
                name @ ("name" | "q" | "p" | "t") => {
                    input.parse::<Token![=]>()?;
                    let value: Ident = input.parse()?;
                    match name {
                        "name" => options.name = Some(value),
                        "q" => options.roles.push((Role::Position, value)),
                        "p" => options.roles.push((Role::Momentum, value)),
                        _ => options.roles.push((Role::Time, value)),
                    }
                }
                _ => return Err(syn::Error::new_spanned(key, OPTIONS)),
            }
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(options)
    }
}

/// Reads the attribute's arguments and the signature.
pub(crate) fn energy(args: TokenStream, item: ItemFn) -> Result<Energy> {
    let options = Options::parse.parse2(args)?;
    let mut errors = Diagnostics::default();
    plain_function(&item, &mut errors);
    // What follows from a parameter of the signature is not a mistake of its own.
    let mut errors = errors.or(Diagnostics::default())?;
    let float = returned_float(&item, &mut errors);
    let arguments = arguments(&item, &options, &float, &mut errors);
    let coordinates = coordinates(&item, &options, &arguments, &mut errors);
    let name = options.name.unwrap_or_else(|| camel_case(&item.sig.ident));
    if name == "R" {
        errors.at(&name, "`R` is the scalar of generated code; give the struct another name: `name = …`");
    }
    let runtime = options.runtime.map_or_else(|| quote!(::geoint_runtime), ToTokens::into_token_stream);
    if arguments.iter().all(|(role, _)| *role != Role::Parameter) && name == item.sig.ident {
        errors.at(&item.sig.ident, "the generated struct would have the name of the function; give it one: `name = …`");
    }
    match coordinates {
        Some(coordinates) => {
            errors.or(Energy { name, runtime, float, coordinates, arguments, requirements: options.requirements, item })
        }
        None => Err(errors),
    }
}

/// An energy is a plain function of numbers.
fn plain_function(item: &ItemFn, errors: &mut Diagnostics) {
    let signature = &item.sig;
    let mut refuse = |syntax: &dyn ToTokens, message: &str| errors.at(&syntax.to_token_stream(), message);
    if let Some(token) = &signature.asyncness {
        refuse(token, "an energy cannot be async: it is a plain function of numbers");
    }
    if let Some(abi) = &signature.abi {
        refuse(abi, "an energy cannot have a foreign ABI: it is a plain function of numbers");
    }
    for parameter in &signature.generics.params {
        refuse(
            parameter,
            match parameter {
                syn::GenericParam::Const(_) => {
                    "const generics are not supported yet: write the length as a number; loops over it are unrolled"
                }
                _ => "an energy cannot be generic: write `f64` or `f32`; the generated code is generic by itself",
            },
        );
    }
    if let Some(receiver) = signature.receiver() {
        refuse(receiver, "an energy cannot have a receiver: make every quantity an argument");
    }
}

/// The float type that the function returns; every other number must have it too.
fn returned_float(item: &ItemFn, errors: &mut Diagnostics) -> Ident {
    let message = "an energy returns one number: `-> f64` or `-> f32`";
    match &item.sig.output {
        ReturnType::Type(_, ty) => match float_type(ty) {
            Some(float) => return float,
            None => errors.at(ty, message),
        },
        ReturnType::Default => errors.at(&item.sig.ident, message),
    }
    format_ident!("f64")
}

fn float_type(ty: &Type) -> Option<Ident> {
    let Type::Path(path) = ty else { return None };
    let ident = path.path.get_ident()?;
    (ident == "f64" || ident == "f32").then(|| ident.clone())
}

fn arguments(item: &ItemFn, options: &Options, float: &Ident, errors: &mut Diagnostics) -> Vec<(Role, Argument)> {
    let renamed = |role: Role| options.roles.iter().find(|(r, _)| *r == role).map(|(_, name)| name);
    let mut refused: Vec<String> = vec![];
    let mut arguments: Vec<(Role, Argument)> = vec![];
    for input in &item.sig.inputs {
        let FnArg::Typed(typed) = input else { continue };
        let Pat::Ident(pattern) = &*typed.pat else {
            errors.at(&typed.pat, "an argument of an energy is a name; take it apart with `let` in the body");
            continue;
        };
        let name = &pattern.ident;
        let explicit = options.roles.iter().find(|(_, other)| other == name).map(|(role, _)| *role);
        let by_name = DEFAULTS.iter().find(|(_, default, _)| name == default);
        let role = match (explicit, by_name) {
            (Some(role), _) => role,
            (None, Some((default, letter, _))) => match renamed(*default) {
                Some(other) if exists(item, other) => {
                    errors.at(
                        name,
                        format!("`{letter}` is `{other}` here, so that no other argument can have that name"),
                    );
                    continue;
                }
                _ => *default,
            },
            (None, None) => Role::Parameter,
        };
        match shape(&typed.ty, float) {
            Ok(shape) if role == Role::Time && !shape.extents.is_empty() => {
                errors
                    .at(&typed.ty, format!("`{name}` is time, a scalar; for a coordinate of that name write `t = …`"));
            }
            Ok(shape) => arguments.push((role, Argument { name: name.clone(), ty: (*typed.ty).clone(), shape })),
            // One message a type: q and p share theirs.
            Err(error) => {
                let ty = typed.ty.to_token_stream().to_string();
                if !refused.contains(&ty) {
                    refused.push(ty);
                    errors.extend(error);
                }
            }
        }
    }
    for (i, (role, name)) in options.roles.iter().enumerate() {
        if let Some((other, _)) = options.roles[..i].iter().find(|(_, n)| n == name) {
            let message = match (role, other) {
                (Role::Time, _) | (_, Role::Time) => format!("`{name}` is time and cannot be a coordinate as well"),
                _ => format!("`{name}` cannot be both positions and momenta"),
            };
            errors.at(name, message);
        } else if !exists(item, name) {
            errors.at(name, format!("the function has no argument `{name}`"));
        } else if let Some((_, letter, what)) = DEFAULTS.iter().find(|(r, letter, _)| {
            // The name says one thing and the attribute another.
            r != role && name == letter && renamed(*r).is_none()
        }) {
            let message = match letter {
                &"t" => {
                    "`t` is time and cannot be a coordinate: rename it, or name another argument with `t = …`".into()
                }
                _ => format!("`{name}` is the name of {what}: say which argument that is with `{letter} = …`"),
            };
            errors.at(name, message);
        }
    }
    arguments
}

/// Who an argument is by its name alone.
const DEFAULTS: [(Role, &str, &str); 3] =
    [(Role::Position, "q", "the positions"), (Role::Momentum, "p", "the momenta"), (Role::Time, "t", "time")];

fn exists(item: &ItemFn, name: &Ident) -> bool {
    item.sig.inputs.iter().any(|input| matches!(input, FnArg::Typed(typed) if names(&typed.pat, name)))
}

fn names(pattern: &Pat, name: &Ident) -> bool {
    matches!(pattern, Pat::Ident(pattern) if pattern.ident == *name)
}

/// The shape that q and p share.
fn coordinates(
    item: &ItemFn,
    options: &Options,
    arguments: &[(Role, Argument)],
    errors: &mut Diagnostics,
) -> Option<Argument> {
    let mut find = |role: Role, default: &str, what: &str| {
        let found = arguments.iter().find(|(r, _)| *r == role).map(|(_, argument)| argument.clone());
        // A wrong name in the attribute, or a wrong type, has been reported.
        let named = options.roles.iter().any(|(r, _)| *r == role);
        let written = exists(item, &format_ident!("{default}"));
        if found.is_none() && !named && !written {
            errors.at(
                &item.sig.ident,
                format!("{what} are missing: call an argument `{default}`, or name one with `{default} = …`"),
            );
        }
        found
    };
    let q = find(Role::Position, "q", "positions");
    let p = find(Role::Momentum, "p", "momenta");
    let (q, p) = (q?, p?);
    if q.ty.to_token_stream().to_string() != p.ty.to_token_stream().to_string() {
        errors.at(
            &p.ty,
            format!(
                "`{}` must have the type of `{}`, `{}`: each position has its momentum",
                p.name,
                q.name,
                plain(&q.ty)
            ),
        );
    }
    Some(q)
}

/// A type as one writes it.
fn plain(ty: &Type) -> String {
    ty.to_token_stream().to_string().replace(" < ", "<").replace(" >", ">").replace(" :: ", "::").replace(" ,", ",")
}

const TYPES: &str = "`f64`, `f32`, `[f64; N]`, `[[f64; D]; N]`, vectors of nalgebra such as `Vector3<f64>` or \
                     `SVector<f64, 4>`, and arrays of them";

const INTEGERS: [&str; 12] = ["u8", "u16", "u32", "u64", "u128", "usize", "i8", "i16", "i32", "i64", "i128", "isize"];

/// The shape of a type.
fn shape(ty: &Type, float: &Ident) -> syn::Result<Shape> {
    let refuse =
        |syntax: &dyn ToTokens, message: String| Err(syn::Error::new_spanned(syntax.to_token_stream(), message));
    match ty {
        Type::Paren(inner) => shape(&inner.elem, float),
        Type::Group(inner) => shape(&inner.elem, float),
        Type::Array(array) => {
            let Some(extent) = length(&array.len) else {
                return refuse(&array.len, "a length is a number for now, such as `[f64; 3]`".into());
            };
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
                return Ok(Shape { extents: vec![], vector: false });
            }
            match vector(path, float)? {
                Some(extent) => Ok(Shape { extents: vec![extent], vector: true }),
                None if INTEGERS.iter().any(|integer| path.path.is_ident(integer)) => refuse(
                    ty,
                    "an argument is a number or made of numbers, not an integer: write that as a `const` in the body"
                        .into(),
                ),
                None => refuse(ty, format!("an argument may be {TYPES}")),
            }
        }
        Type::Reference(_) => refuse(ty, format!("arguments are taken by value; an argument may be {TYPES}")),
        _ => refuse(ty, format!("an argument may be {TYPES}")),
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
        (None, "SVector", Some(GenericArgument::Const(n))) => Ok(length(n)),
        (None, "SVector", Some(n)) => {
            Err(syn::Error::new_spanned(n, "a length is a number for now, such as `SVector<f64, 4>`"))
        }
        _ => Ok(None),
    }
}

fn length(expr: &Expr) -> Option<usize> {
    match expr {
        Expr::Lit(ExprLit { lit: Lit::Int(n), .. }) => n.base10_parse().ok().filter(|n| (1..=1000).contains(n)),
        Expr::Group(group) => length(&group.expr),
        _ => None,
    }
}

/// `henon_heiles` → `HenonHeiles`.
fn camel_case(name: &Ident) -> Ident {
    let text = name.unraw().to_string();
    let camel: String = text
        .split('_')
        .flat_map(|word| {
            let mut letters = word.chars();
            letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<Vec<_>>()
        })
        .collect();
    match camel.chars().next() {
        Some(first) if first.is_alphabetic() && camel != "Self" => Ident::new(&camel, name.span()),
        _ => format_ident!("Energy{camel}", span = name.span()),
    }
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
