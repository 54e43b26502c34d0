//! The function's body to the graph: a partial evaluation of Rust in which numbers are nodes.
//!
//! Integers, ranges, loops, closures and arrays are evaluated while lowering; what is left is arithmetic on numbers.
//! This is the last stage that sees syntax: it hands on a table from nodes to the places at which they were written.

mod arithmetic;
mod assign;
mod branch;
mod call;
mod constants;
mod constraint;
mod damping;
mod expr;
mod flow;
mod force;
mod iterator;
mod language;
mod loops;
mod method;
mod quaternion;
mod scope;
mod shared;
mod statement;
mod unseen;
mod value;

use crate::diagnostics::{Diagnostics, Result};
use crate::ir::HashMap;
use crate::ir::{Graph, Id, Node, Partial, Symbol};
use crate::parse::{Argument, Energy, Form};
pub(crate) use flow::{Integral, Skew, canonical};
pub(crate) use force::VELOCITY;
use loops::{Leaving, Loop};
use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use shared::Calls;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;
use std::rc::Rc;
use value::{Around, Callable, Scopes, Value};

/// A body as a graph.
pub(crate) struct Lowered {
    pub(crate) graph: Graph,
    /// The energy, or the Lagrangian; the first entry of a field.
    pub(crate) energy: Id,
    /// All entries of a field.
    pub(crate) field: Vec<Id>,
    /// S of x' = S(x) ∇H.
    pub(crate) structure: Skew,
    /// What a field is said to keep.
    pub(crate) keeps: Vec<Integral>,
    /// The square matrix of damping.
    pub(crate) damping: Option<Vec<Vec<Id>>>,
    /// A force beside the energy, an entry a coordinate.
    pub(crate) force: Option<Vec<Id>>,
    /// ∂R/∂v of friction that is no damping: what a Lagrangian has of it.
    pub(crate) friction: Option<Vec<Id>>,
    /// Rayleigh's dissipation function of a Lagrangian, and where it is written.
    pub(crate) rayleigh: Option<(Id, Place)>,
    /// The functions that constraints keep at zero, and where they are written.
    pub(crate) constraints: Vec<(Id, Place)>,
    /// The pieces that the user wants, and where they are written.
    pub(crate) groups: Option<Vec<(Id, Place)>>,
    /// Where nodes were written first: the first and the last token.
    pub(crate) places: HashMap<Id, Place>,
    /// Nodes that are not defined everywhere, simplified away or not.
    pub(crate) partial: Vec<Partial>,
    /// Constants that live outside the function: symbols `Parameter(n)` after those of the parameters.
    pub(crate) constants: Vec<TokenStream>,
}

/// The first and the last token of a term.
pub(crate) type Place = (Span, Span);

/// The place of a piece of syntax.
fn place(syntax: &impl ToTokens) -> Place {
    let mut tokens = syntax.to_token_stream().into_iter();
    let first = tokens.next().map_or_else(Span::call_site, |first| first.span());
    (first, tokens.last().map_or(first, |last| last.span()))
}

/// Unrolled bodies beyond this size would take rustc seconds.
const MAX_NODES: usize = 5_000;

/// Evaluations, to stop loops and calls that do nothing but run.
const MAX_EVALUATIONS: usize = 500_000;

/// Expressions inside expressions, within a fraction of the stack of rustc.
const MAX_DEPTH: usize = 200;

/// Operations inside operations: the same, for what is built of variables step by step. Derivatives are deeper by a small factor.
const MAX_HEIGHT: u32 = 200;

