//! Arguments and signature: who is q, p and t, who is a parameter, in which shape.

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
pub(crate) use names::IMPORTED;
pub(crate) use options::Options;
pub(crate) use outside::Outside;
pub(crate) use shape::{Leaf, Shape, over_scalar};
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

/// What kind of system an attribute makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    Hamiltonian,
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
    /// The name of the attribute.
    pub(crate) fn attribute(self) -> &'static str {
        match self {
            Form::Hamiltonian | Form::Structured | Form::Bodies => "hamiltonian",
            Form::Contact => "contact_hamiltonian",
            Form::Field => "vector_field",
            Form::Lagrangian | Form::Herglotz | Form::FirstOrder => "lagrangian",
        }
    }

    /// The form of an attribute, before its arguments are read.
    pub(crate) fn of_attribute(name: &str) -> Option<Form> {
        [Form::Hamiltonian, Form::Contact, Form::Field, Form::Lagrangian]
            .into_iter()
            .find(|form| form.attribute() == name)
    }

    /// Whether the state is x alone, without momenta.
    pub(crate) fn is_flow(self) -> bool {
        matches!(self, Form::Structured | Form::Field | Form::FirstOrder)
    }

    /// Whether the state has an action.
    pub(crate) fn has_action(self) -> bool {
        matches!(self, Form::Contact | Form::Herglotz)
    }
}

/// An annotated function, understood up to its body.
#[derive(Clone)]
pub(crate) struct Energy {
    pub(crate) form: Form,
    pub(crate) item: ItemFn,
    /// The generated struct.
    pub(crate) name: Ident,
    /// The runtime as emitted code names it.
    pub(crate) runtime: TokenStream,
    /// `f64` or `f32`.
    pub(crate) float: Ident,
    /// The shape and type of x, or that q and p share.
    pub(crate) coordinates: Argument,
    /// All arguments in the order of the signature.
    pub(crate) arguments: Vec<(Role, Argument)>,
    /// What else the attribute says.
    pub(crate) options: Options,
    /// The functions that it names, as far as they are there.
    pub(crate) functions: Vec<Function>,
}

/// What an argument of the function is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Position,
    Momentum,
    Velocity,
    Action,
    Time,
    Parameter,
    /// The attitude of rigid bodies.
    Attitude,
    /// Their angular momenta.
    AngularMomentum,
}

/// An argument with its name and type.
#[derive(Clone)]
pub(crate) struct Argument {
    pub(crate) name: Ident,
    pub(crate) ty: Type,
    pub(crate) shape: Shape,
    /// Lints and the like.
    pub(crate) attributes: Vec<Attribute>,
}

impl Energy {
    /// The same with the functions that it names, as far as they have been handed on.
    pub(crate) fn with_functions(self, used: &[TokenStream]) -> Result<Energy> {
        Ok(Energy { functions: function::functions(&self.options.with, used)?, ..self })
    }

    pub(crate) fn parameters(&self) -> impl Iterator<Item = &Argument> {
        self.arguments.iter().filter(|(role, _)| *role == Role::Parameter).map(|(_, argument)| argument)
    }

    /// How many rigid bodies there are.
    pub(crate) fn bodies(&self) -> u32 {
        let rows = self.degrees() / 4;
        if self.centres().is_some() { rows / 2 } else { rows }
    }

    /// The type of their centres of mass, if these move.
    pub(crate) fn centres(&self) -> Option<&Type> {
        let mut centres =
            self.arguments.iter().filter(|(role, _)| *role == Role::Position && self.form == Form::Bodies);
        centres.next().map(|(_, argument)| &argument.ty)
    }

    /// The number of degrees of freedom; of coordinates, where there are no momenta.
    pub(crate) fn degrees(&self) -> u32 {
        self.coordinates.shape.len() as u32
    }

    /// Expressions of the attribute in the language of the body.
    pub(crate) fn expressions(&self) -> impl Iterator<Item = &Expr> {
        let Options { damping, rayleigh, constraint, structure, keeps, .. } = &self.options;
        let structure = structure.iter().filter(|form| form.is_expression()).map(|form| &form.expr);
        let kept = keeps.iter().flat_map(|kept| [Some(&kept.value), kept.but.as_ref()].into_iter().flatten());
        damping.iter().chain(rayleigh).chain(constraint).chain(structure).chain(kept)
    }

    /// All scalars of an argument as symbols; parameters are numbered through.
    pub(crate) fn symbols(&self, role: Role, argument: &Argument) -> Vec<Symbol> {
        let before: usize =
            self.parameters().take_while(|other| other.name != argument.name).map(|other| other.shape.len()).sum();
        // A vector as a pure quaternion; those of centres of mass come behind attitudes.
        let pure = |i: usize| (4 * (i / 3) + i % 3) as u32;
        let attitudes = 4 * self.bodies();
        let symbol = |i: usize| match role {
            Role::Position if self.form == Form::Bodies => Symbol::Q(attitudes + pure(i)),
            Role::Momentum if self.form == Form::Bodies => Symbol::P(attitudes + pure(i)),
            Role::AngularMomentum => Symbol::P(pure(i)),
            Role::Position | Role::Attitude => Symbol::Q(i as u32),
            Role::Momentum => Symbol::P(i as u32),
            Role::Velocity => Symbol::V(i as u32),
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

/// Reads the attribute's arguments and the signature.
pub(crate) fn energy(form: Form, args: TokenStream, item: ItemFn) -> Result<Energy> {
    let options = (|input: ParseStream<'_>| Options::parse(Some(form), input)).parse2(args)?;
    let form = if options.structure.is_some() {
        Form::Structured
    } else if options.roles.iter().any(|(role, _)| *role == Role::Attitude) {
        Form::Bodies
    } else {
        form
    };
    let mut errors = Diagnostics::default();
    plain_function(form, &item, &options.outside, &mut errors);
    // What follows from a parameter of the signature is not a mistake of its own.
    let mut errors = errors.or(Diagnostics::default())?;
    let float = returned_float(form, &item, &options.outside, &mut errors);
    let arguments = arguments(form, &item, &options, &float, &mut errors);
    let coordinates = coordinates(form, &item, &options, &arguments, &mut errors);
    let herglotz = form == Form::Lagrangian && arguments.iter().any(|(role, _)| *role == Role::Action);
    let form = if herglotz { Form::Herglotz } else { form };
    if herglotz && options.constraint.is_some() {
        errors.at(&options.constraint, "with an action there are no constraints: leave out this, or the argument `s`");
    }
    if let (Form::Field, Some(x)) = (form, &coordinates) {
        returns_shape_of(x, &item, &options.outside, &float, &mut errors);
    }
    flow::names(&options.keeps, &mut errors);
    let name = options.name.clone().unwrap_or_else(|| camel_case(&item.sig.ident));
    if name == "R" {
        errors.at(&name, "`R` is the scalar of generated code; give the struct another name: `name = …`");
    }
    if is_taken(&name) {
        errors.at(&name, format!("`{name}` is a name of generated code; give the struct another one: `name = …`"));
    }
    let runtime = runtime::path_or(options.runtime.clone());
    if arguments.iter().all(|(role, _)| *role != Role::Parameter) && name == item.sig.ident {
        errors.at(&item.sig.ident, "the generated struct would have the name of the function; give it one: `name = …`");
    }
    match coordinates {
        Some(coordinates) => {
            errors.or(Energy { form, item, name, runtime, float, coordinates, arguments, options, functions: vec![] })
        }
        None => Err(errors),
    }
}
