//! Poles of the energy: places where it is infinite, such as q = 0 of 1/|q|.
//!
//! A step of a discrete gradient goes along a straight line in phase space. If the line crosses a pole, the step may succeed with a wrong result.
//! This file therefore collects the nodes that vanish at poles, and generated code checks for each step that none of them has a zero on its line.
//! `structure.rs` finds cheap proofs from the form of a node. Intervals enclose the other nodes.

mod structure;

use super::enclosable::enclosable;
use crate::ir::{Function, Graph, Id, Node, Relation, Sign, Symbol, UndefinedAt};
use std::collections::HashSet;
pub(crate) use structure::Quick;
use structure::{Zero, Zeros};

/// A pole: a place where the energy is infinite.
#[derive(Clone, Debug)]
pub(crate) struct Pole {
    /// The argument of the partial function: the divisor of a quotient, the argument of a logarithm.
    pub(crate) term: Id,
    /// The node that vanishes at the pole: the term, or a factor of it.
    pub(crate) vanishes: Id,
    /// The condition under which the term is computed, if any.
    condition: Option<Id>,
    /// The node to check: `vanishes` where the condition holds, and 1 elsewhere. It is written in a form that intervals enclose well.
    pub(crate) enclosable: Id,
    /// Whether divided differences are NaN if the term has different signs at both ends. They are numbers across a pole of 1/|q|.
    pub(crate) noticed: bool,
    /// How generated code proves from the form of the term that it has no zero on the line, without intervals.
    pub(crate) quick: Option<Quick>,
    /// Whether the values of parameters may exclude the pole.
    pub(crate) by_parameters: bool,
    /// Whether the term reads time, but no coordinate.
    pub(crate) of_time: bool,
    /// Whether this is the boundary of a domain, where the term must not be negative, and no pole.
    pub(crate) is_edge: bool,
    /// Whether the mass matrix of a Lagrangian is singular there, or the form Ω of a Lagrangian that is linear in velocities.
    pub(crate) of_mass: bool,
}

/// Collects the poles of nodes that are not defined everywhere. `divided` lists the nodes of which divided differences are taken.
///
/// A pole is left out if a step across it ends outside the domain of the energy, as for ln q. The term must be concave: a concave term that is
/// positive at both ends of a step is positive between them. Poles with equal vanishing nodes are joined. The result also contains the edges of
/// domains.
pub(crate) fn poles(graph: &mut Graph, divided: &[Id], partial: &[UndefinedAt]) -> Vec<Pole> {
    let denominators: Vec<Denominator> = partial.iter().flat_map(|at| denominators(graph, *at)).collect();
    let computed: HashSet<Id> = graph.reachable(divided).into_iter().collect();
    let terms: Vec<Id> = denominators.iter().map(|denominator| denominator.term).collect();
    let zeros = Zeros::new(graph, &terms);
    let mut found: Vec<Pole> = vec![];
    for Denominator { node, term, one_sided, condition } in denominators {
        for Zero { node: vanishes, quick } in zeros.of(graph, term) {
            let whole = vanishes == term && condition.is_none();
            if one_sided && whole && zeros.is_concave(graph, term) {
                continue;
            }
            // Divided differences read time at the middle of the step only.
            let noticed = whole
                && computed.contains(&node)
                && !graph.reads_any(term, |symbol| symbol == Symbol::Time)
                && quick.as_ref().is_some_and(|quick| quick.is_sign_of(term));
            let pole = Pole { condition, noticed, quick, ..Pole::new(term, vanishes) };
            match found.iter_mut().find(|known| known.vanishes == vanishes) {
                Some(known) => known.join(graph, &pole),
                None => found.push(pole),
            }
        }
    }
    let mut ends = vec![];
    for UndefinedAt { node, condition } in partial {
        ends.extend(edges(graph, *node).into_iter().map(|term| (term, *condition)));
    }
    let terms: Vec<Id> = ends.iter().map(|(term, _)| *term).collect();
    let zeros = Zeros::new(graph, &terms);
    for (term, condition) in ends {
        let known = found.iter().any(|pole| pole.vanishes == term && pole.condition.is_none());
        if !known && zeros.has_gap(graph, term) {
            found.push(Pole { condition, is_edge: true, ..Pole::new(term, term) });
        }
    }
    found.iter_mut().for_each(|pole| pole.complete(graph));
    found
}

