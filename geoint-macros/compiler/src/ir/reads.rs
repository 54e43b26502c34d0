//! The symbols that a node reads.

use super::hash;
use super::hash_index::HashIndex;
use super::id::Id;
use super::node::Node;
use super::symbol::Symbol;
use super::table::Table;

/// The kinds of coordinates that a node reads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Reads {
    pub(crate) q: bool,
    pub(crate) p: bool,
    pub(crate) v: bool,
    pub(crate) s: bool,
    pub(crate) t: bool,
}

impl Reads {
    /// Returns whether a position, a momentum, a velocity or the action is read.
    pub(crate) fn state(self) -> bool {
        self.q || self.p || self.v || self.s
    }

    /// Returns whether the value may change along a motion.
    pub(crate) fn moves(self) -> bool {
        self.state() || self.t
    }

    /// Derives the kinds that a node reads from those of all earlier nodes.
    pub(super) fn of_node(node: &Node, operands: &[Reads]) -> Reads {
        if let Node::Symbol(symbol) = node {
            return Reads::of(*symbol);
        }
        let mut reads = Reads::default();
        node.for_each_child(|child| reads = reads.or(operands[child.index()]));
        reads
    }

    /// Returns the kind of a symbol. Parameters have none.
    fn of(symbol: Symbol) -> Reads {
        let none = Reads::default();
        match symbol {
            Symbol::Position(_) | Symbol::PositionIncrement(_) => Reads { q: true, ..none },
            Symbol::Momentum(_) | Symbol::MomentumIncrement(_) => Reads { p: true, ..none },
            Symbol::Velocity(_) | Symbol::VelocityIncrement(_) => Reads { v: true, ..none },
            Symbol::Action | Symbol::ActionIncrement => Reads { s: true, ..none },
            Symbol::Time | Symbol::StepStart | Symbol::StepEnd => Reads { t: true, ..none },
            Symbol::Parameter(_) | Symbol::Multiplier(_) | Symbol::StepLength | Symbol::GradientWeight => none,
        }
    }

    /// Returns how many of q, p and s are read.
    pub(crate) fn kinds(self) -> usize {
        [self.q, self.p, self.s].into_iter().filter(|reads| *reads).count()
    }

    /// Returns the union of both sets of kinds.
    pub(crate) fn or(self, other: Reads) -> Reads {
        Reads {
            q: self.q || other.q,
            p: self.p || other.p,
            v: self.v || other.v,
            s: self.s || other.s,
            t: self.t || other.t,
        }
    }
}

/// Cache of the symbols that nodes read. Many nodes read the same symbols, so equal sets are stored once.
#[derive(Clone, Debug, Default)]
pub(super) struct Symbols {
    /// All symbols in the order of their first occurrence.
    all: Vec<Symbol>,
    /// Sets of symbols. Bit i of the concatenated words stands for symbol i of `all`.
    sets: Vec<Vec<u64>>,
    /// The sets by their hashes.
    index: HashIndex,
    /// The place of each node's set.
    pub(super) of: Table<u32>,
}

impl Symbols {
    /// Returns the symbols that a node reads, in order.
    pub(super) fn of(&self, id: Id) -> Vec<Symbol> {
        let mut symbols = vec![];
        self.for_each(id, |symbol| symbols.push(symbol));
        symbols.sort();
        symbols
    }

    /// Returns whether a node reads a symbol that `counts`.
    pub(super) fn any(&self, id: Id, counts: impl Fn(Symbol) -> bool) -> bool {
        let mut any = false;
        self.for_each(id, |symbol| any = any || counts(symbol));
        any
    }

    fn for_each(&self, id: Id, mut visit: impl FnMut(Symbol)) {
        let mut first = 0;
        for word in &self.sets[self.of[id] as usize] {
            let mut bits = *word;
            while bits > 0 {
                visit(self.all[first + bits.trailing_zeros() as usize]);
                bits &= bits - 1;
            }
            first += 64;
        }
    }

    /// Adds the set of a node. Precondition: the sets of its operands are present.
    pub(super) fn insert(&mut self, id: Id, node: &Node) {
        let bits = match node {
            Node::Symbol(symbol) => self.singleton(*symbol),
            node => self.union_of_operands(node),
        };
        let hash = hash::of_words(&bits);
        let set = self.index.find(hash, |set| self.sets[set] == bits).unwrap_or_else(|| {
            self.index.insert(hash, self.sets.len());
            self.sets.push(bits);
            self.sets.len() - 1
        });
        self.of.insert(id, set as u32);
    }

    fn singleton(&mut self, symbol: Symbol) -> Vec<u64> {
        let place = self.all.iter().position(|other| *other == symbol).unwrap_or(self.all.len());
        if place == self.all.len() {
            self.all.push(symbol);
        }
        let mut bits = vec![0; place / 64 + 1];
        bits[place / 64] = 1 << (place % 64);
        bits
    }

    fn union_of_operands(&self, node: &Node) -> Vec<u64> {
        let mut bits: Vec<u64> = vec![];
        node.for_each_child(|child| {
            let others = self.sets[self.of[child] as usize].as_slice();
            if bits.len() < others.len() {
                bits.resize(others.len(), 0);
            }
            for (word, other) in bits.iter_mut().zip(others) {
                *word |= other;
            }
        });
        bits
    }
}
