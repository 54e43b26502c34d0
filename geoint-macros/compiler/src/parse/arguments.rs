//! Arguments of the function, each with its role: q, p, s, t or a parameter.

use super::options::Options;
use super::shape::shape;
use super::{Argument, Form, Role};
use crate::diagnostics::Diagnostics;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Attribute, FnArg, Item, ItemFn, Pat, Stmt, Type};

/// Returns all valid arguments in the order of the signature. Reports the others.
pub(super) fn arguments(
    form: Form,
    item: &ItemFn,
    options: &Options,
    float: &Ident,
    errors: &mut Diagnostics,
) -> Vec<Argument> {
    let conventions = conventions(form);
    let velocity = velocity_for_momenta(form, item, options);
    let mut refused: Vec<String> = vec![];
    let mut arguments: Vec<Argument> = vec![];
    for input in &item.sig.inputs {
        let FnArg::Typed(typed) = input else { continue };
        let Pat::Ident(pattern) = &*typed.pat else {
            errors.at(&typed.pat, "an argument of an energy is a name; take it apart with `let` in the body");
            continue;
        };
        let name = &pattern.ident;
        attributes_of_argument(&typed.attrs, errors);
        let by_name = conventions.iter().find(|convention| is_called(name, convention.name));
        if form == Form::Hamiltonian && by_name.is_some_and(|convention| convention.role == Role::Action) {
            if velocity.is_none() {
                errors.at(name, ACTION);
            }
            continue;
        }
        let explicit = options.roles.iter().find(|(_, other)| other == name).map(|(role, _)| *role);
        if form == Form::Lagrangian && explicit.is_none() && is_called(name, "p") {
            errors.at(name, MOMENTUM_OF_LAGRANGIAN);
            continue;
        }
        let role = match (explicit, by_name) {
            (Some(role), _) => role,
            (None, Some(Convention { role, name: letter, .. })) => match options.named(*role) {
                Some(other) if exists(item, other) => {
                    let message = format!("`{letter}` is `{other}` here, so that no other argument can have that name");
                    errors.at(name, message);
                    continue;
                }
                _ => *role,
            },
            (None, None) => Role::Parameter,
        };
        let scalar = match role {
            Role::Time => Some("is time, a scalar; for a coordinate of that name write `t = …`"),
            Role::Action => Some("is the action, a scalar; for a parameter of that name write `s = …`"),
            _ => None,
        };
        let ty = options.outside.resolve(&typed.ty);
        match shape(&ty, float) {
            Ok(shape) => match scalar.filter(|_| !shape.extents.is_empty()) {
                Some(message) => errors.at(&typed.ty, format!("`{name}` {message}")),
                None => {
                    arguments.push(Argument { role, name: name.clone(), ty, shape, attributes: typed.attrs.clone() });
                }
            },
            Err(error) => {
                // Positions and momenta have the same type. Each type gets one message.
                let text = typed.ty.to_token_stream().to_string();
                if !refused.contains(&text) {
                    refused.push(text);
                    refuse_type(item, &typed.ty, error, errors);
                }
            }
        }
    }
    check_roles(&conventions, item, options, errors);
    arguments
}