/// Lowers the body of an energy, and its damping.
pub(crate) fn body(energy: &Energy) -> Result<Lowered> {
    let mut unseen = Diagnostics::default();
    unseen::report(energy, &mut unseen);
    unseen.or(())?;
    let mut lowering = Lowering {
        graph: Graph::default(),
        errors: Diagnostics::default(),
        scopes: Scopes::of_file(&energy.options.outside, &energy.functions),
        places: HashMap::default(),
        constants: vec![],
        parameters: energy.parameters().map(|parameter| parameter.shape.len()).sum::<usize>() as u32,
        evaluations: 0,
        depth: 0,
        heights: vec![],
        conditions: vec![],
        loops: vec![],
        leaving: None,
        partial: BTreeMap::new(),
        calls: vec![],
        noted_partial: 0,
        inlined: Calls::default(),
        is_exhausted: false,
        float: energy.float.to_string(),
    };
    lowering.graph.take_partial();
    for argument in &energy.arguments {
        let symbols = energy.symbols(argument);
        let value = lowering.argument(argument, &symbols);
        lowering.scopes.bind(&argument.name, value);
    }
    let arguments = lowering.scopes.clone();
    let value = lowering.block(&energy.item.block);
    let (block, shape) = (&energy.item.block, &energy.coordinates.shape);
    let field = match energy.form {
        Form::Field => lowering.entries(block, value, shape),
        _ => vec![lowering.real(block, value)],
    };
    // Damping, pieces and whatever else an attribute says see the arguments as they were given.
    lowering.scopes = arguments;
    let damping = energy.options.damping.as_ref().map(|expr| lowering.damping(expr, shape));
    let x: Vec<Id> = (0..energy.degrees()).map(|i| lowering.graph.symbol(Symbol::Position(i))).collect();
    let structure =
        energy.options.structure.as_ref().map_or_else(Skew::none, |form| lowering.structure(form, &x, shape));
    let keeps = energy.options.keeps.iter().map(|kept| lowering.integral(kept, shape)).collect();
    let number = |lowering: &mut Lowering, expr: &syn::Expr| {
        let value = lowering.expr(expr);
        (lowering.real(expr, value), place(expr))
    };
    let groups =
        energy.options.split.as_ref().map(|split| split.iter().map(|expr| number(&mut lowering, expr)).collect());
    let rayleigh = energy.options.rayleigh.as_ref().map(|expr| number(&mut lowering, expr));
    let force = energy.options.force.as_ref().map(|expr| lowering.force(expr, energy));
    let constraints = energy.options.constraint.as_ref().map_or_else(Vec::new, |expr| lowering.constraints(expr));
    lowering.note_partial();
    let Lowering { mut graph, errors, places, partial, constants, .. } = lowering;
    graph.stop_recording();
    let partial = partial.into_iter().map(|(node, conditions)| {
        let all: Option<Vec<Id>> = conditions.into_iter().collect();
        Partial { node, condition: all.and_then(|all| all.into_iter().reduce(|a, b| graph.or(a, b))) }
    });
    let partial = partial.collect();
    errors.or(Lowered {
        graph,
        energy: field[0],
        field,
        structure,
        keeps,
        damping,
        rayleigh,
        friction: None,
        force,
        constraints,
        groups,
        places,
        partial,
        constants,
    })
}

/// The evaluator.
struct Lowering {
    graph: Graph,
    errors: Diagnostics,
    scopes: Scopes,
    places: HashMap<Id, Place>,
    constants: Vec<TokenStream>,
    /// The number of scalar parameters.
    parameters: u32,
    evaluations: usize,
    /// Expressions inside expressions, calls included.
    depth: usize,
    /// How deep each node is, of those that have been looked at.
    heights: Vec<u32>,
    /// Conditions of the branches around what is being evaluated.
    conditions: Vec<Id>,
    /// Loops around it.
    loops: Vec<Loop>,
    /// Set while nothing is reached.
    leaving: Option<Leaving>,
    /// Nodes that are not defined everywhere, with the conditions under which they are computed: `None` if there is none.
    partial: BTreeMap<Id, BTreeSet<Option<Id>>>,
    /// Closures and nested functions being evaluated.
    calls: Vec<Rc<Callable>>,
    /// How often nodes were noted that are not defined everywhere.
    noted_partial: usize,
    /// Values of calls that have been inlined.
    inlined: Calls,
    /// Whether it was reported that loops and calls are too many: nothing is evaluated from then on.
    is_exhausted: bool,
    /// The type of all numbers.
    float: String,
}

