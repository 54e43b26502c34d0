//! Table of the arguments of attributes, with their notation, their attributes and their parsers.

use super::flow::{self, StructureForm};
use super::options::Options;
use super::values::{self, Coordinates, Requirement, listed};
use super::{Form, ROLLING_WITH_ACTION, Role};
use proc_macro2::{Ident, Span};
use std::rc::Rc;
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};

/// An argument of attributes.
struct Key {
    name: &'static str,
    /// Notation in messages. Empty if the notation of another argument includes this one.
    written: &'static str,
    /// Attributes with this argument. `None` is `#[energy_function]`.
    attributes: &'static [Option<Form>],
    read: Reader,
}

/// Parses the tokens after the name into the options. The identifier is the name.
type Reader = fn(&mut Options, &Ident, ParseStream<'_>) -> syn::Result<()>;

impl Key {
    /// Returns the argument of the given name. Errors: the attribute does not have this argument.
    fn of(attribute: Option<Form>, name: &Ident) -> syn::Result<&'static Key> {
        KEYS.iter().find(|key| name == key.name && key.attributes.contains(&attribute)).ok_or_else(|| {
            let elsewhere = ELSEWHERE.iter().find(|(other, form, _)| name == other && Some(*form) == attribute);
            let message = elsewhere.map_or_else(|| all(attribute), |(.., message)| (*message).into());
            syn::Error::new_spanned(name, message)
        })
    }

    /// Adds the notation of the argument to an error of the parser, at the given place. Errors of this crate stay as they are.
    fn with_notation(&self, error: syn::Error, place: Span) -> syn::Error {
        let message = error.to_string();
        if self.written.is_empty() || !["expected ", "unexpected "].iter().any(|start| message.starts_with(start)) {
            return error;
        }
        syn::Error::new(place, format!("{message}; this argument is written {}", self.written))
    }

    fn is_repeatable(&self) -> bool {
        ["require", "const", "type"].contains(&self.name)
    }
}

