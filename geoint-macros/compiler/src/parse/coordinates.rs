//! Coordinates: positions with their momenta or velocities, x alone, or the attitudes of bodies.

use super::arguments::{exists, is_called, is_velocity, velocity_for_momenta};
use super::options::Options;
use super::shape::{Leaf, Shape, plain};
use super::{Argument, Form, Role};
use crate::diagnostics::Diagnostics;
use quote::{ToTokens, format_ident};
use syn::ItemFn;

/// The shape that q and p share.
pub(super) fn coordinates(
    form: Form,
    item: &ItemFn,
    options: &Options,
    arguments: &[(Role, Argument)],
    errors: &mut Diagnostics,
) -> Option<Argument> {
    if let Some(name) = velocity_for_momenta(form, item, options) {
        errors.at(name, format!("`{name}` {VELOCITY}"));
        return None;
    }
    let found = |role: Role| arguments.iter().find(|(r, _)| *r == role).map(|(_, argument)| argument);
    // A wrong name in the attribute, or a wrong type, has been reported.
    let told = |role: Role, default: &str| {
        found(role).is_some()
            || options.roles.iter().any(|(r, _)| *r == role)
            || exists(item, &format_ident!("{default}"))
            || exists(item, &format_ident!("_{default}"))
    };
    let mut find = |role: Role, default: &str, missing: &dyn Fn(&mut Diagnostics)| {
        if !told(role, default) {
            missing(errors);
        }
        found(role).cloned()
    };
    if form == Form::Bodies {
        find(Role::AngularMomentum, "m", &|errors| errors.at(&item.sig.ident, ANGULAR_MOMENTUM))?;
        return body(arguments, errors);
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
    let called_x = || arguments.iter().map(|(_, argument)| &argument.name).find(|name| is_called(name, "x"));
    let unstructured = match (&options.all, found(Role::Position)) {
        (None, None) => called_x(),
        (named, _) => named.as_ref(),
    };
    if let (Form::Hamiltonian, None, Some(x)) = (form, found(Role::Momentum), unstructured) {
        let named = |prefix: &str, name: &syn::Ident| exists(item, &format_ident!("{prefix}{name}"));
        match ["p", "p_", "mom_"].into_iter().find(|prefix| named(prefix, x)) {
            Some(prefix) => errors.at(
                x,
                format!(
                    "a position `{x}` with its momentum `{prefix}{x}`: say so in the attribute, `q = {x}, p = {prefix}{x}`; several \
                     positions are one array `q: [f64; N]`, and their momenta `p`"
                ),
            ),
            None => errors.at(x, WITHOUT_STRUCTURE),
        }
        return None;
    }
    let (other, letter, both) = match form {
        Form::Lagrangian => (Role::Velocity, "v", POSITIONS_AND_VELOCITIES),
        _ => (Role::Momentum, "p", POSITIONS_AND_MOMENTA),
    };
    let velocity = || arguments.iter().map(|(_, argument)| &argument.name).find(|name| is_velocity(name));
    let neither = !told(Role::Position, "q") && !told(other, letter) && velocity().is_none();
    let missing = if neither { both } else { POSITIONS };
    let q = find(Role::Position, "q", &|errors| errors.at(&item.sig.ident, missing));
    if form == Form::Lagrangian {
        let v = find(Role::Velocity, "v", &|errors| {
            match velocity() {
                Some(name) => {
                    errors.at(name, format!("velocities are called `v`; say that they are `{name}`: `v = {name}`"));
                }
                // Who has momenta in their place has been told.
                None if neither || exists(item, &format_ident!("p")) => {}
                None => errors.at(&item.sig.ident, VELOCITIES),
            }
        });
        return pair(q?, (&v?, "velocity"), errors);
    }
    let p = find(Role::Momentum, "p", &|errors| {
        if !neither {
            errors.at(&item.sig.ident, MOMENTA);
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

const FIELD_COORDINATES: &str = "the coordinates are missing: call an argument `x`, or name one with `x = …`; an energy H(q, p) goes under \
                                 `#[hamiltonian]`";

const STRUCTURED_COORDINATES: &str = "with `structure` the coordinates are one argument: call it `x`, or name one with `x = …`; an energy of \
                                      positions `q` and momenta `p` goes without `structure`";

const WITHOUT_STRUCTURE: &str = "an energy of `x` alone does not say how x moves: add S of x' = S(x) ∇H, `structure = so3` (also `se3`, \
                                 `canonical`, `nambu(C)`, `|i, j| …` for i < j, or an array of arrays); positions and momenta are \
                                 called `q` and `p`";

const POSITIONS_AND_MOMENTA: &str =
    "positions and momenta are missing: call arguments `q` and `p`, or name them with `q = …, p = …`";

const POSITIONS_AND_VELOCITIES: &str =
    "positions and velocities are missing: call arguments `q` and `v`, or name them with `q = …, v = …`";

const POSITIONS: &str = "positions are missing: call an argument `q`, or name one with `q = …`";

const MOMENTA: &str = "momenta are missing: call an argument `p`, or name one with `p = …`";

const VELOCITY: &str = "is the name of a velocity, but an energy is a function of momenta, `p`: put a Lagrangian L(q, v) under \
                        `#[lagrangian]`, or write H = p·v − L with p = ∂L/∂v, which for L = m v²/2 − V(q) is p²/(2m) + V(q)";

const VELOCITIES: &str = "velocities are missing: call an argument `v`, or name one with `v = …`";

const MISSING_ACTION: &str = "the action is missing: call an argument `s`, or name one with `s = …`";

const NO_ACTION: &str = "an energy without it is one for `#[hamiltonian]`";

const UNREAD_ACTION: &str = "a lift of q' = X(q), which does not read it, has the argument `_s`";

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
fn body(arguments: &[(Role, Argument)], errors: &mut Diagnostics) -> Option<Argument> {
    let find = |role: Role| arguments.iter().find(|(r, _)| *r == role).map(|(_, argument)| argument);
    let (r, m) = (find(Role::Attitude)?, find(Role::AngularMomentum)?);
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
