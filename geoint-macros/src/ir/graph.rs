//! The graph: interned nodes, simplified while they are built.
//!
//! Equal expressions are one node, so that "is it the same" is a comparison of numbers, shared terms are differentiated
//! once, and emitted once. Constructors fold constants, zeros, ones and signs, and merge equal terms and powers. They
//! never expand a product: how the user factored an expression is numerically meaningful.

use super::id::Id;
use super::known::{self, Known};
use super::number::Number;
use super::number::Ratio;
use super::op::{Domain, Function, Relation, Symbol};
use super::reads::{Reads, Symbols};
use super::sign::{Sign, sign};
use super::table::Table;
use std::cell::RefCell;

/// An expression in terms of smaller ones. A sum or product over an index that stays a loop would be one more kind of
/// node, with a graph of its own as its body.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
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
            Node::Linear(_, terms) => terms.iter().for_each(|(_, id)| visit(*id)),
            Node::Product(ids) | Node::Call(_, ids) => ids.iter().for_each(|id| visit(*id)),
            Node::Power(id, _) | Node::Not(id) => visit(*id),
            Node::Select(c, a, b) => [*c, *a, *b].into_iter().for_each(visit),
            Node::Compare(_, a, b) | Node::And(a, b) | Node::Or(a, b) => [*a, *b].into_iter().for_each(visit),
        }
    }

    pub(crate) fn children(&self) -> Vec<Id> {
        let mut children = vec![];
        self.for_each_child(|child| children.push(child));
        children
    }
}

/// A node that is not defined everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Partial {
    pub(crate) node: Id,
    /// The condition under which it is computed, if there is one.
    pub(crate) condition: Option<Id>,
}

/// Interned expressions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Graph {
    nodes: Vec<Node>,
    symbols: Symbols,
    signs: Vec<Sign>,
    known: Known,
    /// While a body is lowered, the nodes that were asked for and are not defined everywhere, known before or not.
    partial: Option<Vec<Id>>,
    /// Scratch space of traversals: the number of the traversal that saw a node last.
    seen: RefCell<(u32, Vec<u32>)>,
}

impl Graph {
    pub(crate) fn node(&self, id: Id) -> &Node {
        &self.nodes[id.index()]
    }

    /// What a node reads of phase space.
    pub(crate) fn reads(&self, id: Id) -> Reads {
        self.symbols.reads(id)
    }

    /// The symbols that a node reads, in order.
    pub(crate) fn symbols(&self, id: Id) -> Vec<Symbol> {
        self.symbols.of(id)
    }

    /// What is known of the sign of a node from its form, whatever its symbols are.
    pub(crate) fn sign(&self, id: Id) -> Sign {
        self.signs[id.index()]
    }

    /// Whether a node is positive by its form.
    pub(crate) fn is_positive(&self, id: Id) -> bool {
        self.sign(id) == Sign::Positive
    }

    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Every node, operands first.
    pub(crate) fn ids(&self) -> impl Iterator<Item = Id> + use<> {
        self.ids_from(0)
    }

    /// The same without the first ones.
    pub(crate) fn ids_from(&self, known: usize) -> impl Iterator<Item = Id> + use<> {
        (known..self.nodes.len()).map(Id::from_index)
    }

    /// Every node that the roots are built of, operands first.
    pub(crate) fn reachable(&self, roots: &[Id]) -> Vec<Id> {
        self.walk(roots.to_vec(), |_| true)
    }

    /// Every node that `root` is built of and that is not `known` yet, operands first. What known nodes are built of is
    /// not looked at.
    pub(crate) fn unknown<T: Copy>(&self, root: Id, known: &Table<T>) -> Vec<Id> {
        self.walk(vec![root], |id| !known.contains(id))
    }

    /// Every node that the `open` ones are built of, operands first. Where one is not to be `entered`, it and what it is
    /// built of are left out.
    fn walk(&self, mut open: Vec<Id>, entered: impl Fn(Id) -> bool) -> Vec<Id> {
        let mut scratch = self.seen.borrow_mut();
        let (traversal, seen) = &mut *scratch;
        *traversal += 1;
        seen.resize(self.nodes.len(), 0);
        let mut found = vec![];
        let (mut first, mut last) = (usize::MAX, 0);
        while let Some(id) = open.pop() {
            if seen[id.index()] != *traversal && entered(id) {
                seen[id.index()] = *traversal;
                (first, last) = (first.min(id.index()), last.max(id.index()));
                found.push(id);
                self.node(id).for_each_child(|child| open.push(child));
            }
        }
        // What a node is built of has smaller numbers. Where most in between are found, to look at all of them is cheaper than to sort.
        if last.saturating_sub(first) < 8 * found.len() {
            return (first..=last).filter(|i| seen[*i] == *traversal).map(Id::from_index).collect();
        }
        found.sort_unstable();
        found
    }

    /// Whether a node is not defined for some values of its operands.
    pub(crate) fn is_partial(&self, id: Id) -> bool {
        match self.node(id) {
            Node::Power(_, exponent) => !exponent.is_integer() || exponent.numerator < 0,
            Node::Call(Function::Tan, _) => true,
            Node::Call(function, _) => function.entry().domain != Domain::Everywhere,
            _ => false,
        }
    }

    pub(super) fn intern(&mut self, node: Node) -> Id {
        let hash = known::hash(&node);
        let id = self.known.find(hash, |id| *self.node(id) == node).unwrap_or_else(|| {
            let next = Id::from_index(self.nodes.len());
            self.known.insert(hash, next);
            self.symbols.push(&node);
            self.signs.push(sign(&node, &self.nodes, &self.signs));
            self.nodes.push(node);
            next
        });
        if self.partial.is_some() && self.is_partial(id) {
            self.partial.get_or_insert_default().push(id);
        }
        id
    }

    /// What of the nodes that were asked for since the last call is not defined everywhere.
    pub(crate) fn take_partial(&mut self) -> Vec<Id> {
        self.partial.replace(vec![]).unwrap_or_default()
    }

    /// Ends the record of such nodes.
    pub(crate) fn stop_recording(&mut self) {
        self.partial = None;
    }

    pub(crate) fn number(&mut self, value: Number) -> Id {
        self.intern(Node::Number(value))
    }

    pub(crate) fn integer(&mut self, value: i128) -> Id {
        self.number(Number::integer(value))
    }

    pub(crate) fn zero(&mut self) -> Id {
        self.integer(0)
    }

    pub(crate) fn symbol(&mut self, symbol: Symbol) -> Id {
        self.intern(Node::Symbol(symbol))
    }

    pub(crate) fn as_number(&self, id: Id) -> Option<Number> {
        match self.node(id) {
            Node::Number(value) => Some(*value),
            _ => None,
        }
    }

    pub(crate) fn is_zero(&self, id: Id) -> bool {
        self.as_number(id).is_some_and(Number::is_zero)
    }
}
