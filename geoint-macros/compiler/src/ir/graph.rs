//! The graph: interned nodes that are simplified while they are built.
//!
//! Equal expressions are one node, so equality is a comparison of numbers, and shared terms are differentiated and emitted once. Constructors fold
//! constants, zeros, ones and signs, and merge equal terms and powers. They never expand a product, because the user's factored form is numerically
//! meaningful.

use super::hash;
use super::hash_index::HashIndex;
use super::id::Id;
use super::node::Node;
use super::number::Number;
use super::op::{Domain, Function};
use super::reads::{Reads, Symbols};
use super::sign::{Sign, sign};
use super::symbol::Symbol;
use super::table::Table;
use std::cell::{Cell, RefCell, RefMut};

/// A partial node: its value does not exist for all values of its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct UndefinedAt {
    pub(crate) node: Id,
    /// The condition under which the node is computed, if any.
    pub(crate) condition: Option<Id>,
}

/// Interned expressions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Graph {
    nodes: Vec<Node>,
    reads: Vec<Reads>,
    /// Cache of the symbols that nodes read, filled on demand.
    symbols: RefCell<Symbols>,
    /// Cache of the signs of nodes, filled on demand.
    signs: RefCell<Table<Sign>>,
    /// The nodes by their hashes.
    index: HashIndex,
    /// UndefinedAt nodes in the order of their construction, repeated if they are built again. Present while the graph records.
    partial: Option<Vec<Id>>,
    /// Scratch space of traversals: one bit for each node. Invariant: no bit is set between traversals.
    marked: RefCell<Vec<u64>>,
}

impl Graph {
    /// Returns a node.
    #[inline(always)]
    pub(crate) fn node(&self, id: Id) -> &Node {
        &self.nodes.as_slice()[id.index()]
    }

    /// Returns which kinds of coordinates a node reads.
    pub(crate) fn reads(&self, id: Id) -> Reads {
        self.reads.as_slice()[id.index()]
    }

    /// Returns the symbols that a node reads, in order.
    pub(crate) fn symbols(&self, id: Id) -> Vec<Symbol> {
        self.symbols_with(id).of(id).to_vec()
    }

    /// Returns whether a node reads a symbol that `counts`.
    pub(crate) fn reads_any(&self, id: Id, counts: impl Fn(Symbol) -> bool) -> bool {
        self.symbols_with(id).of(id).iter().any(|symbol| counts(*symbol))
    }

