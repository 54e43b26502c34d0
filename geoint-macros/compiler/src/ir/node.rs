//! What an expression is: an operation, and its operands by their places in the graph.

use super::id::Id;
use super::number::{Number, Ratio};
use super::op::{Function, Relation, Symbol};

/// An expression in terms of smaller ones. A sum or product over an index that stays a loop would be one more kind of
/// node, with a graph of its own as its body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Node {
    Number(Number),
    Symbol(Symbol),
    /// constant + Σ coefficient·term, terms in order of their ids; scaling and negation too.
    Linear(Number, Vec<(Number, Id)>),
    /// Π factors, at least two, in order of their ids; no numbers among them.
    Product(Vec<Id>),
    /// A base to an exponent that is an integer or half of one.
    Power(Id, Ratio),
    Call(Function, Vec<Id>),
    /// `if condition { first } else { second }`.
    Select(Id, Id, Id),
    /// Conditions.
    Compare(Relation, Id, Id),
    And(Id, Id),
    Or(Id, Id),
    Not(Id),
    Truth(bool),
}

impl Node {
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
            Node::Select(condition, first, second) => {
                visit(*condition);
                visit(*first);
                visit(*second);
            }
            Node::Compare(_, a, b) | Node::And(a, b) | Node::Or(a, b) => {
                visit(*a);
                visit(*b);
            }
        }
    }

    pub(crate) fn children(&self) -> Vec<Id> {
        let mut children = vec![];
        self.for_each_child(|child| children.push(child));
        children
    }

    /// Whether the value is true or false in place of a number.
    pub(crate) fn is_condition(&self) -> bool {
        matches!(self, Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_) | Node::Truth(_))
    }
}
