//! Parses the attribute's arguments and the signature. The result has the role, shape and type of every argument.

mod arguments;
mod coordinates;
mod function;
mod flow;
mod keys;
mod names;
mod options;
mod outside;
mod runtime;
mod shape;
mod signature;
mod values;

pub(crate) use flow::{Kept, StructureForm, StructureKind};
pub(crate) use function::{Function, Source, energy_function, function_options, plain_path};
#[cfg(test)]
pub(crate) use names::DECLARED;
pub(crate) use names::imported;
pub(crate) use options::Options;
pub(crate) use outside::{Outside, integer_operation};
pub(crate) use shape::{Leaf, Shape, over_scalar, vector_length};
pub(crate) use values::{Coordinates, Requirement};

use crate::diagnostics::{Diagnostics, Result};
use crate::ir::Symbol;
use arguments::arguments;
use coordinates::coordinates;
use names::{camel_case, is_taken};
use proc_macro2::{Ident, TokenStream, TokenTree};
use signature::{plain_function, returned_float, returns_shape_of};
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Expr, ItemFn, Type};

/// The kind of system that an attribute defines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// H(q, p, t).
    Hamiltonian,
    /// H(q, p, s, t) of a contact system.
    Contact,
    /// H(r, m, t) of rigid bodies: attitudes and angular momenta.
    Bodies,
    /// H(x, t) with a structure S: x' = S(x) ∇H.
    Structured,
    /// f(x, t): x' = f.
    Field,
    /// L(q, v, t): a system with the energy p·v − L.
    Lagrangian,
    /// L(q, v, s, t) with the action s among the arguments: a contact system.
    Herglotz,
    /// L(q, v, t) linear in v: Ω(q) q' = ∇H.
    FirstOrder,
}

impl Form {
    /// Returns the name of the attribute.
    pub(crate) fn attribute(self) -> &'static str {
        match self {
            Form::Hamiltonian | Form::Structured | Form::Bodies => "hamiltonian",
            Form::Contact => "contact_hamiltonian",
            Form::Field => "vector_field",
            Form::Lagrangian | Form::Herglotz | Form::FirstOrder => "lagrangian",
        }
    }

    /// Returns the form of an attribute before its arguments are read.
    pub(crate) fn of_attribute(name: &str) -> Option<Form> {
        [Form::Hamiltonian, Form::Contact, Form::Field, Form::Lagrangian]
            .into_iter()
            .find(|form| form.attribute() == name)
    }

    /// Returns whether the state is x, without momenta.
    pub(crate) fn is_flow(self) -> bool {
        matches!(self, Form::Structured | Form::Field | Form::FirstOrder)
    }

    /// Returns whether the state has an action.
    pub(crate) fn has_action(self) -> bool {
        matches!(self, Form::Contact | Form::Herglotz)
    }
}

/// An annotated function with a parsed signature. The stage [`lower`](crate::lower) reads its body.
#[derive(Clone)]
pub(crate) struct Energy {
    pub(crate) form: Form,
    pub(crate) item: ItemFn,
    /// Name of the generated struct.
    pub(crate) name: Ident,
    /// Path of the runtime in generated code.
    pub(crate) runtime: TokenStream,
    /// Type of all numbers, `f64` or `f32`.
    pub(crate) float: Ident,
    /// Shape and type of x, or of q and of p.
    pub(crate) coordinates: Argument,
    /// All arguments in the order of the signature.
    pub(crate) arguments: Vec<Argument>,
    /// Arguments of the attribute.
    pub(crate) options: Options,
    /// Definitions of the functions in `with(…)`. Empty until all of them have been passed on.
    pub(crate) functions: Vec<Function>,
}

/// The role of an argument of the function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Position,
    Momentum,
    Velocity,
    Action,
    Time,
    Parameter,
    /// Attitudes of rigid bodies.
    Attitude,
    /// Angular momenta of rigid bodies.
    AngularMomentum,
}

/// An argument of the function.
#[derive(Clone)]
pub(crate) struct Argument {
    pub(crate) role: Role,
    pub(crate) name: Ident,
    pub(crate) ty: Type,
    pub(crate) shape: Shape,
    /// Attributes of the argument, such as lints.
    pub(crate) attributes: Vec<Attribute>,
}

impl Energy {
    /// Adds the definitions of the functions in `with(…)`.
    pub(crate) fn with_functions(self, used: &[TokenStream]) -> Result<Energy> {
        Ok(Energy { functions: function::functions(&self.options.with, used)?, ..self })
    }

    /// Returns the first argument of a role.
    pub(crate) fn argument(&self, role: Role) -> Option<&Argument> {
        of_role(&self.arguments, role)
    }

    /// Returns the parameters of the system in the order of the signature.
    pub(crate) fn parameters(&self) -> impl Iterator<Item = &Argument> {
        self.arguments.iter().filter(|argument| argument.role == Role::Parameter)
    }

    /// Returns the number of rigid bodies.
    pub(crate) fn bodies(&self) -> u32 {
        let rows = self.degrees() / 4;
        if self.centres().is_some() { rows / 2 } else { rows }
    }

    /// Returns the type of the centres of mass of rigid bodies, if they move.
    pub(crate) fn centres(&self) -> Option<&Type> {
        self.argument(Role::Position).filter(|_| self.form == Form::Bodies).map(|centres| &centres.ty)
    }

    /// Returns the number of degrees of freedom, or of coordinates if there are no momenta.
    pub(crate) fn degrees(&self) -> u32 {
        self.coordinates.shape.len() as u32
    }

    /// Returns the expressions in the attribute's arguments that may read velocities ∂H/∂p.
    pub(crate) fn expressions_of_velocities(&self) -> impl Iterator<Item = &Expr> {
        self.options.force.iter().chain(&self.options.rolling)
    }