impl Options {
    /// Parses the arguments of the attribute of a form. `None` is `#[energy_function]`.
    pub(super) fn parse(attribute: Option<Form>, input: ParseStream<'_>) -> syn::Result<Self> {
        let mut options = Options::default();
        let mut given: Vec<Ident> = vec![];
        while !input.is_empty() {
            let name = input.call(Ident::parse_any)?;
            let key = Key::of(attribute, &name)?;
            if !key.is_repeatable() && given.contains(&name) {
                return Err(syn::Error::new_spanned(&name, format!("`{name}` is given twice")));
            }
            let is_last = input.is_empty();
            (key.read)(&mut options, &name, input).map_err(|error| {
                // At the end of the tokens, the place of the parser is the whole attribute.
                let is_at_end = is_last || error.to_string().starts_with("unexpected end");
                let place = if is_at_end { name.span() } else { error.span() };
                key.with_notation(error, place)
            })?;
            given.push(name);
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        options.consistent()
    }
}

/// Lists the notation of all arguments of an attribute.
fn all(attribute: Option<Form>) -> String {
    let taken = KEYS.iter().filter(|key| key.attributes.contains(&attribute) && !key.written.is_empty());
    let taken: Vec<String> = taken.map(|key| key.written.into()).collect();
    format!("the arguments of this attribute are {}", listed(&taken))
}

const H: Option<Form> = Some(Form::Hamiltonian);
const C: Option<Form> = Some(Form::Contact);
const F: Option<Form> = Some(Form::Field);
const L: Option<Form> = Some(Form::Lagrangian);
/// `#[energy_function]`.
const E: Option<Form> = None;

/// All arguments, in the order of messages.
const KEYS: [Key; 29] = [
    key("name", "`name = Type`", &[H, C, F, L], |to, _, input| set(&mut to.name, input)),
    key("x", "`x = argument`", &[F], |to, _, input| role(to, Role::Position, input)),
    key("q", "`q = argument`", &[H, C, L], |to, _, input| role(to, Role::Position, input)),
    key("p", "`p = argument`", &[H, C], |to, _, input| role(to, Role::Momentum, input)),
    key("v", "`v = argument`", &[L], |to, _, input| role(to, Role::Velocity, input)),
    key("s", "`s = argument`", &[C, L], |to, _, input| role(to, Role::Action, input)),
    key("t", "`t = argument`", &[H, C, F, L], |to, _, input| role(to, Role::Time, input)),
    key("keeps", "`keeps(integral = …, but = […])`", &[F], |to, _, input| {
        flow::keeps(input).map(|kept| to.keeps = kept)
    }),
    key("measure", "`measure = ρ`", &[F, C], |to, _, input| set(&mut to.measure, input)),
    key("damping", "`damping = coefficients`", &[H], |to, _, input| set(&mut to.damping, input)),
    key("rayleigh", "`rayleigh = R`", &[L], |to, _, input| set(&mut to.rayleigh, input)),
    key("force", "`force = F`", &[H, L], |to, _, input| set(&mut to.force, input)),
    key("constraint", "`constraint = [g]`", &[H, C, L], |to, _, input| {
        values::constraint(value(input)?).map(|functions| to.constraint = Some(functions))
    }),
    key("rolling", "`rolling = [A·v + b]`", &[H, L], |to, _, input| {
        values::constraint(value(input)?).map(|functions| to.rolling = Some(functions))
    }),
    key("split", "`split = \"terms | terms\"`", &[H, C], |to, _, input| {
        values::pieces(input).map(|pieces| to.split = Some(pieces))
    }),
    key("coordinates", "`coordinates = jacobi` or `heliocentric`", &[H, L], |to, _, input| {
        Coordinates::named(value(input)?).map(|named| to.coordinates = Some(named))
    }),
    key("structure", "`structure = S` with `x = argument`", &[H], |to, _, input| {
        value(input).map(|expr| to.structure = Some(StructureForm::new(expr)))
    }),
    key("entropy", "`entropy = S` with `friction = M`", &[H], |to, _, input| set(&mut to.entropy, input)),
    key("friction", "", &[H], |to, _, input| set(&mut to.friction, input)),
    key("x", "", &[H], |to, _, input| {
        let name: Ident = value(input)?;
        to.roles.push((Role::Position, name.clone()));
        to.all = Some(name);
        Ok(())
    }),
    key("attitude", "`attitude = argument` with `m = argument`", &[H], |to, _, input| role(to, Role::Attitude, input)),
    key("m", "", &[H], |to, _, input| role(to, Role::AngularMomentum, input)),
    key("lift", "`lift`", &[C], |to, key, _| {
        to.lift = Some(key.span());
        Ok(())
    }),
    key("const", "`const N = …`", &[H, C, F, L, E], |to, _, input| {
        Rc::make_mut(&mut to.outside).parse_constant(input)
    }),
    key("type", "`type P = [f64; 3]`", &[H, C, F, L, E], |to, _, input| {
        Rc::make_mut(&mut to.outside).parse_alias(input)
    }),
    key("with", "`with(function)`", &[H, C, F, L, E], |to, _, input| {
        values::functions(input).map(|with| to.with = with)
    }),
    key("crate", "`crate = path`", &[H, C, F, L, E], |to, _, input| set(&mut to.runtime, input)),
    key("require", "`require(separable, quadratic_kinetic, conservative)`", &[H], |to, _, input| {
        Requirement::list(Form::Hamiltonian, &mut to.requirements, input)
    }),
    key(
        "require",
        "`require(separable, quadratic_kinetic, conservative, quadratic, constant_mass, regular)`",
        &[L],
        |to, _, input| Requirement::list(Form::Lagrangian, &mut to.requirements, input),
    ),
];

/// Arguments of other attributes, with the advice for this attribute.
const ELSEWHERE: [(&str, Form, &str); 6] = [
    ("damping", Form::Contact, "a contact system is damped by the terms in `s` of its energy, such as `+ gamma * s`"),
    (
        "damping",
        Form::Lagrangian,
        "a Lagrangian is damped by Rayleigh's function of the velocities: `rayleigh = c * v * v / 2.0`",
    ),
    ("rolling", Form::Contact, ROLLING_WITH_ACTION),
    ("measure", Form::Hamiltonian, MEASURE_OF_ENERGY),
    ("measure", Form::Lagrangian, MEASURE_OF_ENERGY),
    ("structure", Form::Field, "x' = S(x) ∇H follows from an energy: put H under `#[hamiltonian(structure = …)]`"),
];

const MEASURE_OF_ENERGY: &str = "a density belongs to a field x' = f(x): write f under `#[vector_field(measure = …)]`, or p·f under \
                                 `#[contact_hamiltonian(lift, measure = …)]`";

const fn key(name: &'static str, written: &'static str, attributes: &'static [Option<Form>], read: Reader) -> Key {
    Key { name, written, attributes, read }
}

/// Parses `= value`.
fn value<T: Parse>(input: ParseStream<'_>) -> syn::Result<T> {
    input.parse::<Token![=]>()?;
    input.parse()
}

fn set<T: Parse>(place: &mut Option<T>, input: ParseStream<'_>) -> syn::Result<()> {
    *place = Some(value(input)?);
    Ok(())
}

fn role(to: &mut Options, role: Role, input: ParseStream<'_>) -> syn::Result<()> {
    to.roles.push((role, value(input)?));
    Ok(())
}