/// Returns the nodes that must not be negative for a node to be defined. A straight line between two points of a domain may leave the domain.
fn edges(graph: &mut Graph, node: Id) -> Vec<Id> {
    match graph.node(node).clone() {
        Node::Power(base, exponent) if exponent.numerator > 0 && !exponent.is_integer() => vec![base],
        Node::Call(Function::Asin | Function::Acos, args) => {
            let one = graph.integer(1);
            vec![graph.add(one, args[0]), graph.sub(one, args[0])]
        }
        Node::Call(Function::Acosh, args) => {
            let one = graph.integer(1);
            vec![graph.sub(args[0], one)]
        }
        Node::Call(Function::Powf, args) => vec![args[0]],
        _ => vec![],
    }
}

impl Pole {
    fn new(term: Id, vanishes: Id) -> Pole {
        Pole {
            term,
            vanishes,
            condition: None,
            enclosable: vanishes,
            noticed: false,
            quick: None,
            by_parameters: false,
            of_time: false,
            is_edge: false,
            of_mass: false,
        }
    }

    /// Combines the condition and the vanishing node into `enclosable` and its proofs.
    fn complete(&mut self, graph: &mut Graph) {
        let one = graph.integer(1);
        if let Some(quick) = &mut self.quick {
            quick.build(graph);
        }
        let vanishes = self.condition.map_or(self.vanishes, |condition| graph.select(condition, self.vanishes, one));
        self.enclosable = enclosable(graph, vanishes);
        self.by_parameters = graph.reads_any(self.enclosable, |symbol| matches!(symbol, Symbol::Parameter(_)));
        let reads = |symbols: fn(Symbol) -> bool| graph.reads_any(self.enclosable, symbols);
        self.of_time = reads(|symbol| symbol == Symbol::Time) && !reads(|symbol| symbol.is_coordinate());
    }

    /// Merges another occurrence of the pole.
    fn join(&mut self, graph: &mut Graph, again: &Pole) {
        self.condition = match (self.condition, again.condition) {
            (Some(a), Some(b)) => Some(graph.or(a, b)),
            _ => None,
        };
        // One node that yields NaN suffices if it is always computed.
        self.noticed |= again.noticed;
    }
}

/// A term whose zeros are places where a node is infinite.
struct Denominator {
    node: Id,
    term: Id,
    /// Whether the node is defined on one side of the zero only.
    one_sided: bool,
    /// The condition under which the node is computed and infinite at the zero, if any.
    condition: Option<Id>,
}

/// Returns the terms that vanish where a node is infinite: the divisor, or the distances of the argument from the ends of the domain.
fn denominators(graph: &mut Graph, UndefinedAt { node, condition }: UndefinedAt) -> Vec<Denominator> {
    let one_sided = |term| Denominator { node, term, one_sided: true, condition };
    let two_sided = |term| Denominator { one_sided: false, ..one_sided(term) };
    match graph.node(node).clone() {
        Node::Power(base, exponent) if exponent.numerator < 0 => {
            vec![if exponent.is_integer() { two_sided(base) } else { one_sided(base) }]
        }
        Node::Call(Function::Ln | Function::Log2 | Function::Log10, args) => vec![one_sided(args[0])],
        Node::Call(Function::Ln1p, args) => {
            let one = graph.integer(1);
            vec![one_sided(graph.add(one, args[0]))]
        }
        Node::Call(Function::Atanh, args) => {
            let one = graph.integer(1);
            [graph.add(one, args[0]), graph.sub(one, args[0])].map(one_sided).into()
        }
        Node::Call(Function::Tan, args) => vec![two_sided(graph.call(Function::Cos, &args))],
        Node::Call(Function::Powf, args) => {
            let zero = graph.zero();
            let negative = graph.compare(Relation::Less, args[1], zero);
            match graph.as_truth(negative) {
                Some(false) => vec![],
                Some(true) => vec![one_sided(args[0])],
                None => {
                    let condition = condition.map_or(negative, |condition| graph.and(condition, negative));
                    vec![Denominator { condition: Some(condition), ..one_sided(args[0]) }]
                }
            }
        }
        _ => vec![],
    }
}

/// Returns whether a partial node is undefined on one side of a point of its domain: true for √x, false for √(x²).
pub(crate) fn has_edge(graph: &Graph, node: Id) -> bool {
    match graph.node(node) {
        Node::Power(base, exponent) => !exponent.is_integer() && graph.sign(*base) == Sign::Unknown,
        Node::Call(Function::Tan, _) => false,
        Node::Call(Function::Asin | Function::Acos | Function::Acosh | Function::Atanh | Function::Ln1p, _) => true,
        Node::Call(_, args) => graph.sign(args[0]) == Sign::Unknown,
        _ => false,
    }
}