    /// Returns the other expressions in the attribute's arguments. They are written in the language of the body.
    pub(crate) fn expressions(&self) -> impl Iterator<Item = &Expr> {
        let Options { damping, rayleigh, constraint, structure, entropy, friction, keeps, measure, .. } = &self.options;
        let structure = structure.iter().filter(|form| form.is_expression()).map(|form| &form.expr);
        let kept = keeps.iter().flat_map(|kept| [Some(&kept.value), kept.but.as_ref()].into_iter().flatten());
        damping
            .iter()
            .chain(rayleigh)
            .chain(constraint)
            .chain(structure)
            .chain(entropy)
            .chain(friction)
            .chain(kept)
            .chain(measure)
    }

    /// Returns the scalars of an argument as symbols. Parameters are numbered consecutively.
    pub(crate) fn symbols(&self, argument: &Argument) -> Vec<Symbol> {
        let before = self.parameters().take_while(|other| other.name != argument.name);
        let before: usize = before.map(|other| other.shape.len()).sum();
        // A vector is a pure quaternion. Centres of mass follow the attitudes.
        let pure = |i: usize| (4 * (i / 3) + i % 3) as u32;
        let attitudes = 4 * self.bodies();
        let symbol = |i: usize| match argument.role {
            Role::Position if self.form == Form::Bodies => Symbol::Position(attitudes + pure(i)),
            Role::Momentum if self.form == Form::Bodies => Symbol::Momentum(attitudes + pure(i)),
            Role::AngularMomentum => Symbol::Momentum(pure(i)),
            Role::Position | Role::Attitude => Symbol::Position(i as u32),
            Role::Momentum => Symbol::Momentum(i as u32),
            Role::Velocity => Symbol::Velocity(i as u32),
            Role::Action => Symbol::Action,
            Role::Time => Symbol::Time,
            Role::Parameter => Symbol::Parameter((before + i) as u32),
        };
        (0..argument.shape.len()).map(symbol).collect()
    }
}

/// Returns the first argument of a role.
fn of_role(arguments: &[Argument], role: Role) -> Option<&Argument> {
    arguments.iter().find(|argument| argument.role == role)
}

/// Largest depth of nested groups. Parsers at this depth need a small part of rustc's stack.
const MAX_NESTING: usize = 256;

/// Refuses deeply nested tokens. Their parser would overflow the stack.
pub(crate) fn nesting(item: &TokenStream) -> Result<()> {
    let mut level: Vec<TokenStream> = vec![item.clone()];
    for _ in 0..MAX_NESTING {
        let group = |tree| match tree {
            TokenTree::Group(group) => Some(group.stream()),
            _ => None,
        };
        level = level.into_iter().flatten().filter_map(group).collect();
        if level.is_empty() {
            return Ok(());
        }
    }
    let place = level.into_iter().flatten().next();
    Err(syn::Error::new_spanned(place, "this is nested too deeply: give parts of it a name with `let`").into())
}

/// Parses the attribute's arguments and the signature.
pub(crate) fn energy(form: Form, args: TokenStream, item: ItemFn) -> Result<Energy> {
    let options = (|input: ParseStream<'_>| Options::parse(Some(form), input)).parse2(args)?;
    let form = if options.structure.is_some() {
        Form::Structured
    } else if options.named(Role::Attitude).is_some() {
        Form::Bodies
    } else {
        form
    };
    let mut errors = Diagnostics::default();
    plain_function(form, &item, &options.outside, &mut errors);
    // Further errors would follow from a wrong signature.
    let mut errors = errors.or(Diagnostics::default())?;
    let float = returned_float(form, &item, &options.outside, &mut errors);
    let arguments = arguments(form, &item, &options, &float, &mut errors);
    let coordinates = coordinates(form, &item, &options, &arguments, &mut errors);
    let herglotz = form == Form::Lagrangian && of_role(&arguments, Role::Action).is_some();
    let form = if herglotz { Form::Herglotz } else { form };
    if let (true, Some(rolling)) = (herglotz, &options.rolling) {
        errors.at(rolling, ROLLING_WITH_ACTION);
    }
    if let (Form::Field, Some(x)) = (form, &coordinates) {
        returns_shape_of(x, &item, &options.outside, &float, &mut errors);
    }
    if form == Form::Contact && options.lift.is_none() && options.measure.is_some() {
        errors.at(&options.measure, MEASURE_WITHOUT_LIFT);
    }
    flow::names(&options.keeps, &mut errors);
    let name = options.name.clone().unwrap_or_else(|| camel_case(&item.sig.ident));
    if name == "R" {
        errors.at(&name, "`R` is the scalar of generated code; give the struct another name: `name = …`");
    }
    if is_taken(&name) {
        errors.at(&name, format!("`{name}` is a name of generated code; give the struct another one: `name = …`"));
    }
    let runtime = options.runtime_path();
    if of_role(&arguments, Role::Parameter).is_none() && name == item.sig.ident {
        errors.at(&item.sig.ident, "the generated struct would have the name of the function; give it one: `name = …`");
    }
    match coordinates {
        Some(coordinates) => {
            errors.or(Energy { form, item, name, runtime, float, coordinates, arguments, options, functions: vec![] })
        }
        None => Err(errors),
    }
}

const ROLLING_WITH_ACTION: &str =
    "beside an action, constraints are functions of positions and time: leave out this, or the argument `s`";

const MEASURE_WITHOUT_LIFT: &str = "the density of H(q, p, s) is known, |H|^−(n+1), and `REPORT` names it: leave `measure` out; a density of the field q' = X(q) \
                                    stands beside `lift`, with H = p·X(q)";
