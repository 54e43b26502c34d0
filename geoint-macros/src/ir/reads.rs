//! Which symbols a node reads.

use super::graph::Node;
use super::id::Id;
use super::op::Symbol;

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

    /// What reading a symbol is.
    fn of(symbol: Symbol) -> Reads {
        let none = Reads::default();
        match symbol {
            Symbol::Q(_) | Symbol::Dq(_) => Reads { q: true, ..none },
            Symbol::P(_) | Symbol::Dp(_) => Reads { p: true, ..none },
            Symbol::V(_) | Symbol::Dv(_) => Reads { v: true, ..none },
            Symbol::S | Symbol::Ds => Reads { s: true, ..none },
            Symbol::T => Reads { t: true, ..none },
            Symbol::Parameter(_) | Symbol::Multiplier(_) | Symbol::H | Symbol::G => none,
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

/// The symbols that nodes read.
#[derive(Clone, Debug, Default)]
pub(super) struct Symbols {
    /// In the order in which they came.
    all: Vec<Symbol>,
    /// Of each node.
    read: Vec<Read>,
}

/// Symbols as bits, 64 a word, by their places among all; and what they are.
#[derive(Clone, Debug, Default)]
struct Read {
    bits: Vec<u64>,
    reads: Reads,
}

impl Symbols {
    /// What a node reads, in order.
    pub(super) fn of(&self, id: Id) -> Vec<Symbol> {
        let bits = &self.read[id.index()].bits;
        let mut symbols = vec![];
        for (place, symbol) in self.all.iter().enumerate().take(64 * bits.len()) {
            if bits[place / 64] >> (place % 64) & 1 == 1 {
                symbols.push(*symbol);
            }
        }
        symbols.sort();
        symbols
    }

    pub(super) fn reads(&self, id: Id) -> Reads {
        self.read[id.index()].reads
    }

    /// Notes what the next node reads.
    pub(super) fn push(&mut self, node: &Node) {
        let mut read = Read::default();
        match node {
            Node::Symbol(symbol) => {
                let place = self.all.iter().position(|other| other == symbol).unwrap_or(self.all.len());
                if place == self.all.len() {
                    self.all.push(*symbol);
                }
                read.bits.resize(place / 64 + 1, 0);
                read.bits[place / 64] = 1 << (place % 64);
                read.reads = Reads::of(*symbol);
            }
            node => node.for_each_child(|child| read.join(&self.read[child.index()])),
        }
        self.read.push(read);
    }
}

impl Read {
    fn join(&mut self, other: &Read) {
        if self.bits.len() < other.bits.len() {
            self.bits.resize(other.bits.len(), 0);
        }
        self.bits.iter_mut().zip(&other.bits).for_each(|(word, other)| *word |= other);
        self.reads = self.reads.or(other.reads);
    }
}
