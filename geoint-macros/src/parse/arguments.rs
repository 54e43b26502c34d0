//! Arguments: who is q, p, s and t, and who is a parameter.

use super::options::Options;
use super::shape::{Leaf, Shape, plain, shape};
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
            errors.at(name, ACTION);
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
                                 repeat it in the attribute: `const {name} = 3`"
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
    let is_lint = |attribute: &&Attribute| {
        ["allow", "expect", "warn", "deny", "forbid"].iter().any(|lint| attribute.path().is_ident(lint))
    };
    for attribute in attributes.iter().filter(|attribute| !is_lint(attribute)) {
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
fn is_called(name: &Ident, default: &str) -> bool {
    name == default || name.to_string().strip_prefix('_') == Some(default)
}

fn exists(item: &ItemFn, name: &Ident) -> bool {
    item.sig.inputs.iter().any(|input| matches!(input, FnArg::Typed(typed) if names(&typed.pat, name)))
}

fn names(pattern: &Pat, name: &Ident) -> bool {
    matches!(pattern, Pat::Ident(pattern) if pattern.ident == *name)
}

/// Whether an argument has the name that a velocity has in a Lagrangian.
fn is_velocity(name: &Ident) -> bool {
    let name = name.to_string();
    let name = name.trim_start_matches('_');
    ["v", "vel", "velocity", "velocities", "dq", "qd"].contains(&name) || name.ends_with("dot")
}

const FIELD_COORDINATES: &str = "the coordinates are missing: call an argument `x`, or name one with `x = …`; an energy H(q, p) goes under \
                                 `#[hamiltonian]`";

const STRUCTURED_COORDINATES: &str = "with `structure` the coordinates are one argument: call it `x`, or name one with `x = …`; an energy of \
                                      positions `q` and momenta `p` goes without `structure`";

const WITHOUT_STRUCTURE: &str = "an energy of `x` alone does not say how x moves: add S of x' = S(x) ∇H, `structure = so3` (also `se3`, \
                                 `canonical`, `nambu(C)`, `|i, j| …` for i < j, or an array of arrays); positions and momenta are \
                                 called `q` and `p`";

const POSITIONS: &str = "positions are missing: call an argument `q`, or name one with `q = …`";

const MOMENTA: &str = "momenta are missing: call an argument `p`, or name one with `p = …`";

const VELOCITY: &str = "is the name of a velocity, but an energy is a function of momenta, `p`: put a Lagrangian L(q, v) under \
                        `#[lagrangian]`, or write H = p·v − L with p = ∂L/∂v, which for L = m v²/2 − V(q) is p²/(2m) + V(q)";

const VELOCITIES: &str = "velocities are missing: call an argument `v`, or name one with `v = …`";

const MOMENTUM_OF_LAGRANGIAN: &str =
    "a Lagrangian is a function of positions `q` and velocities `v`; an energy H(q, p) goes under `#[hamiltonian]`";

const MISSING_ACTION: &str = "the action is missing: call an argument `s`, or name one with `s = …`";

const NO_ACTION: &str = "an energy without it is one for `#[hamiltonian]`";

const UNREAD_ACTION: &str = "a lift of q' = X(q), which does not read it, has the argument `_s`";

/// The shape that q and p share.
pub(super) fn coordinates(
    form: Form,
    item: &ItemFn,
    options: &Options,
    arguments: &[(Role, Argument)],
    errors: &mut Diagnostics,
) -> Option<Argument> {
    let mut find = |role: Role, default: &str, missing: &dyn Fn(&mut Diagnostics)| {
        let found = arguments.iter().find(|(r, _)| *r == role).map(|(_, argument)| argument.clone());
        // A wrong name in the attribute, or a wrong type, has been reported.
        let named = options.roles.iter().any(|(r, _)| *r == role);
        let written = exists(item, &format_ident!("{default}")) || exists(item, &format_ident!("_{default}"));
        if found.is_none() && !named && !written {
            missing(errors);
        }
        found
    };
    if form == Form::Bodies {
        return body(item, arguments, errors);
    }
    if form.is_flow() {
        return find(Role::Position, "x", &|errors| {
            let message = match form {
                Form::Field => FIELD_COORDINATES,
                _ => STRUCTURED_COORDINATES,
            };
            errors.at(&item.sig.ident, message);
        });
    }
    let unstructured = || arguments.iter().map(|(_, argument)| &argument.name).find(|name| is_called(name, "x"));
    if let (Form::Hamiltonian, None, Some(x)) =
        (form, arguments.iter().find(|(role, _)| [Role::Position, Role::Momentum].contains(role)), unstructured())
    {
        errors.at(x, WITHOUT_STRUCTURE);
        return None;
    }
    let q = find(Role::Position, "q", &|errors| errors.at(&item.sig.ident, POSITIONS));
    if form == Form::Lagrangian {
        let v = find(Role::Velocity, "v", &|errors| {
            let mut names = arguments.iter().map(|(_, argument)| &argument.name);
            match names.find(|name| is_velocity(name)) {
                Some(name) => {
                    errors.at(name, format!("velocities are called `v`; say that they are `{name}`: `v = {name}`"));
                }
                // Who has momenta in their place has been told.
                None if exists(item, &format_ident!("p")) => {}
                None => errors.at(&item.sig.ident, VELOCITIES),
            }
        });
        return pair(q?, (&v?, "velocity"), errors);
    }
    let p = find(Role::Momentum, "p", &|errors| {
        let velocity = arguments.iter().map(|(_, argument)| &argument.name).find(|name| is_velocity(name));
        match velocity {
            Some(name) => errors.at(name, format!("`{name}` {VELOCITY}")),
            None => errors.at(&item.sig.ident, MOMENTA),
        }
    });
    if form == Form::Contact {
        find(Role::Action, "s", &|errors| {
            let rest = if options.lift.is_some() { UNREAD_ACTION } else { NO_ACTION };
            errors.at(&item.sig.ident, format!("{MISSING_ACTION}; {rest}"));
        });
    }
    pair(q?, (&p?, "momentum"), errors)
}

/// Positions, if momenta or velocities have their type.
fn pair(q: Argument, (p, what): (&Argument, &str), errors: &mut Diagnostics) -> Option<Argument> {
    if q.shape.leaf == Leaf::Quaternion {
        errors.at(
            &q.ty,
            format!(
                "`{}` is the attitude of a rigid body: say so, `attitude = {}`, and call its angular momentum `m`",
                q.name, q.name
            ),
        );
        return None;
    }
    if q.ty.to_token_stream().to_string() != p.ty.to_token_stream().to_string() {
        errors.at(
            &p.ty,
            format!(
                "`{}` must have the type of `{}`, `{}`: each position has its {what}",
                p.name,
                q.name,
                plain(&q.ty)
            ),
        );
    }
    Some(q)
}

/// Attitudes as quaternions, one row a body, if angular momenta go with them; and as many rows for centres of mass.
fn body(item: &ItemFn, arguments: &[(Role, Argument)], errors: &mut Diagnostics) -> Option<Argument> {
    let find = |role: Role| arguments.iter().find(|(r, _)| *r == role).map(|(_, argument)| argument);
    let r = find(Role::Attitude)?;
    let Some(m) = find(Role::AngularMomentum) else {
        errors.at(&item.sig.ident, ANGULAR_MOMENTUM);
        return None;
    };
    if r.shape.leaf != Leaf::Quaternion {
        errors.at(&r.ty, ATTITUDE);
        return None;
    }
    let bodies = r.shape.len() / 4;
    let vectors = Shape { extents: [&r.shape.extents[..r.shape.extents.len() - 1], &[3]].concat(), leaf: Leaf::Vector };
    let [q, p] = [Role::Position, Role::Momentum].map(find);
    let all = [
        (Some(m), "the angular momentum of each body, in its own frame"),
        (q, "where the centre of mass of each body is, in space"),
        (p, "the momentum of each centre of mass, in space"),
    ];
    let wrong = all.into_iter().find_map(|(argument, what)| Some((argument.filter(|a| a.shape != vectors)?, what)));
    if let Some((argument, what)) = wrong {
        let scalar = if r.ty.to_token_stream().to_string().contains("f32") { "f32" } else { "f64" };
        let ty = match r.shape.extents.len() {
            1 => format!("Vector3<{scalar}>"),
            _ => format!("[Vector3<{scalar}>; {bodies}]"),
        };
        errors.at(&argument.ty, format!("`{}` must be `{ty}`: {what}", argument.name));
        return None;
    }
    let extents = match (q, p) {
        (None, None) => vec![bodies, 4],
        (Some(_), Some(_)) => vec![2, bodies, 4],
        (Some(alone), None) | (None, Some(alone)) => {
            errors.at(&alone.name, CENTRE_ALONE);
            return None;
        }
    };
    Some(Argument { shape: Shape { extents, leaf: Leaf::Quaternion }, ..r.clone() })
}

const ATTITUDE: &str =
    "an attitude is `UnitQuaternion<f64>`, or an array of them: what turns vectors of a body into vectors of space";

const CENTRE_ALONE: &str =
    "centres of mass have positions `q` and momenta `p`: add the other, or, if this is a parameter, name it otherwise";

const ANGULAR_MOMENTUM: &str =
    "the angular momentum is missing: call an argument `m`, or name one with `m = …`; it is in the frame of the body";
