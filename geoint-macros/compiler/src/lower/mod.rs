//! Translates the body of a function to a graph. A partial evaluation of Rust in which numbers are nodes.
//!
//! Integers, ranges, loops, closures and arrays are evaluated during lowering. Arithmetic on numbers remains. Later stages see no syntax: the result
//! maps each node to the place of its first occurrence.

mod arithmetic;
mod arrays;
mod assign;
mod branch;
mod call;
mod constants;
mod expr;
mod flow;
mod iterator;
mod language;
mod loops;
mod method;
mod notes;
mod quaternion;
mod scope;
mod shared;
mod statement;
mod unseen;
mod value;

use crate::diagnostics::{Diagnostics, Result};
use crate::ir::{Graph, HashMap, Id, Symbol, UndefinedAt};
use crate::parse::{Argument, Energy, Form};
pub(crate) use arrays::VELOCITY;
pub(crate) use flow::{Entropy, Integral, Skew, canonical};
use loops::{Leaving, Loop};
use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use shared::Calls;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;
use std::rc::Rc;
use value::Scopes;
use value::{Callable, Value};

/// A body as a graph.
pub(crate) struct Lowered {
    pub(crate) graph: Graph,
    /// Places of the first occurrence of nodes.
    pub(crate) places: HashMap<Id, Place>,
    /// Paths of constants from outside of the function. Their symbols are `Parameter(n)` after the parameters of the function.
    pub(crate) constants: Vec<TokenStream>,
    pub(crate) terms: Terms,
}

/// The expressions of a function and of its attribute, as nodes.
#[derive(Debug)]
pub(crate) struct Terms {
    /// The energy, the Lagrangian, or the first entry of a vector field.
    pub(crate) energy: Id,
    /// All entries of a vector field.
    pub(crate) field: Vec<Id>,
    /// S of x' = S(x) ∇H.
    pub(crate) structure: Skew,
    /// S and M of x' = L ∇E + M ∇S.
    pub(crate) entropy: Option<Entropy>,
    /// First integrals in `keeps(…)`.
    pub(crate) keeps: Vec<Integral>,
    /// Density ρ of an invariant measure. Steps do not evaluate it.
    pub(crate) measure: Option<(Id, Place)>,
    /// Square matrix of damping.
    pub(crate) damping: Option<Vec<Vec<Id>>>,
    /// Force without a potential, one entry for each coordinate.
    pub(crate) force: Option<Vec<Id>>,
    /// ∂R/∂v of a Lagrangian whose friction is no damping. Set by the Legendre transformation.
    pub(crate) friction: Option<Vec<Id>>,
    /// Rayleigh's dissipation function R of a Lagrangian.
    pub(crate) rayleigh: Option<(Id, Place)>,
    /// Functions g of constraints g(q, t) = 0.
    pub(crate) constraints: Vec<(Id, Place)>,
    /// Functions r of constraints r(q, v, t) = 0.
    pub(crate) rolling: Vec<(Id, Place)>,
    /// Pieces in `split`.
    pub(crate) groups: Option<Vec<(Id, Place)>>,
    /// Nodes that are not defined everywhere, including simplified ones.
    pub(crate) partial: Vec<UndefinedAt>,
}

/// First and last token of a term.
pub(crate) type Place = (Span, Span);

/// Returns the place of a piece of syntax.
fn place(syntax: &impl ToTokens) -> Place {
    let mut tokens = syntax.to_token_stream().into_iter();
    let first = tokens.next().map_or_else(Span::call_site, |first| first.span());
    (first, tokens.last().map_or(first, |last| last.span()))
}

/// Largest number of nodes. rustc would need seconds for larger unrolled bodies.
const MAX_NODES: usize = 5_000;

/// Largest number of evaluations. The limit stops loops and calls without nodes.
const MAX_EVALUATIONS: usize = 500_000;

/// Largest depth of nested expressions. Their evaluation needs a fraction of rustc's stack.
const MAX_DEPTH: usize = 200;

/// Largest depth of nested operations, for terms that variables build step by step. Derivatives are deeper by a small factor.
const MAX_HEIGHT: u32 = 200;