/// Reports an invalid type. If the type contains a constant of the body, the message explains its scope.
fn refuse_type(item: &ItemFn, ty: &Type, error: syn::Error, errors: &mut Diagnostics) {
    let constant = item.block.stmts.iter().find_map(|statement| match statement {
        Stmt::Item(Item::Const(constant)) => place_of_name(ty.to_token_stream(), &constant.ident),
        _ => None,
    });
    match constant {
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

/// Returns the first occurrence of a name in tokens.
fn place_of_name(tokens: TokenStream, name: &Ident) -> Option<Ident> {
    tokens.into_iter().find_map(|tree| match tree {
        TokenTree::Ident(ident) if ident == *name => Some(ident),
        TokenTree::Group(group) => place_of_name(group.stream(), name),
        _ => None,
    })
}

/// Checks the roles that the attribute names. Each argument exists and has one role. Its name does not suggest another role.
fn check_roles(conventions: &[Convention], item: &ItemFn, options: &Options, errors: &mut Diagnostics) {
    for (i, (role, name)) in options.roles.iter().enumerate() {
        let suggests_other = |convention: &&Convention| {
            convention.role != *role && name == convention.name && options.named(convention.role).is_none()
        };
        if let Some((other, _)) = options.roles[..i].iter().find(|(_, other)| other == name) {
            let message = if [role, other].contains(&&Role::Time) {
                "is time and cannot be a coordinate as well"
            } else if [role, other].contains(&&Role::Action) {
                "is the action and cannot be a coordinate as well"
            } else if [role, other].contains(&&Role::Velocity) {
                "cannot be both positions and velocities"
            } else {
                "cannot be both positions and momenta"
            };
            errors.at(name, format!("`{name}` {message}"));
        } else if !exists(item, name) {
            errors.at(name, format!("the function has no argument `{name}`"));
        } else if let Some(Convention { name: letter, meaning, .. }) = conventions.iter().find(suggests_other) {
            let message = match *letter {
                "t" => {
                    "`t` is time and cannot be a coordinate: rename it, or name another argument with `t = …`".into()
                }
                _ => format!("`{name}` is the name of {meaning}: say which argument that is with `{letter} = …`"),
            };
            errors.at(name, message);
        }
    }
}

/// Refuses attributes of an argument, except lints. Other attributes might remove the argument.
fn attributes_of_argument(attributes: &[Attribute], errors: &mut Diagnostics) {
    // rustc refuses documentation of arguments itself.
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

/// Role of an argument by its name alone.
struct Convention {
    role: Role,
    name: &'static str,
    /// Description of the role in messages.
    meaning: &'static str,
}

/// Returns the roles of arguments by their names, for each form of system.
fn conventions(form: Form) -> Vec<Convention> {
    let convention = |role, name, meaning| Convention { role, name, meaning };
    let positions = convention(Role::Position, "q", "the positions");
    let action = convention(Role::Action, "s", "the action");
    let time = convention(Role::Time, "t", "time");
    match form {
        Form::Structured | Form::Field => vec![convention(Role::Position, "x", "the coordinates"), time],
        Form::Bodies => vec![
            convention(Role::AngularMomentum, "m", "the angular momenta"),
            convention(Role::Position, "q", "the centres of mass"),
            convention(Role::Momentum, "p", "the momenta of centres of mass"),
            time,
        ],
        Form::Hamiltonian | Form::Contact => {
            vec![positions, convention(Role::Momentum, "p", "the momenta"), action, time]
        }
        Form::Lagrangian | Form::Herglotz | Form::FirstOrder => {
            vec![positions, convention(Role::Velocity, "v", "the velocities"), action, time]
        }
    }
}

const ACTION: &str = "`s` is the action of a contact system: for a system that dissipates by it use `#[contact_hamiltonian]`; a \
                      parameter needs another name";

const MOMENTUM_OF_LAGRANGIAN: &str =
    "a Lagrangian is a function of positions `q` and velocities `v`; an energy H(q, p) goes under `#[hamiltonian]`";

/// Returns whether an argument has the given name, with or without the underscore of unused arguments.
pub(super) fn is_called(name: &Ident, default: &str) -> bool {
    name == default || name.to_string().strip_prefix('_') == Some(default)
}

fn exists(item: &ItemFn, name: &Ident) -> bool {
    names(item).any(|other| other == name)
}

/// Returns the names of all arguments.
pub(super) fn names(item: &ItemFn) -> impl Iterator<Item = &Ident> {
    item.sig.inputs.iter().filter_map(|input| match input {
        FnArg::Typed(typed) => match &*typed.pat {
            Pat::Ident(pattern) => Some(&pattern.ident),
            _ => None,
        },
        FnArg::Receiver(_) => None,
    })
}

/// Returns an argument with the name of a velocity, if an energy has no momenta. Further errors would follow from this one.
pub(super) fn velocity_for_momenta<'a>(form: Form, item: &'a ItemFn, options: &Options) -> Option<&'a Ident> {
    let has_momenta = options.named(Role::Momentum).is_some() || names(item).any(|name| is_called(name, "p"));
    let of_energy = matches!(form, Form::Hamiltonian | Form::Contact);
    (of_energy && !has_momenta).then(|| names(item).find(|name| is_velocity(name))).flatten()
}

/// Returns whether a name is usual for a velocity in a Lagrangian.
pub(super) fn is_velocity(name: &Ident) -> bool {
    let name = name.to_string();
    let name = name.trim_start_matches('_');
    ["v", "vel", "velocity", "velocities", "dq", "qd"].contains(&name) || name.ends_with("dot")
}
