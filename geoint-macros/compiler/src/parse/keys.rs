//! The arguments that attributes take: how each is written, which attributes take it, and how it is read.

use super::flow::{self, StructureForm};
use super::options::Options;
use super::values::{self, Coordinates, OF_ENERGIES, OF_LAGRANGIANS, Requirement};
use super::{Form, Role};
use proc_macro2::Ident;
use std::rc::Rc;
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};

/// An argument of attributes.
struct Key {
    name: &'static str,
    /// How messages say that it is written; nothing, if another argument names it.
    written: &'static str,
    attributes: &'static [Option<Form>],
    read: fn(&mut Options, &Ident, ParseStream<'_>) -> syn::Result<()>,
}

impl Key {
    /// The argument of that name, if the attribute takes it.
    fn of(attribute: Option<Form>, name: &Ident) -> syn::Result<&'static Key> {
        let of_attribute = |key: &&Key| name == key.name && key.attributes.contains(&attribute);
        KEYS.iter().find(of_attribute).ok_or_else(|| {
            let elsewhere = ELSEWHERE.iter().find(|(other, form, _)| name == other && Some(*form) == attribute);
            let message = elsewhere.map_or_else(|| all(attribute), |(.., message)| (*message).into());
            syn::Error::new_spanned(name, message)
        })
    }

    /// What was read is no such argument: the message of the parser, with what it should have been. Where nothing stands behind the name the
    /// parser points at the whole attribute.
    fn as_written(&self, name: &Ident, bare: bool, error: syn::Error) -> syn::Error {
        let message = error.to_string();
        let is_of_the_parser = ["expected ", "unexpected "].iter().any(|begin| message.starts_with(begin));
        if self.written.is_empty() || !is_of_the_parser {
            return error;
        }
        let span = if bare || message.starts_with("unexpected end") { name.span() } else { error.span() };
        syn::Error::new(span, format!("{message}; this argument is written {}", self.written))
    }

    /// Whether an attribute may have it several times.
    fn is_repeatable(&self) -> bool {
        ["require", "const", "type"].contains(&self.name)
    }
}

impl Options {
    /// Those of the attribute of a form, or of `#[energy_function]`.
    pub(super) fn parse(attribute: Option<Form>, input: ParseStream<'_>) -> syn::Result<Self> {
        let mut options = Options::default();
        let mut given: Vec<Ident> = vec![];
        while !input.is_empty() {
            let name = input.call(Ident::parse_any)?;
            let key = Key::of(attribute, &name)?;
            if !key.is_repeatable() && given.contains(&name) {
                return Err(syn::Error::new_spanned(&name, format!("`{name}` is given twice")));
            }
            let bare = input.is_empty();
            (key.read)(&mut options, &name, input).map_err(|error| key.as_written(&name, bare, error))?;
            given.push(name);
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        options.consistent()
    }
}

/// All that an attribute takes, in words.
fn all(attribute: Option<Form>) -> String {
    let taken = KEYS.iter().filter(|key| key.attributes.contains(&attribute) && !key.written.is_empty());
    let taken: Vec<&str> = taken.map(|key| key.written).collect();
    let (last, others) = taken.split_last().expect("every attribute takes arguments");
    format!("the arguments of this attribute are {} and {last}", others.join(", "))
}

const H: Option<Form> = Some(Form::Hamiltonian);
const C: Option<Form> = Some(Form::Contact);
const F: Option<Form> = Some(Form::Field);
const L: Option<Form> = Some(Form::Lagrangian);
/// `#[energy_function]`.
const E: Option<Form> = None;

/// In the order of messages.
const KEYS: [Key; 25] = [
    key("name", "`name = Type`", &[H, C, F, L], |to, _, input| set(&mut to.name, input)),
    key("x", "`x = argument`", &[F], |to, _, input| role(to, Role::Position, input)),
    key("q", "`q = argument`", &[H, C, L], |to, _, input| role(to, Role::Position, input)),
    key("p", "`p = argument`", &[H, C], |to, _, input| role(to, Role::Momentum, input)),
    key("v", "`v = argument`", &[L], |to, _, input| role(to, Role::Velocity, input)),
    key("s", "`s = argument`", &[C, L], |to, _, input| role(to, Role::Action, input)),
    key("t", "`t = argument`", &[H, C, F, L], |to, _, input| role(to, Role::Time, input)),
    key("keeps", "`keeps(integral = …, but = […])`", &[F], |to, _, input| {
        to.keeps = flow::keeps(input)?;
        Ok(())
    }),
    key("damping", "`damping = coefficients`", &[H], |to, _, input| set(&mut to.damping, input)),
    key("rayleigh", "`rayleigh = R`", &[L], |to, _, input| set(&mut to.rayleigh, input)),
    key("force", "`force = F`", &[H, L], |to, _, input| set(&mut to.force, input)),
    key("constraint", "`constraint = [g]`", &[H, L], |to, _, input| {
        to.constraint = Some(values::constraint(value(input)?)?);
        Ok(())
    }),
    key("split", "`split = \"terms | terms\"`", &[H, C], |to, _, input| {
        input.parse::<Token![=]>()?;
        to.split = Some(values::pieces(input)?);
        Ok(())
    }),
    key("coordinates", "`coordinates = jacobi` or `heliocentric`", &[H, L], |to, _, input| {
        let name: Ident = value(input)?;
        to.coordinates = Some((Coordinates::named(&name)?, name.span()));
        Ok(())
    }),
    key("structure", "`structure = S` with `x = argument`", &[H], |to, _, input| {
        to.structure = Some(StructureForm::new(value(input)?));
        Ok(())
    }),
    key("x", "", &[H], |to, _, input| {
        role(to, Role::Position, input)?;
        to.all = to.roles.last().map(|(_, name)| name.clone());
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
        to.with = values::functions(input)?;
        Ok(())
    }),
    key("crate", "`crate = path`", &[H, C, F, L, E], |to, _, input| set(&mut to.runtime, input)),
    key("require", "`require(separable, quadratic_kinetic, conservative)`", &[H], |to, _, input| {
        Requirement::list(&OF_ENERGIES, &mut to.requirements, input)
    }),
    key(
        "require",
        "`require(separable, quadratic_kinetic, conservative, quadratic, constant_mass, regular)`",
        &[L],
        |to, _, input| Requirement::list(&OF_LAGRANGIANS, &mut to.requirements, input),
    ),
];

/// What belongs to another attribute, or is said otherwise there.
const ELSEWHERE: [(&str, Form, &str); 3] = [
    ("damping", Form::Contact, "a contact system is damped by the terms in `s` of its energy, such as `+ gamma * s`"),
    (
        "damping",
        Form::Lagrangian,
        "a Lagrangian is damped by Rayleigh's function of the velocities: `rayleigh = c * v * v / 2.0`",
    ),
    ("structure", Form::Field, "x' = S(x) ∇H follows from an energy: put H under `#[hamiltonian(structure = …)]`"),
];

const fn key(
    name: &'static str,
    written: &'static str,
    attributes: &'static [Option<Form>],
    read: fn(&mut Options, &Ident, ParseStream<'_>) -> syn::Result<()>,
) -> Key {
    Key { name, written, attributes, read }
}

/// What stands behind `=`.
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
