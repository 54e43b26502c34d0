//! The graph: interned nodes, simplified while they are built.
//!
//! Equal expressions are one node, so that "is it the same" is a comparison of numbers, shared terms are differentiated
//! once, and emitted once. Constructors fold constants, zeros, ones and signs, and merge equal terms and powers. They
//! never expand a product: how the user factored an expression is numerically meaningful.

use super::hash;
use super::id::Id;
use super::known::Known;
use super::node::Node;
use super::number::Number;
use super::op::{Domain, Function, Symbol};
use super::reads::{Reads, Symbols};
use super::sign::{Sign, sign};
use super::table::Table;
use std::cell::{RefCell, RefMut};

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
    reads: Vec<Reads>,
    symbols: RefCell<Symbols>,
    /// Of those of which it was asked.
    signs: RefCell<Table<Sign>>,
    known: Known,
    /// While a body is lowered, the nodes that were asked for and are not defined everywhere, known before or not.
    partial: Option<Vec<Id>>,
    /// Scratch space of traversals: a bit for each node, none of them set between traversals.
    seen: RefCell<Vec<u64>>,
}

impl Graph {
    #[inline(always)]
    pub(crate) fn node(&self, id: Id) -> &Node {
        &self.nodes.as_slice()[id.index()]
    }

    /// What a node reads of phase space.
    pub(crate) fn reads(&self, id: Id) -> Reads {
        self.reads.as_slice()[id.index()]
    }

    /// The symbols that a node reads, in order.
    pub(crate) fn symbols(&self, id: Id) -> Vec<Symbol> {
        self.noted(id).of(id)
    }

    /// Whether a node reads a symbol that `counts`.
    pub(crate) fn reads_any(&self, id: Id, counts: impl Fn(Symbol) -> bool) -> bool {
        self.noted(id).any(id, counts)
    }

    /// The sets of symbols, with that of a node.
    fn noted(&self, id: Id) -> RefMut<'_, Symbols> {
        let mut symbols = self.symbols.borrow_mut();
        for id in self.unknown(id, &symbols.of) {
            symbols.note(id, self.node(id));
        }
        symbols
    }

    /// What is known of the sign of a node from its form, whatever its symbols are.
    pub(crate) fn sign(&self, id: Id) -> Sign {
        let mut signs = self.signs.borrow_mut();
        for id in self.unknown(id, &signs) {
            let sign = sign(self.node(id), &self.nodes, &signs);
            signs.insert(id, sign);
        }
        signs[id]
    }

    /// Whether a node is positive by its form.
    pub(crate) fn is_positive(&self, id: Id) -> bool {
        self.sign(id) == Sign::Positive
    }

    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Every node but the first ones, operands first.
    pub(crate) fn ids_from(&self, known: usize) -> impl Iterator<Item = Id> + use<> {
        (known..self.nodes.len()).map(Id::from_index)
    }

    /// Every node that the roots are built of, operands first.
    pub(crate) fn reachable(&self, roots: &[Id]) -> Vec<Id> {
        self.walk(roots, |_| true)
    }

    /// Every node that `root` is built of and that is not `known` yet, operands first. What known nodes are built of is
    /// not looked at.
    pub(crate) fn unknown<T: Copy>(&self, root: Id, known: &Table<T>) -> Vec<Id> {
        if known.contains(root) { vec![] } else { self.unknown_of(&[root], known) }
    }

    /// The same of several roots.
    pub(super) fn unknown_of<T: Copy>(&self, roots: &[Id], known: &Table<T>) -> Vec<Id> {
        self.walk(roots, |id| !known.contains(id))
    }

    /// Every node that the roots are built of, operands first. Where one is not to be `entered`, it and what it is
    /// built of are left out.
    fn walk(&self, roots: &[Id], entered: impl Fn(Id) -> bool) -> Vec<Id> {
        let mut scratch = self.seen.borrow_mut();
        let words = self.nodes.len() / 64 + 1;
        if scratch.len() < words {
            *scratch = vec![0; 2 * words];
        }
        let seen = scratch.as_mut_slice();
        let mut found: Vec<Id> = vec![];
        let (mut first, mut last) = (words, 0);
        let mut enter = |id: Id, found: &mut Vec<Id>| {
            let (word, bit) = (id.index() / 64, 1 << (id.index() % 64));
            if seen[word] & bit == 0 && entered(id) {
                seen[word] |= bit;
                first = if word < first { word } else { first };
                last = if word > last { word } else { last };
                found.push(id);
            }
        };
        for root in roots {
            enter(*root, &mut found);
        }
        let mut open = 0;
        while open < found.len() {
            let id = found.as_slice()[open];
            self.node(id).for_each_child(|child| enter(child, &mut found));
            open += 1;
        }
        // What a node is built of has smaller numbers.
        found.clear();
        for word in first..=last {
            while seen[word] > 0 {
                found.push(Id::from_index(64 * word + seen[word].trailing_zeros() as usize));
                seen[word] &= seen[word] - 1;
            }
        }
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
        let hash = hash::of_node(&node);
        let id = match self.known.find(hash, |number| self.nodes.as_slice()[number] == node) {
            Some(number) => Id::from_index(number),
            None => {
                let number = self.nodes.len();
                self.known.insert(hash, number);
                self.reads.push(Reads::of_node(&node, &self.reads));
                self.nodes.push(node);
                Id::from_index(number)
            }
        };
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
