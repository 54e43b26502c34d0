//! Which symbols a node reads.

use super::graph::Node;
use super::hash;
use super::id::Id;
use super::known::Known;
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

/// The symbols that nodes read: sets, of which there are few.
#[derive(Clone, Debug, Default)]
pub(super) struct Symbols {
    /// In the order in which they came.
    all: Vec<Symbol>,
    sets: Vec<Set>,
    known: Known,
    /// The set of each node.
    of: Vec<u32>,
    /// Scratch space of unions.
    bits: Vec<u64>,
}

/// Symbols as bits, 64 a word, by their places among all; and what they are.
#[derive(Clone, Debug, Default)]
struct Set {
    bits: Vec<u64>,
    reads: Reads,
}

impl Symbols {
    /// What a node reads, in order.
    pub(super) fn of(&self, id: Id) -> Vec<Symbol> {
        let bits = &self.set(id).bits;
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
        self.set(id).reads
    }

    fn set(&self, id: Id) -> &Set {
        &self.sets.as_slice()[self.of.as_slice()[id.index()] as usize]
    }

    /// Notes what the next node reads.
    pub(super) fn push(&mut self, node: &Node) {
        let set = match node {
            Node::Symbol(symbol) => self.alone(*symbol),
            node => self.largest(node).unwrap_or_else(|| self.union(node)),
        };
        self.of.push(set);
    }

    /// The set of a symbol.
    fn alone(&mut self, symbol: Symbol) -> u32 {
        let place = self.all.iter().position(|other| *other == symbol).unwrap_or(self.all.len());
        if place == self.all.len() {
            self.all.push(symbol);
        }
        self.bits = vec![0; place / 64 + 1];
        self.bits[place / 64] = 1 << (place % 64);
        self.number(Reads::of(symbol))
    }

    /// The set of an operand that has the sets of all.
    fn largest(&self, node: &Node) -> Option<u32> {
        let (of, sets) = (self.of.as_slice(), self.sets.as_slice());
        let mut largest = None;
        let mut is_one = true;
        node.for_each_child(|child| {
            let other = of[child.index()];
            match largest {
                None => largest = Some(other),
                Some(set) if set == other || contains(&sets[set as usize].bits, &sets[other as usize].bits) => {}
                Some(set) if contains(&sets[other as usize].bits, &sets[set as usize].bits) => largest = Some(other),
                Some(_) => is_one = false,
            }
        });
        largest.filter(|_| is_one)
    }

    /// The union of the sets of all operands.
    fn union(&mut self, node: &Node) -> u32 {
        self.bits.clear();
        let mut reads = Reads::default();
        node.for_each_child(|child| {
            let set = &self.sets[self.of[child.index()] as usize];
            if self.bits.len() < set.bits.len() {
                self.bits.resize(set.bits.len(), 0);
            }
            for (word, other) in self.bits.iter_mut().zip(&set.bits) {
                *word |= other;
            }
            reads = reads.or(set.reads);
        });
        self.number(reads)
    }

    /// The number of a set, known or not.
    fn number(&mut self, reads: Reads) -> u32 {
        let hash = hash::of_words(&self.bits);
        let known = self.known.find(hash, |number| self.sets[number].bits == self.bits);
        let number = known.unwrap_or_else(|| {
            self.known.insert(hash, self.sets.len());
            self.sets.push(Set { bits: self.bits.clone(), reads });
            self.sets.len() - 1
        });
        number as u32
    }
}

/// Whether all bits of others are set.
fn contains(bits: &[u64], others: &[u64]) -> bool {
    others.len() <= bits.len() && bits.iter().zip(others).all(|(bits, others)| others & !bits == 0)
}
