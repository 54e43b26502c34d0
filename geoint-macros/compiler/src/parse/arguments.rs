//! Arguments: who is q, p, s and t, and who is a parameter.

use super::options::Options;
use super::shape::shape;
use super::{Argument, Form, Role};
use crate::diagnostics::Diagnostics;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{ToTokens, format_ident};
use syn::{Attribute, FnArg, Item, ItemFn, Pat, Stmt, Type};

/// All arguments that are understood, in the order of the signature.
pub(super) fn arguments(
    form: Form,
    item: &ItemFn,
    options: &Options,
    float: &Ident,
    errors: &mut Diagnostics,
) -> Vec<(Role, Argument)> {
    let renamed = |role: Role| options.roles.iter().find(|(r, _)| *r == role).map(|(_, name)| name);
    let velocity = velocity_for_momenta(form, item, options);
    let mut refused: Vec<String> = vec![];
    let mut arguments: Vec<(Role, Argument)> = vec![];
    for input in &item.sig.inputs {
        let FnArg::Typed(typed) = input else { continue };
        let Pat::Ident(pattern) = &*typed.pat else {
            errors.at(&typed.pat, "an argument of an energy is a name; take it apart with `let` in the body");
            continue;
        };
        let name = &pattern.ident;
        attributes_of_argument(&typed.attrs, errors);
        let explicit = options.roles.iter().find(|(_, other)| other == name).map(|(role, _)| *role);
        let by_name = defaults(form).iter().find(|(_, default, _)| is_called(name, default));
        if form == Form::Hamiltonian && by_name.is_some_and(|(role, ..)| *role == Role::Action) {
            if velocity.is_none() {
                errors.at(name, ACTION);
            }
            continue;
        }
        if form == Form::Lagrangian && explicit.is_none() && is_called(name, "p") {
            errors.at(name, MOMENTUM_OF_LAGRANGIAN);
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
        let ty = options.outside.resolve(&typed.ty);
        match shape(&ty, float) {
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
            Ok(shape) => {
                let (name, attributes) = (name.clone(), typed.attrs.clone());
                arguments.push((role, Argument { name, ty, shape, attributes }));
            }
            // One message a type: q and p share theirs.
            Err(error) => {
                let ty = typed.ty.to_token_stream().to_string();
                if !refused.contains(&ty) {
                    refused.push(ty);
                    match constant_of_body(item, &typed.ty) {
                        Some(name) => errors.at(
                            &name,
                            format!(
                                "arguments do not see the constants of the body: put `{name}` above the function, and \
                                 repeat it in the attribute: `const {name} = …`"
                            ),
                        ),
                        None => errors.extend(error),
                    }
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
                (Role::Velocity, _) | (_, Role::Velocity) => {
                    format!("`{name}` cannot be both positions and velocities")
                }
                _ => format!("`{name}` cannot be both positions and momenta"),
            };
            errors.at(name, message);
        } else if !exists(item, name) {
            errors.at(name, format!("the function has no argument `{name}`"));
        } else if let Some((_, letter, what)) = defaults(form).iter().find(|(r, letter, _)| {
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

/// A constant inside of the body that is named in a type.
fn constant_of_body(item: &ItemFn, ty: &Type) -> Option<Ident> {
    fn named(tokens: TokenStream, name: &Ident) -> Option<Ident> {
        tokens.into_iter().find_map(|tree| match tree {
            TokenTree::Ident(ident) if ident == *name => Some(ident),
            TokenTree::Group(group) => named(group.stream(), name),
            _ => None,
        })
    }
    item.block.stmts.iter().find_map(|statement| match statement {
        Stmt::Item(Item::Const(constant)) => named(ty.to_token_stream(), &constant.ident),
        _ => None,
    })
}

/// An argument may come with lints, and with nothing that could take it away.
fn attributes_of_argument(attributes: &[Attribute], errors: &mut Diagnostics) {
    // Of documentation rustc says that it does not belong here.
    let stays = |attribute: &&Attribute| {
        ["allow", "expect", "warn", "deny", "forbid", "doc"].iter().any(|name| attribute.path().is_ident(name))
    };
    for attribute in attributes.iter().filter(|attribute| !stays(attribute)) {
        let name = attribute.path().to_token_stream();
        errors.at(
            attribute,
            format!(
                "`{name}` may change or remove this argument after it was read: leave it out; of two variants make two \
                 functions, with the condition above each"
            ),
        );
    }
}

/// Who an argument is by its name alone, its name, and what that is.
type Default = (Role, &'static str, &'static str);

fn defaults(form: Form) -> &'static [Default] {
    match form {
        Form::Bodies => &OF_BODIES,
        Form::Structured | Form::Field => &OF_FLOWS,
        Form::Hamiltonian | Form::Contact => &OF_ENERGIES,
        Form::Lagrangian | Form::Herglotz | Form::FirstOrder => &OF_LAGRANGIANS,
    }
}

const OF_BODIES: [Default; 4] = [
    (Role::AngularMomentum, "m", "the angular momenta"),
    (Role::Position, "q", "the centres of mass"),
    (Role::Momentum, "p", "the momenta of centres of mass"),
    (Role::Time, "t", "time"),
];

const OF_ENERGIES: [Default; 4] = [
    (Role::Position, "q", "the positions"),
    (Role::Momentum, "p", "the momenta"),
    (Role::Action, "s", "the action"),
    (Role::Time, "t", "time"),
];

const OF_LAGRANGIANS: [Default; 4] = [
    (Role::Position, "q", "the positions"),
    (Role::Velocity, "v", "the velocities"),
    (Role::Action, "s", "the action"),
    (Role::Time, "t", "time"),
];

const OF_FLOWS: [Default; 2] = [(Role::Position, "x", "the coordinates"), (Role::Time, "t", "time")];

const ACTION: &str = "`s` is the action of a contact system: for a system that dissipates by it use `#[contact_hamiltonian]`; a \
                      parameter needs another name";

/// Whether an argument has a name, or that name as an argument that is not used.
pub(super) fn is_called(name: &Ident, default: &str) -> bool {
    name == default || name.to_string().strip_prefix('_') == Some(default)
}

pub(super) fn exists(item: &ItemFn, name: &Ident) -> bool {
    names(item).any(|other| other == name)
}

/// The names of all arguments.
pub(super) fn names(item: &ItemFn) -> impl Iterator<Item = &Ident> {
    item.sig.inputs.iter().filter_map(|input| match input {
        FnArg::Typed(typed) => match &*typed.pat {
            Pat::Ident(pattern) => Some(&pattern.ident),
            _ => None,
        },
        FnArg::Receiver(_) => None,
    })
}

/// An argument with the name of a velocity, where an energy has no momenta: all else that is missing follows from that.
pub(super) fn velocity_for_momenta<'a>(form: Form, item: &'a ItemFn, options: &Options) -> Option<&'a Ident> {
    let named = options.roles.iter().any(|(role, _)| *role == Role::Momentum);
    let momenta = named || ["p", "_p"].iter().any(|name| exists(item, &format_ident!("{name}")));
    let of_energy = matches!(form, Form::Hamiltonian | Form::Contact);
    (of_energy && !momenta).then(|| names(item).find(|name| is_velocity(name))).flatten()
}

/// Whether an argument has the name that a velocity has in a Lagrangian.
pub(super) fn is_velocity(name: &Ident) -> bool {
    let name = name.to_string();
    let name = name.trim_start_matches('_');
    ["v", "vel", "velocity", "velocities", "dq", "qd"].contains(&name) || name.ends_with("dot")
}

const MOMENTUM_OF_LAGRANGIAN: &str =
    "a Lagrangian is a function of positions `q` and velocities `v`; an energy H(q, p) goes under `#[hamiltonian]`";
