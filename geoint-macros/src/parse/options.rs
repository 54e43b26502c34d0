//! The arguments of the attribute.

use super::flow::{self, Kept, StructureForm};
use super::outside::Outside;
use super::{Form, Role};
use crate::messages::NO_CONSTRAINT;
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;

/// What the arguments say.
#[derive(Default)]
pub(super) struct Options {
    pub(super) name: Option<Ident>,
    pub(super) runtime: Option<syn::Path>,
    pub(super) roles: Vec<(Role, Ident)>,
    pub(super) requirements: Vec<(Requirement, Span)>,
    pub(super) damping: Option<syn::Expr>,
    pub(super) rayleigh: Option<syn::Expr>,
    pub(super) force: Option<syn::Expr>,
    pub(super) constraint: Option<syn::Expr>,
    pub(super) structure: Option<StructureForm>,
    pub(super) keeps: Vec<Kept>,
    pub(super) split: Option<Vec<syn::Expr>>,
    pub(super) coordinates: Option<(Coordinates, Span)>,
    pub(super) lift: Option<Span>,
    pub(super) outside: Outside,
    pub(super) with: Vec<syn::Path>,
}

const HAMILTONIAN: &str = "the arguments of this attribute are `name = Type`, `q = argument`, `p = argument`, `t = argument`, \
                           `damping = coefficients`, `force = F`, `constraint = [g]`, `split = \"A | B\"`, `coordinates = jacobi` or `heliocentric`, `structure = S` with `x = argument`, `attitude = argument` with `m = argument`, `const N = 3`, `type P = [f64; 3]`, `with(function)`, `crate = path` and \
                           `require(separable, quadratic_kinetic, conservative)`";

const CONTACT: &str = "the arguments of this attribute are `name = Type`, `q = argument`, `p = argument`, `s = argument`, \
                       `t = argument`, `split = \"terms | terms\"`, `lift`, `const N = 3`, `type P = [f64; 3]`, `with(function)` and `crate = path`";

const FIELD: &str = "the arguments of this attribute are `name = Type`, `x = argument`, `t = argument`, `keeps(integral = …, but = […])`, \
                     `const N = 3`, `type P = [f64; 3]`, `with(function)` and `crate = path`";

const LAGRANGIAN: &str = "the arguments of this attribute are `name = Type`, `q = argument`, `v = argument`, `s = argument`, `t = argument`, \
                          `rayleigh = R`, `force = F`, `constraint = [g]`, `const N = 3`, `type P = [f64; 3]`, `with(function)`, `crate = path` and \
                          `require(separable, quadratic_kinetic, conservative, quadratic, constant_mass, regular)`";

const FUNCTION: &str =
    "the arguments of this attribute are `const N = 3`, `type P = [f64; 3]`, `with(function)` and `crate = path`";

/// What may be given several times.
const REPEATABLE: [&str; 3] = ["require", "const", "type"];