    /// Fills the cache of symbols for a node and returns the cache.
    fn symbols_with(&self, id: Id) -> RefMut<'_, Symbols> {
        let mut symbols = self.symbols.borrow_mut();
        for id in self.unknown(id, &symbols.of) {
            symbols.insert(id, self.node(id));
        }
        symbols
    }

    /// Returns the sign of a node that its form implies for all values of its symbols.
    pub(crate) fn sign(&self, id: Id) -> Sign {
        let mut signs = self.signs.borrow_mut();
        for id in self.unknown(id, &signs) {
            let sign = sign(self.node(id), &self.nodes, &signs);
            signs.insert(id, sign);
        }
        signs[id]
    }

    /// Returns whether the form of a node implies that it is positive.
    pub(crate) fn is_positive(&self, id: Id) -> bool {
        self.sign(id) == Sign::Positive
    }

    /// Returns the number of nodes.
    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Returns every node but the first `known`, operands first.
    pub(crate) fn ids_from(&self, known: usize) -> impl Iterator<Item = Id> + use<> {
        (known..self.nodes.len()).map(Id::from_index)
    }

    /// Returns the roots and all their direct and indirect operands, operands first.
    pub(crate) fn reachable(&self, roots: &[Id]) -> Vec<Id> {
        self.traverse(roots, |_| true)
    }

    /// Returns the root and its direct and indirect operands without a value in `known`, operands first. The traversal stops at known nodes.
    pub(crate) fn unknown<T: Copy>(&self, root: Id, known: &Table<T>) -> Vec<Id> {
        if known.contains(root) { vec![] } else { self.unknown_of(&[root], known) }
    }

    /// Returns the nodes without a value in `known` below several roots, operands first. The traversal stops at known nodes.
    pub(super) fn unknown_of<T: Copy>(&self, roots: &[Id], known: &Table<T>) -> Vec<Id> {
        self.traverse(roots, |id| !known.contains(id))
    }

    /// Returns the roots and their direct and indirect operands, operands first. The traversal stops at nodes that are not `entered`.
    ///
    /// Operands have smaller numbers than their node, so the traversal visits marked nodes in descending order.
    fn traverse(&self, roots: &[Id], entered: impl Fn(Id) -> bool) -> Vec<Id> {
        let mut marked = self.marked.borrow_mut();
        let last = self.nodes.len() / 64;
        if marked.len() <= last {
            marked.resize(2 * last + 1, 0);
        }
        let (mut found, first) = (vec![], Cell::new(last));
        let mark = |id: Id, marked: &mut [u64]| {
            if entered(id) {
                let word = id.index() / 64;
                marked[word] |= 1 << (id.index() % 64);
                first.set(first.get().min(word));
            }
        };
        for root in roots {
            mark(*root, &mut marked);
        }
        let mut word = roots.iter().max().map_or(0, |root| root.index() / 64);
        loop {
            while marked[word] > 0 {
                let bit = marked[word].ilog2();
                marked[word] &= !(1 << bit);
                let id = Id::from_index(64 * word + bit as usize);
                found.push(id);
                self.node(id).for_each_child(|child| mark(child, &mut marked));
            }
            if word <= first.get() {
                break;
            }
            word -= 1;
        }
        found.reverse();
        found
    }

    /// Returns whether a node is undefined for some values of its operands.
    pub(crate) fn is_partial(&self, id: Id) -> bool {
        match self.node(id) {
            Node::Power(_, exponent) => !exponent.is_integer() || exponent.numerator < 0,
            Node::Call(Function::Tan, _) => true,
            Node::Call(function, _) => function.entry().domain != Domain::Everywhere,
            _ => false,
        }
    }

    /// Returns the node that equals `node`. Adds it if it is new.
    pub(super) fn intern(&mut self, node: Node) -> Id {
        let hash = hash::of_node(&node);
        let number = self.index.find(hash, |number| self.nodes.as_slice()[number] == node).unwrap_or_else(|| {
            let number = self.nodes.len();
            self.index.insert(hash, number);
            self.reads.push(Reads::of_node(&node, &self.reads));
            self.nodes.push(node);
            number
        });
        let id = Id::from_index(number);
        if self.partial.is_some() && self.is_partial(id) {
            self.partial.get_or_insert_default().push(id);
        }
        id
    }

    /// Returns the partial nodes that were built since the last call, and records on.
    pub(crate) fn take_partial(&mut self) -> Vec<Id> {
        self.partial.replace(vec![]).unwrap_or_default()
    }

    /// Ends the record of partial nodes.
    pub(crate) fn stop_recording(&mut self) {
        self.partial = None;
    }

    /// Builds a constant.
    pub(crate) fn number(&mut self, value: Number) -> Id {
        self.intern(Node::Number(value))
    }

    /// Builds an integer.
    pub(crate) fn integer(&mut self, value: i128) -> Id {
        self.number(Number::integer(value))
    }

    /// Builds the number 0.
    pub(crate) fn zero(&mut self) -> Id {
        self.integer(0)
    }

    /// Builds a symbol.
    pub(crate) fn symbol(&mut self, symbol: Symbol) -> Id {
        self.intern(Node::Symbol(symbol))
    }

    /// Returns the value of a node that is a constant.
    pub(crate) fn as_number(&self, id: Id) -> Option<Number> {
        match self.node(id) {
            Node::Number(value) => Some(*value),
            _ => None,
        }
    }

    /// Returns whether a node is the number 0.
    pub(crate) fn is_zero(&self, id: Id) -> bool {
        self.as_number(id).is_some_and(Number::is_zero)
    }
}
