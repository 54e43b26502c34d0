//! Arguments and signature: who is q, p and t, who is a parameter, in which shape.

mod options;
mod shape;

pub(crate) use options::Requirement;
pub(crate) use shape::{Shape, over_scalar};

use crate::diagnostics::{Diagnostics, Result};
use crate::ir::Symbol;
use options::Options;
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use shape::{float_type, plain, shape};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{FnArg, ItemFn, Pat, ReturnType, Type};

/// What kind of system an attribute makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    Hamiltonian,
    Contact,
}

/// An annotated function, understood up to its body.
pub(crate) struct Energy {
    pub(crate) form: Form,
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
    /// The coefficients of damping, in terms of the arguments.
    pub(crate) damping: Option<syn::Expr>,
    /// How a contact Hamiltonian is to be split into pieces, in terms of the arguments.
    pub(crate) split: Option<Vec<syn::Expr>>,
    /// Whether momenta of a contact Hamiltonian are not followed.
    pub(crate) lift: Option<Span>,
}

/// What an argument of the function is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Position,
    Momentum,
    Action,
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
            Role::Action => Symbol::S,
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

/// What emitted code imports: no struct can have such a name.
pub(crate) const IMPORTED: &[&str] = &[
    "Adaptive",
    "Array",
    "Autonomous",
    "Collocation",
    "ConformalContact",
    "Conservative",
    "ContactDiscreteGradient",
    "ContactMidpoint",
    "ContactPiece",
    "ContactPieces",
    "ContactState",
    "ContactSystem",
    "Cubic",
    "DiscreteField",
    "ForceGradient",
    "Hamiltonian",
    "ImplicitStep",
    "Integrator",
    "Mean",
    "MechanicalContact",
    "Method",
    "ModifiedEnergy",
    "PhaseSpace",
    "PieceClock",
    "QuadraticKinetic",
    "Real",
    "Separable",
    "Square",
    "State",
    "is_positive_semidefinite",
    "modified_verlet",
    "gradient_kick",
    "slope",
];

/// Whether emitted code has a name for something else.
fn is_taken(name: &Ident) -> bool {
    IMPORTED.iter().any(|taken| name == taken)
}

/// Reads the attribute's arguments and the signature.
pub(crate) fn energy(form: Form, args: TokenStream, item: ItemFn) -> Result<Energy> {
    let options = (|input: ParseStream<'_>| Options::parse(form, input)).parse2(args)?;
    let mut errors = Diagnostics::default();
    plain_function(&item, &mut errors);
    // What follows from a parameter of the signature is not a mistake of its own.
    let mut errors = errors.or(Diagnostics::default())?;
    let float = returned_float(&item, &mut errors);
    let arguments = arguments(form, &item, &options, &float, &mut errors);
    let coordinates = coordinates(&item, &options, &arguments, &mut errors);
    let name = options.name.unwrap_or_else(|| camel_case(&item.sig.ident));
    if name == "R" {
        errors.at(&name, "`R` is the scalar of generated code; give the struct another name: `name = …`");
    }
    if is_taken(&name) {
        errors.at(&name, format!("`{name}` is a name of generated code; give the struct another one: `name = …`"));
    }
    let runtime = options.runtime.map_or_else(|| quote!(::geoint_runtime), ToTokens::into_token_stream);
    if arguments.iter().all(|(role, _)| *role != Role::Parameter) && name == item.sig.ident {
        errors.at(&item.sig.ident, "the generated struct would have the name of the function; give it one: `name = …`");
    }
    match coordinates {
        Some(coordinates) => {
            let Options { requirements, damping, split, lift, .. } = options;
            errors.or(Energy {
                form,
                name,
                runtime,
                float,
                coordinates,
                arguments,
                requirements,
                damping,
                split,
                lift,
                item,
            })
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

fn arguments(
    form: Form,
    item: &ItemFn,
    options: &Options,
    float: &Ident,
    errors: &mut Diagnostics,
) -> Vec<(Role, Argument)> {
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
        let by_name = DEFAULTS.iter().find(|(_, default, _)| is_called(name, default));
        if form == Form::Hamiltonian && by_name.is_some_and(|(role, ..)| *role == Role::Action) {
            errors.at(name, ACTION);
            continue;
        }
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
            Ok(shape) if role == Role::Action && !shape.extents.is_empty() => {
                errors.at(
                    &typed.ty,
                    format!("`{name}` is the action, a scalar; for a parameter of that name write `s = …`"),
                );
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
                (Role::Action, _) | (_, Role::Action) => {
                    format!("`{name}` is the action and cannot be a coordinate as well")
                }
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
const DEFAULTS: [(Role, &str, &str); 4] = [
    (Role::Position, "q", "the positions"),
    (Role::Momentum, "p", "the momenta"),
    (Role::Action, "s", "the action"),
    (Role::Time, "t", "time"),
];

const ACTION: &str = "`s` is the action of a contact system: for a system that dissipates by it use `#[contact_hamiltonian]`; a \
                      parameter needs another name";

/// Whether an argument has a name, or that name as an argument that is not used.
fn is_called(name: &Ident, default: &str) -> bool {
    name == default || name.to_string().strip_prefix('_') == Some(default)
}

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
        let written = exists(item, &format_ident!("{default}")) || exists(item, &format_ident!("_{default}"));
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