impl Lowering {
    /// Says what is wrong; the value that comes of it silences what would follow.
    fn refuse(&mut self, syntax: &impl ToTokens, message: impl Display) -> Value {
        self.errors.at(syntax, message);
        Value::Poison
    }

    /// An argument of the energy as a value.
    fn argument(&mut self, argument: &Argument, symbols: &[Symbol]) -> Value {
        let ids: Vec<Id> = symbols.iter().map(|symbol| self.graph.symbol(*symbol)).collect();
        for id in &ids {
            self.places.entry(*id).or_insert((argument.name.span(), argument.name.span()));
        }
        value::shaped(&argument.shape, &ids)
    }

    /// A value as a number.
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

    /// A constant that lives outside as a symbol.
    fn constant(&mut self, path: TokenStream) -> Id {
        let text = path.to_string();
        let known = self.constants.iter().position(|other| other.to_string() == text);
        let index = known.unwrap_or_else(|| {
            self.constants.push(path);
            self.constants.len() - 1
        });
        self.graph.symbol(Symbol::Parameter(self.parameters + index as u32))
    }

    /// Remembers where a node was written first; refuses constants like 1/0, which no derivative survives.
    fn written(&mut self, id: Id, syntax: &impl ToTokens, place: impl FnOnce() -> Place) -> Value {
        self.places.entry(id).or_insert_with(place);
        self.noted(syntax, Value::Real(id))
    }

    /// The same for a value that is not a number, but may be made of some.
    fn noted(&mut self, syntax: &impl ToTokens, value: Value) -> Value {
        let new: Vec<Id> = self.graph.ids_from(self.heights.len()).collect();
        for id in &new {
            let below = self.graph.node(*id).children().iter().map(|child| self.heights[child.index()]).max();
            self.heights.push(below.map_or(0, |height| height + 1));
        }
        if new.iter().any(|id| self.heights[id.index()] > MAX_HEIGHT) {
            return self
                .refuse(syntax, "this is nested too deeply: it depends on a value that depends on a value, and so on");
        }
        self.note_partial();
        if !new.iter().all(|id| self.is_finite(*id)) {
            return self.refuse(syntax, "this is not a finite number, whatever the state is");
        }
        value
    }

    /// Notes what has been computed and is not defined everywhere, with the conditions around it.
    fn note_partial(&mut self) {
        let nodes = self.graph.take_partial();
        if nodes.is_empty() {
            return;
        }
        self.noted_partial += nodes.len();
        let all = self.conditions.iter().copied().reduce(|a, b| self.graph.and(a, b));
        for node in nodes {
            self.partial.entry(node).or_default().insert(all);
        }
    }

    /// Enters the side of a branch in which a condition holds; returns what [`Self::leave_branch`] needs.
    fn enter_branch(&mut self, condition: Id) -> (usize, Around) {
        self.note_partial();
        self.conditions.push(condition);
        self.scopes.close(Around::Branch)
    }

    fn leave_branch(&mut self, before: (usize, Around)) {
        self.note_partial();
        self.conditions.pop();
        self.scopes.open(before);
    }

    /// Whether the constants that a node is made of are finite. (What is finite has become one number.)
    fn is_finite(&self, id: Id) -> bool {
        let number = |id: &Id| self.graph.as_number(*id).is_some();
        match self.graph.node(id) {
            Node::Number(x) => x.to_f64().is_finite(),
            Node::Linear(constant, terms) => {
                terms.iter().map(|(c, _)| c).chain([constant]).all(|c| c.to_f64().is_finite())
            }
            Node::Power(base, _) => !number(base),
            Node::Call(_, args) => !args.iter().all(number),
            _ => true,
        }
    }
}