impl Options {
    /// Those of the attribute of a form, or of `#[energy_function]`.
    pub(super) fn parse(form: Option<Form>, input: ParseStream<'_>) -> syn::Result<Self> {
        let mut options = Options::default();
        let mut given: Vec<Ident> = vec![];
        while !input.is_empty() {
            let key = input.call(Ident::parse_any)?;
            if !REPEATABLE.iter().any(|name| key == name) && given.contains(&key) {
                return Err(syn::Error::new_spanned(&key, format!("`{key}` is given twice")));
            }
            given.push(key.clone());
            let (system, contact, field) = (form.is_some(), form == Some(Form::Contact), form == Some(Form::Field));
            let lagrangian = form == Some(Form::Lagrangian);
            let energy = system && !field;
            match key.to_string().as_str() {
                "with" => options.with = super::function::with(input)?,
                "require" if energy && !contact => {
                    let inner;
                    syn::parenthesized!(inner in input);
                    for name in Punctuated::<Ident, Token![,]>::parse_terminated(&inner)? {
                        options.requirements.push((Requirement::named(&name, lagrangian)?, name.span()));
                    }
                }
                "const" => options.outside.parse_constant(input)?,
                "type" => options.outside.parse_alias(input)?,
                "crate" => {
                    input.parse::<Token![=]>()?;
                    options.runtime = Some(input.parse()?);
                }
                "damping" if contact => {
                    let message = "a contact system is damped by the terms in `s` of its energy, such as `+ gamma * s`";
                    return Err(syn::Error::new_spanned(key, message));
                }
                "coordinates" if energy && !contact => {
                    input.parse::<Token![=]>()?;
                    let name: Ident = input.parse()?;
                    let coordinates = Coordinates::named(&name)?;
                    options.coordinates = Some((coordinates, name.span()));
                }
                "split" if energy => {
                    input.parse::<Token![=]>()?;
                    if !input.peek(syn::LitStr) {
                        return Err(input.error("the pieces are given as a string: `split = \"terms | terms\"`"));
                    }
                    options.split = Some(groups(&input.parse()?)?);
                }
                "lift" if contact => options.lift = Some(key.span()),
                "damping" if lagrangian => {
                    let message =
                        "a Lagrangian is damped by Rayleigh's function of the velocities: `rayleigh = c * v * v / 2.0`";
                    return Err(syn::Error::new_spanned(key, message));
                }
                "rayleigh" if lagrangian => {
                    input.parse::<Token![=]>()?;
                    options.rayleigh = Some(input.parse()?);
                }
                "force" if energy && !contact => {
                    input.parse::<Token![=]>()?;
                    options.force = Some(input.parse()?);
                }
                "constraint" if energy && !contact => {
                    input.parse::<Token![=]>()?;
                    let constraints: syn::Expr = input.parse()?;
                    if matches!(&constraints, syn::Expr::Array(array) if array.elems.is_empty()) {
                        return Err(syn::Error::new_spanned(constraints, NO_CONSTRAINT));
                    }
                    options.constraint = Some(constraints);
                }
                "damping" if energy => {
                    input.parse::<Token![=]>()?;
                    options.damping = Some(input.parse()?);
                }
                "structure" if energy && !contact && !lagrangian => {
                    input.parse::<Token![=]>()?;
                    options.structure = Some(StructureForm::new(input.parse()?));
                }
                "structure" if field => {
                    let message = "x' = S(x) ∇H follows from an energy: put H under `#[hamiltonian(structure = …)]`";
                    return Err(syn::Error::new_spanned(key, message));
                }
                "keeps" if field => options.keeps = flow::keeps(input)?,
                name @ ("name" | "q" | "p" | "v" | "s" | "t" | "x" | "attitude" | "m")
                    if system && takes(form, name) =>
                {
                    input.parse::<Token![=]>()?;
                    let value: Ident = input.parse()?;
                    match name {
                        "name" => options.name = Some(value),
                        "q" | "x" => options.roles.push((Role::Position, value)),
                        "p" => options.roles.push((Role::Momentum, value)),
                        "v" => options.roles.push((Role::Velocity, value)),
                        "s" => options.roles.push((Role::Action, value)),
                        "attitude" => options.roles.push((Role::Attitude, value)),
                        "m" => options.roles.push((Role::AngularMomentum, value)),
                        _ => options.roles.push((Role::Time, value)),
                    }
                }
                _ => {
                    let message = match form {
                        Some(Form::Hamiltonian | Form::Structured | Form::Bodies) => HAMILTONIAN,
                        Some(Form::Contact) => CONTACT,
                        Some(Form::Field) => FIELD,
                        Some(Form::Lagrangian | Form::Herglotz | Form::FirstOrder) => LAGRANGIAN,
                        None => FUNCTION,
                    };
                    return Err(syn::Error::new_spanned(key, message));
                }
            }
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        options.consistent()
    }

    /// With a structure there are neither momenta nor a kinetic part. Rigid bodies have an attitude and angular momenta, and
    /// are not damped.
    fn consistent(self) -> syn::Result<Self> {
        let role = |role: Role| self.roles.iter().find(|(other, _)| *other == role).map(|(_, name)| name.span());
        let required = self.requirements.first().map(|(_, span)| *span);
        let damped = self.damping.as_ref().map(Spanned::span);
        let forced = self.force.as_ref().map(Spanned::span);
        let split = self.split.as_ref().and_then(|groups| groups.first()).map(Spanned::span);
        let parted = self.coordinates.map(|(_, span)| span).or(split);
        let constrained = self.constraint.as_ref().map(Spanned::span);
        if let Some(span) = constrained
            && (self.structure.is_some() || role(Role::Attitude).is_some() || parted.is_some() || forced.is_some())
        {
            return Err(syn::Error::new(span, CONSTRAINED));
        }
        let [attitude, m] = [Role::Attitude, Role::AngularMomentum].map(role);
        let wrong = match (&self.structure, attitude) {
            (Some(_), Some(attitude)) => Some((attitude, BODY_WITH_STRUCTURE)),
            (Some(_), None) => role(Role::Momentum).or(required).or(parted).or(forced).map(|span| (span, NO_MOMENTA)),
            (None, None) => {
                let both = self.coordinates.filter(|_| split.is_some()).map(|(_, span)| (span, TWO_WAYS));
                let damped = damped.or(forced).and(parted).map(|span| (span, DAMPED_PARTS));
                m.map(|m| (m, WITHOUT_ATTITUDE)).or(both).or(damped)
            }
            (None, Some(_)) => {
                let damped = damped.or(forced).map(|span| (span, DAMPED_BODY));
                let parted = parted.map(|span| (span, PARTS_OF_BODIES));
                damped.or(required.map(|span| (span, ALWAYS_SEPARABLE))).or(parted)
            }
        };
        wrong.map_or(Ok(()), |(span, message)| Err(syn::Error::new(span, message)))?;
        Ok(self)
    }
}

/// Whether an attribute has a name for the struct or for an argument.
fn takes(form: Option<Form>, name: &str) -> bool {
    match name {
        "q" => form != Some(Form::Field),
        "p" => !matches!(form, Some(Form::Field | Form::Lagrangian)),
        "v" => form == Some(Form::Lagrangian),
        "s" => matches!(form, Some(Form::Contact | Form::Lagrangian)),
        "x" => !matches!(form, Some(Form::Contact | Form::Lagrangian)),
        "attitude" | "m" => form == Some(Form::Hamiltonian),
        _ => true,
    }
}

const CONSTRAINED: &str = "constraints are for positions and momenta whose energy is not split: leave out this, or `structure`, `attitude`, \
                           `split`, `coordinates` and `force`";

const NO_MOMENTA: &str = "with `structure` there are no momenta: the state is `x` alone";

const BODY_WITH_STRUCTURE: &str =
    "with `attitude` the state is that of rigid bodies, whose structure is known: leave `structure` out";

const WITHOUT_ATTITUDE: &str =
    "`m = …` names the angular momentum of a rigid body: say which argument is its attitude, `attitude = …`";

const DAMPED_BODY: &str =
    "rigid bodies are moved by their energy alone: `damping` and `force` are for energies of `q` and `p`";

const ALWAYS_SEPARABLE: &str =
    "with `attitude` the energy has to be T(m) + V(r) with a quadratic T: leave `require` out";

const TWO_WAYS: &str = "`coordinates` says how the energy is split: leave `split` out";

const DAMPED_PARTS: &str = "damping, or a force, is no part of an exact flow or a kick: leave it out, or this";

const PARTS_OF_BODIES: &str = "with `attitude` the parts of the energy are known, T(m) and V(r): leave this out";

/// `"terms | terms"` as expressions.
fn groups(text: &syn::LitStr) -> syn::Result<Vec<syn::Expr>> {
    let parser = Punctuated::<Group, Token![|]>::parse_separated_nonempty;
    // What is missing has no place inside of the text.
    let groups = text.parse_with(parser).map_err(|error| syn::Error::new(text.span(), error))?;
    Ok(groups.into_iter().map(|Group(expr)| expr).collect())
}

/// An expression that ends before a `|`.
struct Group(syn::Expr);

impl Parse for Group {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut tokens = TokenStream::new();
        while !input.is_empty() && !input.peek(Token![|]) {
            tokens.extend([input.parse::<TokenTree>()?]);
        }
        if tokens.is_empty() {
            return Err(input.error("a piece without terms: write `split = \"terms | terms\"`"));
        }
        syn::parse2(tokens).map(Group)
    }
}

