//! Where the energy is infinite: what vanishes there, and what its structure says of zeros on a straight line.

mod structure;

use super::enclosable::enclosable;
use crate::ir::{Function, Graph, Id, Node, Partial, Relation, Sign, Symbol};
use std::collections::HashSet;
pub(crate) use structure::Quick;
use structure::Zeros;

/// A place where the energy is infinite.
#[derive(Clone, Debug)]
pub(crate) struct Pole {
    /// What is divided by, or of which the logarithm is taken.
    pub(crate) term: Id,
    /// What vanishes there: the term, or a part of it.
    pub(crate) vanishes: Id,
    /// The condition under which it is computed, if there is one.
    condition: Option<Id>,
    /// What must not vanish: that, or 1 where the condition does not hold, in a form that intervals enclose well.
    pub(crate) enclosable: Id,
    /// Whether divided differences are not a number where it has different signs at both ends. They are numbers across a pole of |q|.
    pub(crate) noticed: bool,
    /// How its structure excludes zeros on a straight line.
    pub(crate) quick: Option<Quick>,
    /// Whether parameters alone may rule it out.
    pub(crate) by_parameters: bool,
    /// Whether it reads time, and nothing of the state.
    pub(crate) of_time: bool,
    /// Whether it is no pole but the edge of a domain: the term must not be negative.
    pub(crate) is_edge: bool,
    /// Whether the mass matrix of a Lagrangian, or the form Ω of one that is linear in velocities, is singular there.
    pub(crate) of_mass: bool,
}

/// The poles of nodes that are not defined everywhere; `divided` are those of which divided differences are taken. Left out are those which
/// a step cannot cross without ending outside the domain of the energy, as that of ln q.
pub(crate) fn poles(graph: &mut Graph, divided: &[Id], partial: &[Partial]) -> Vec<Pole> {
    let mut all = vec![];
    for Partial { node, condition } in partial {
        for Denominator { term, one_sided, only_if } in denominators(graph, *node) {
            let condition = [*condition, only_if].into_iter().flatten().reduce(|a, b| graph.and(a, b));
            all.push((*node, term, one_sided, condition));
        }
    }
    let computed: HashSet<Id> = graph.reachable(divided).into_iter().collect();
    let terms: Vec<Id> = all.iter().map(|(_, term, ..)| *term).collect();
    let zeros = Zeros::new(graph, &terms);
    let mut found: Vec<Pole> = vec![];
    let mut joined = vec![];
    for (node, term, one_sided, condition) in all {
        for (vanishes, quick) in zeros.of(graph, term) {
            let whole = vanishes == term && condition.is_none();
            if !(one_sided && whole && zeros.is_concave(graph, term)) {
                // Divided differences have one time: that of the middle of the step.
                let timed = graph.reads_any(term, |symbol| symbol == Symbol::T);
                let noticed = !timed
                    && whole
                    && computed.contains(&node)
                    && quick.as_ref().is_some_and(|quick| quick.is_sign_of(term));
                let pole = Pole { condition, noticed, quick, ..Pole::new(term, vanishes) };
                match found.iter().position(|known| known.vanishes == vanishes) {
                    Some(known) => joined.push((known, pole)),
                    None => found.push(pole),
                }
            }
        }
    }
    for (known, again) in joined {
        found[known].join(graph, &again);
    }
    let mut ends = vec![];
    for Partial { node, condition } in partial {
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

/// What must not be negative for a node to be defined. Between two points of a domain a straight line may leave it.
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

    /// Derives what the condition and what vanishes say together.
    fn complete(&mut self, graph: &mut Graph) {
        let one = graph.integer(1);
        if let Some(quick) = &mut self.quick {
            quick.build(graph);
        }
        let vanishes = self.condition.map_or(self.vanishes, |condition| graph.select(condition, self.vanishes, one));
        self.enclosable = enclosable(graph, vanishes);
        self.by_parameters = graph.reads_any(self.enclosable, |symbol| matches!(symbol, Symbol::Parameter(_)));
        let reads = |symbols: fn(Symbol) -> bool| graph.reads_any(self.enclosable, symbols);
        self.of_time = reads(|symbol| symbol == Symbol::T) && !reads(|symbol| symbol.is_coordinate());
    }

    /// The same pole, met again.
    fn join(&mut self, graph: &mut Graph, again: &Pole) {
        self.condition = match (self.condition, again.condition) {
            (Some(a), Some(b)) => Some(graph.or(a, b)),
            _ => None,
        };
        // One node that notices is enough, if it is computed always.
        self.noticed |= again.noticed;
    }
}

/// What a node divides by.
struct Denominator {
    term: Id,
    /// Whether the node is defined on one side of its zero alone.
    one_sided: bool,
    /// Whether the node is infinite there under a condition only.
    only_if: Option<Id>,
}

/// What vanishes, or is infinite, where a node is infinite.
fn denominators(graph: &mut Graph, node: Id) -> Vec<Denominator> {
    let of = |term, one_sided| vec![Denominator { term, one_sided, only_if: None }];
    match graph.node(node).clone() {
        Node::Power(base, exponent) if exponent.numerator < 0 => of(base, !exponent.is_integer()),
        Node::Call(Function::Ln | Function::Log2 | Function::Log10, args) => of(args[0], true),
        Node::Call(Function::Ln1p, args) => {
            let one = graph.integer(1);
            of(graph.add(one, args[0]), true)
        }
        Node::Call(Function::Atanh, args) => {
            let one = graph.integer(1);
            let ends = [graph.add(one, args[0]), graph.sub(one, args[0])];
            ends.map(|term| Denominator { term, one_sided: true, only_if: None }).into()
        }
        Node::Call(Function::Tan, args) => of(graph.call(Function::Cos, &args), false),
        Node::Call(Function::Powf, args) => {
            let zero = graph.zero();
            let negative = graph.compare(Relation::Less, args[1], zero);
            match graph.as_truth(negative) {
                Some(false) => vec![],
                truth => {
                    let only_if = if truth.is_none() { Some(negative) } else { None };
                    vec![Denominator { term: args[0], one_sided: true, only_if }]
                }
            }
        }
        _ => vec![],
    }
}

/// Whether a node is not defined on one side of a place at which it may be: a root of x, not of x².
pub(crate) fn has_edge(graph: &Graph, node: Id) -> bool {
    match graph.node(node) {
        Node::Power(base, exponent) => !exponent.is_integer() && graph.sign(*base) == Sign::Unknown,
        Node::Call(Function::Tan, _) => false,
        Node::Call(Function::Asin | Function::Acos | Function::Acosh | Function::Atanh | Function::Ln1p, _) => true,
        Node::Call(_, args) => graph.sign(args[0]) == Sign::Unknown,
        _ => false,
    }
}
