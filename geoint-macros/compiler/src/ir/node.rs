//! One node of the graph: an operation and its operands.

use super::id::Id;
use super::number::{Number, Ratio};
use super::op::{Function, Relation};
use super::symbol::Symbol;

/// An expression in terms of smaller expressions. Loops are unrolled: a sum over an index would need a node with a graph as its body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Node {
    Number(Number),
    Symbol(Symbol),
    /// constant + Σ coefficient·term, terms in order of their ids. Scaling and negation are sums of one term.
    Linear(Number, Vec<(Number, Id)>),
    /// Π factors, at least two, in order of their ids. No factor is a number.
    Product(Vec<Id>),
    /// A base to an exponent, which is an integer or half of an integer.
    Power(Id, Ratio),
    Call(Function, Vec<Id>),
    /// `if condition { first } else { second }`.
    Select(Id, Id, Id),
    // Conditions.
    Compare(Relation, Id, Id),
    And(Id, Id),
    Or(Id, Id),
    Not(Id),
    Truth(bool),
}

impl Node {
    /// Visits the operands in order.
    pub(crate) fn for_each_child(&self, mut visit: impl FnMut(Id)) {
        match self {
            Node::Number(_) | Node::Symbol(_) | Node::Truth(_) => {}
            Node::Linear(_, terms) => {
                for (_, id) in terms {
                    visit(*id);
                }
            }
            Node::Product(ids) | Node::Call(_, ids) => {
                for id in ids {
                    visit(*id);
                }
            }
            Node::Power(id, _) | Node::Not(id) => visit(*id),
            Node::Select(condition, first, second) => [condition, first, second].into_iter().for_each(|id| visit(*id)),
            Node::Compare(_, a, b) | Node::And(a, b) | Node::Or(a, b) => [a, b].into_iter().for_each(|id| visit(*id)),
        }
    }

    /// Returns the operands in order.
    pub(crate) fn children(&self) -> Vec<Id> {
        let mut children = vec![];
        self.for_each_child(|child| children.push(child));
        children
    }

    /// Returns whether the value is true or false instead of a number.
    pub(crate) fn is_condition(&self) -> bool {
        matches!(self, Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_) | Node::Truth(_))
    }
}