/// A property that the user asks the macro to prove.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Requirement {
    Separable,
    QuadraticKinetic,
    Conservative,
    /// L is quadratic in the velocities.
    Quadratic,
    /// ∂²L/∂v² is constant.
    ConstantMass,
    /// Velocities follow from momenta.
    Regular,
}

impl Requirement {
    fn named(name: &Ident, lagrangian: bool) -> syn::Result<Requirement> {
        match name.to_string().as_str() {
            "separable" => Ok(Requirement::Separable),
            "quadratic_kinetic" => Ok(Requirement::QuadraticKinetic),
            "conservative" => Ok(Requirement::Conservative),
            "quadratic" if lagrangian => Ok(Requirement::Quadratic),
            "constant_mass" if lagrangian => Ok(Requirement::ConstantMass),
            "regular" if lagrangian => Ok(Requirement::Regular),
            _ => {
                let message = match lagrangian {
                    true => {
                        "what can be required is `separable`, `quadratic_kinetic`, `conservative`, `quadratic`, `constant_mass` and `regular`"
                    }
                    false => "what can be required is `separable`, `quadratic_kinetic` and `conservative`",
                };
                Err(syn::Error::new_spanned(name, message))
            }
        }
    }

    /// Whether the Lagrangian decides it, and not its energy.
    pub(crate) fn is_of_lagrangian(self) -> bool {
        matches!(self, Requirement::Quadratic | Requirement::ConstantMass | Requirement::Regular)
    }
}

/// Coordinates in which methods move the bodies of an energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Coordinates {
    /// Each body as seen from the centre of mass of those before it.
    Jacobi,
    /// Each body as seen from body 0.
    Heliocentric,
}

impl Coordinates {
    fn named(name: &Ident) -> syn::Result<Coordinates> {
        match name.to_string().as_str() {
            "jacobi" => Ok(Coordinates::Jacobi),
            "heliocentric" => Ok(Coordinates::Heliocentric),
            _ => {
                let message =
                    "the coordinates of bodies that there are: `coordinates = jacobi`, `coordinates = heliocentric`";
                Err(syn::Error::new_spanned(name, message))
            }
        }
    }
}
