//! Where the energy is infinite, and what changes its sign there: a step from one side to the other has jumped.
//!
//! Only both ends of a step are compared. Two poles in one step go unnoticed.

use super::dependence::symbols;
use crate::ir::{Function, Graph, Id, Node, Symbol};

/// A place where the energy is infinite.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pole {
    /// What is divided by, or of which the logarithm is taken.
    pub(crate) term: Id,
    /// What changes its sign there.
    pub(crate) vanishes: Id,
    /// Whether the term has the same sign on both sides, as |q| has: divided differences of it notice nothing.
    pub(crate) hidden: bool,
}

/// The poles of some nodes. Left out are those which a step cannot cross without leaving the domain of the energy, as ln q.
pub(crate) fn poles(graph: &mut Graph, nodes: &[Id]) -> Vec<Pole> {
    let mut found: Vec<Pole> = vec![];
    for id in nodes {
        // The term, and whether the energy is defined on one side of its zero alone.
        let (term, one_sided) = match graph.node(*id).clone() {
            Node::Power(base, exponent) if exponent.numerator < 0 => (base, !exponent.is_integer()),
            Node::Call(Function::Ln | Function::Log2 | Function::Log10, args) => (args[0], true),
            Node::Call(Function::Powf, args) if graph.as_number(args[1]).is_some_and(|r| r.is_negative()) => {
                (args[0], true)
            }
            Node::Call(Function::Tan, args) => (graph.call(Function::Cos, &args), false),
            _ => continue,
        };
        for vanishes in zeros(graph, term) {
            let hidden = vanishes != term;
            let moves = symbols(graph, vanishes).iter().any(|symbol| symbol.is_coordinate() || *symbol == Symbol::T);
            if (hidden || !one_sided) && moves && found.iter().all(|pole| pole.vanishes != vanishes) {
                found.push(Pole { term, vanishes, hidden });
            }
        }
    }
    found
}

/// What changes its sign where a node vanishes; nothing if that is known to be nowhere, or to have no two sides.
fn zeros(graph: &Graph, id: Id) -> Vec<Id> {
    match graph.node(id) {
        Node::Product(factors) => factors.iter().flat_map(|factor| zeros(graph, *factor)).collect(),
        Node::Power(base, exponent) if exponent.numerator > 0 => zeros(graph, *base),
        Node::Call(Function::Abs | Function::Cbrt, args) => zeros(graph, args[0]),
        _ if is_positive(graph, id) => vec![],
        _ => vec![id],
    }
}

/// Whether a node is never negative, from its form, if parameters are not: masses and lengths. Were one negative, a pole of the midpoint
/// rule would go unnoticed; a test of every m₁ + m₂ sin² would cost a sine a step.
fn is_positive(graph: &Graph, id: Id) -> bool {
    match graph.node(id) {
        Node::Number(value) => !value.is_negative(),
        Node::Symbol(Symbol::Parameter(_)) => true,
        Node::Linear(constant, terms) => {
            !constant.is_negative() && terms.iter().all(|(c, term)| !c.is_negative() && is_positive(graph, *term))
        }
        Node::Product(factors) => factors.iter().all(|factor| is_positive(graph, *factor)),
        Node::Power(base, exponent) => {
            !exponent.is_integer() || exponent.numerator % 2 == 0 || is_positive(graph, *base)
        }
        Node::Call(Function::Exp | Function::Exp2 | Function::Cosh | Function::Abs | Function::Hypot, _) => true,
        _ => false,
    }
}
