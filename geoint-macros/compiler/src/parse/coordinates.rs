//! Coordinates of a system: positions with their momenta or velocities, x alone, or attitudes of rigid bodies.

use super::arguments::{is_called, is_velocity, names, velocity_for_momenta};
use super::options::Options;
use super::shape::{Leaf, Shape, plain};
use super::{Argument, Form, Role, of_role};
use crate::diagnostics::Diagnostics;
use quote::{ToTokens, format_ident};
use syn::{Ident, ItemFn};

/// Returns the argument with the shape of the coordinates. Momenta and velocities have the same shape.
pub(super) fn coordinates(
    form: Form,
    item: &ItemFn,
    options: &Options,
    arguments: &[Argument],
    errors: &mut Diagnostics,
) -> Option<Argument> {
    if let Some(name) = velocity_for_momenta(form, item, options) {
        errors.at(name, format!("`{name}` {VELOCITY}"));
        return None;
    }
    // Arguments with a wrong name in the attribute or a wrong type have been reported, so they count as given.
    let is_given =
        |role: Role, default: &str| options.named(role).is_some() || names(item).any(|name| is_called(name, default));
    let mut find = |role: Role, default: &str, missing: Option<&str>| {
        if let Some(message) = missing.filter(|_| !is_given(role, default)) {
            errors.at(&item.sig.ident, message);
        }
        of_role(arguments, role).cloned()
    };
    if form == Form::Bodies {
        find(Role::AngularMomentum, "m", Some(ANGULAR_MOMENTUM))?;
        return bodies(arguments, errors);
    }
    if form.is_flow() {
        let missing = if form == Form::Field { FIELD_COORDINATES } else { STRUCTURED_COORDINATES };
        return find(Role::Position, "x", Some(missing));
    }
    if let (Form::Hamiltonian, None) = (form, of_role(arguments, Role::Momentum))
        && let Some(x) = without_momenta(options, arguments)
    {
        errors.at(x, missing_structure(item, x));
        return None;
    }
    let (other, letter, both) = match form {
        Form::Lagrangian => (Role::Velocity, "v", POSITIONS_AND_VELOCITIES),
        _ => (Role::Momentum, "p", POSITIONS_AND_MOMENTA),
    };
    let velocity = arguments.iter().map(|argument| &argument.name).find(|name| is_velocity(name));
    let neither = !is_given(Role::Position, "q") && !is_given(other, letter) && velocity.is_none();
    let q = find(Role::Position, "q", Some(if neither { both } else { POSITIONS }));
    if form == Form::Lagrangian {
        match velocity {
            Some(name) if !is_given(other, letter) => {
                errors.at(name, format!("velocities are called `v`; say that they are `{name}`: `v = {name}`"));
                return None;
            }
            // Momenta in place of velocities have been reported.
            _ => {
                let reported = neither || names(item).any(|name| name == "p");
                let v = find(other, letter, (!reported).then_some(VELOCITIES));
                return pair(q?, &v?, "velocity", errors);
            }
        }
    }
    let p = find(other, letter, (!neither).then_some(MOMENTA));
    if form == Form::Contact {
        let rest = if options.lift.is_some() { UNREAD_ACTION } else { NO_ACTION };
        find(Role::Action, "s", Some(&format!("{MISSING_ACTION}; {rest}")));
    }
    pair(q?, &p?, "momentum", errors)
}

/// Returns the argument `x` of an energy, or of its attribute, if the energy has no positions `q`.
fn without_momenta<'a>(options: &'a Options, arguments: &'a [Argument]) -> Option<&'a Ident> {
    match (&options.all, of_role(arguments, Role::Position)) {
        (None, None) => arguments.iter().map(|argument| &argument.name).find(|name| is_called(name, "x")),
        (named, _) => named.as_ref(),
    }
}

/// Returns the message for an energy with coordinates `x` and without a structure. An argument such as `px` suggests a pair (q, p).
fn missing_structure(item: &ItemFn, x: &Ident) -> String {
    let momentum = |prefix: &&str| names(item).any(|name| *name == format_ident!("{prefix}{x}"));
    match ["p", "p_", "mom_"].into_iter().find(momentum) {
        Some(prefix) => format!(
            "a position `{x}` with its momentum `{prefix}{x}`: say so in the attribute, `q = {x}, p = {prefix}{x}`; several \
             positions are one array `q: [f64; N]`, and their momenta `p`"
        ),
        None => WITHOUT_STRUCTURE.into(),
    }
}

/// Returns the positions. Reports momenta or velocities of another type.
fn pair(q: Argument, p: &Argument, conjugate: &str, errors: &mut Diagnostics) -> Option<Argument> {
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
        let (name, ty) = (&q.name, plain(&q.ty));
        let message = format!("`{}` must have the type of `{name}`, `{ty}`: each position has its {conjugate}", p.name);
        errors.at(&p.ty, message);
    }
    Some(q)
}

/// Returns the attitudes of rigid bodies as quaternions, one row for each body. Centres of mass add the same number of rows.
fn bodies(arguments: &[Argument], errors: &mut Diagnostics) -> Option<Argument> {
    let find = |role: Role| of_role(arguments, role);
    let (r, m) = (find(Role::Attitude)?, find(Role::AngularMomentum)?);
    if r.shape.leaf != Leaf::Quaternion {
        errors.at(&r.ty, ATTITUDE);
        return None;
    }
    let bodies = r.shape.len() / 4;
    let extents = if r.shape.extents.len() == 1 { vec![3] } else { vec![bodies, 3] };
    let vectors = Shape { extents, leaf: Leaf::Vector };
    let [q, p] = [Role::Position, Role::Momentum].map(find);
    let all = [
        (Some(m), "the angular momentum of each body, in its own frame"),
        (q, "where the centre of mass of each body is, in space"),
        (p, "the momentum of each centre of mass, in space"),
    ];
    let wrong = all.into_iter().find_map(|(given, meaning)| Some((given.filter(|a| a.shape != vectors)?, meaning)));
    if let Some((argument, meaning)) = wrong {
        let scalar = if r.ty.to_token_stream().to_string().contains("f32") { "f32" } else { "f64" };
        let ty = match r.shape.extents.len() {
            1 => format!("Vector3<{scalar}>"),
            _ => format!("[Vector3<{scalar}>; {bodies}]"),
        };
        errors.at(&argument.ty, format!("`{}` must be `{ty}`: {meaning}", argument.name));
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

const ATTITUDE: &str =
    "an attitude is `UnitQuaternion<f64>`, or an array of them: what turns vectors of a body into vectors of space";

const CENTRE_ALONE: &str =
    "centres of mass have positions `q` and momenta `p`: add the other, or, if this is a parameter, name it otherwise";

const ANGULAR_MOMENTUM: &str =
    "the angular momentum is missing: call an argument `m`, or name one with `m = …`; it is in the frame of the body";