/// Lowers the body of a function and the expressions of its attribute.
pub(crate) fn body(energy: &Energy) -> Result<Lowered> {
    let mut errors = Diagnostics::default();
    unseen::report(energy, &mut errors);
    errors.or(())?;
    let mut lowering = Lowering {
        scopes: Scopes::of_file(&energy.options.outside, &energy.functions),
        parameters: energy.parameters().map(|parameter| parameter.shape.len()).sum::<usize>() as u32,
        float: energy.float.to_string(),
        ..Lowering::default()
    };
    lowering.graph.take_partial();
    for argument in &energy.arguments {
        lowering.bind_argument(argument, &energy.symbols(argument));
    }
    let arguments = lowering.scopes.clone();
    let (block, shape, options) = (&energy.item.block, &energy.coordinates.shape, &energy.options);
    let value = lowering.block(block);
    let field = match energy.form {
        Form::Field => lowering.entries(block, value, shape),
        _ => vec![lowering.real(block, value)],
    };
    // Expressions of the attribute read the arguments of the function, not the variables of its body.
    lowering.scopes = arguments;
    let damping = options.damping.as_ref().map(|expr| lowering.coefficients("damping", expr, shape));
    let entropy = options.entropy.as_ref().zip(options.friction.as_ref());
    let entropy = entropy.map(|(value, friction)| lowering.entropy(value, friction, shape));
    let x: Vec<Id> = (0..energy.degrees()).map(|i| lowering.graph.symbol(Symbol::Position(i))).collect();
    let structure = options.structure.as_ref().map_or_else(Skew::none, |form| lowering.structure(form, &x, shape));
    let keeps = options.keeps.iter().map(|kept| lowering.integral(kept, shape)).collect();
    let groups = options.split.as_ref().map(|split| split.iter().map(|expr| lowering.number(expr)).collect());
    let rayleigh = options.rayleigh.as_ref().map(|expr| lowering.number(expr));
    let force = options.force.as_ref().map(|expr| lowering.force(expr, energy));
    let constraints = options.constraint.as_ref().map_or_else(Vec::new, |expr| lowering.constraints(expr));
    let rolling = options.rolling.as_ref().map_or_else(Vec::new, |expr| lowering.rolling(expr, energy));
    let partial = lowering.all_partial();
    // No step evaluates the density, so its domain is none of the system.
    let measure = options.measure.as_ref().map(|expr| lowering.number(expr));
    let Lowering { graph, errors, places, constants, .. } = lowering;
    let (energy, friction) = (field[0], None);
    let terms = Terms {
        energy,
        field,
        structure,
        entropy,
        keeps,
        measure,
        damping,
        force,
        friction,
        rayleigh,
        constraints,
        rolling,
        groups,
        partial,
    };
    errors.or(Lowered { graph, places, constants, terms })
}

/// State of the evaluation.
#[derive(Default)]
struct Lowering {
    graph: Graph,
    errors: Diagnostics,
    scopes: Scopes,
    places: HashMap<Id, Place>,
    constants: Vec<TokenStream>,
    /// Number of scalar parameters.
    parameters: u32,
    /// Number of evaluated expressions.
    evaluations: usize,
    /// Depth of nested expressions, including calls.
    depth: usize,
    /// Height of each node above the symbols.
    heights: Vec<u32>,
    /// Conditions of the branches around the current expression.
    conditions: Vec<Id>,
    /// Loops around the current expression.
    loops: Vec<Loop>,
    /// Set between a `break` or `continue` and its loop. Nothing is evaluated meanwhile.
    leaving: Option<Leaving>,
    /// Nodes that are not defined everywhere, with the conditions under which they are computed. `None` is no condition.
    partial: BTreeMap<Id, BTreeSet<Option<Id>>>,
    /// Number of notes about nodes that are not defined everywhere.
    noted_partial: usize,
    /// Closures and nested functions around the current expression.
    calls: Vec<Rc<Callable>>,
    /// Cache of inlined calls.
    inlined: Calls,
    /// Whether the limit of loops and calls has been reported. Nothing is evaluated afterwards.
    is_exhausted: bool,
    /// Type of all numbers, `f64` or `f32`.
    float: String,
}

impl Lowering {
    /// Reports an error. The returned value prevents further errors.
    fn refuse(&mut self, syntax: &impl ToTokens, message: impl Display) -> Value {
        self.errors.at(syntax, message);
        Value::Poison
    }

    /// Binds an argument of the function to its symbols.
    fn bind_argument(&mut self, argument: &Argument, symbols: &[Symbol]) {
        let ids: Vec<Id> = symbols.iter().map(|symbol| self.graph.symbol(*symbol)).collect();
        for id in &ids {
            self.places.entry(*id).or_insert((argument.name.span(), argument.name.span()));
        }
        self.scopes.bind(&argument.name, value::shaped(&argument.shape, &ids));
    }

    /// Evaluates an expression that is a number.
    fn number(&mut self, expr: &syn::Expr) -> (Id, Place) {
        let value = self.expr(expr);
        (self.real(expr, value), place(expr))
    }

    /// Returns a value as a number.
    fn real(&mut self, syntax: &impl ToTokens, value: Value) -> Id {
        match value {
            Value::Real(id) => id,
            Value::Opaque(path) => self.constant(path),
            Value::Poison => self.graph.zero(),
            other => {
                self.refuse(syntax, format!("expected a number of the type of the energy, found {}", other.kind()));
                self.graph.zero()
            }
        }
    }

    /// Returns the symbol of a constant from outside of the function.
    fn constant(&mut self, path: TokenStream) -> Id {
        let text = path.to_string();
        let known = self.constants.iter().position(|other| other.to_string() == text);
        let index = known.unwrap_or_else(|| {
            self.constants.push(path);
            self.constants.len() - 1
        });
        self.graph.symbol(Symbol::Parameter(self.parameters + index as u32))
    }
}
