//! Which symbols a node reads.

use super::hash;
use super::id::Id;
use super::known::Known;
use super::node::Node;
use super::op::Symbol;
use super::table::Table;

/// What a node reads of phase space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Reads {
    pub(crate) q: bool,
    pub(crate) p: bool,
    pub(crate) v: bool,
    pub(crate) s: bool,
    pub(crate) t: bool,
}

impl Reads {
    /// Whether a position, a momentum, a velocity or the action is read.
    pub(crate) fn state(self) -> bool {
        self.q || self.p || self.v || self.s
    }

    /// Whether the value changes along a motion.
    pub(crate) fn moves(self) -> bool {
        self.state() || self.t
    }

    /// What a node reads, from what operands do.
    pub(super) fn of_node(node: &Node, operands: &[Reads]) -> Reads {
        if let Node::Symbol(symbol) = node {
            return Reads::of(*symbol);
        }
        let mut reads = Reads::default();
        node.for_each_child(|child| reads = reads.or(operands[child.index()]));
        reads
    }

    /// What reading a symbol is.
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

    /// How many of q, p and s are read.
    pub(crate) fn kinds(self) -> usize {
        [self.q, self.p, self.s].into_iter().filter(|reads| *reads).count()
    }

    /// What one or the other reads.
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

/// The symbols that nodes read, of those of which it was asked: sets, of which there are few.
#[derive(Clone, Debug, Default)]
pub(super) struct Symbols {
    /// In the order in which they came.
    all: Vec<Symbol>,
    /// Symbols as bits, 64 a word, by their places among all.
    sets: Vec<Vec<u64>>,
    known: Known,
    /// The set of each node.
    pub(super) of: Table<u32>,
}

impl Symbols {
    /// What a node reads, in order.
    pub(super) fn of(&self, id: Id) -> Vec<Symbol> {
        let mut symbols = vec![];
        self.for_each(id, |symbol| symbols.push(symbol));
        symbols.sort();
        symbols
    }

    /// Whether a node reads a symbol that `counts`.
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

    /// Notes what a node reads, whose operands are known.
    pub(super) fn note(&mut self, id: Id, node: &Node) {
        let bits = match node {
            Node::Symbol(symbol) => self.alone(*symbol),
            node => self.union(node),
        };
        let hash = hash::of_words(&bits);
        let set = self.known.find(hash, |set| self.sets[set] == bits).unwrap_or_else(|| {
            self.known.insert(hash, self.sets.len());
            self.sets.push(bits);
            self.sets.len() - 1
        });
        self.of.insert(id, set as u32);
    }

    fn alone(&mut self, symbol: Symbol) -> Vec<u64> {
        let place = self.all.iter().position(|other| *other == symbol).unwrap_or(self.all.len());
        if place == self.all.len() {
            self.all.push(symbol);
        }
        let mut bits = vec![0; place / 64 + 1];
        bits[place / 64] = 1 << (place % 64);
        bits
    }

    fn union(&self, node: &Node) -> Vec<u64> {
        let mut bits: Vec<u64> = vec![];
        let mut last = None;
        node.for_each_child(|child| {
            let set = self.of[child];
            if last == Some(set) {
                return;
            }
            last = Some(set);
            let others = self.sets[set as usize].as_slice();
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
