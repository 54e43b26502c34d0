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

/// The symbols that nodes read: sets, which nodes share.
#[derive(Clone, Debug)]
pub(super) struct Symbols {
    /// In the order in which they came.
    all: Vec<Symbol>,
    /// The first is empty.
    sets: Vec<Set>,
    /// The set of each node.
    of: Vec<u32>,
}

/// Symbols as bits, 64 a word, by their places among all; and what they are.
#[derive(Clone, Debug, Default)]
struct Set {
    bits: Vec<u64>,
    reads: Reads,
}

impl Default for Symbols {
    fn default() -> Self {
        Symbols { all: vec![], sets: vec![Set::default()], of: vec![] }
    }
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
            node => self.union(node),
        };
        self.of.push(set);
    }

    /// The set of a symbol.
    fn alone(&mut self, symbol: Symbol) -> u32 {
        let place = self.all.iter().position(|other| *other == symbol).unwrap_or(self.all.len());
        if place == self.all.len() {
            self.all.push(symbol);
        }
        let mut bits = vec![0; place / 64 + 1];
        bits[place / 64] = 1 << (place % 64);
        self.with(Set { bits, reads: Reads::of(symbol) })
    }

    /// The union of the sets of operands: mostly that of one of them.
    fn union(&mut self, node: &Node) -> u32 {
        let (of, sets) = (self.of.as_slice(), self.sets.as_slice());
        let (mut largest, mut union) = (0, None);
        node.for_each_child(|child| {
            let set = of[child.index()];
            if set == largest {
                return;
            }
            let (known, other) = (&sets[largest as usize], &sets[set as usize]);
            match &mut union {
                Some(union) => other.join(union),
                None if known.contains(other) => {}
                None if other.contains(known) => largest = set,
                None => {
                    let mut both = known.clone();
                    other.join(&mut both);
                    union = Some(both);
                }
            }
        });
        match union {
            Some(union) => self.with(union),
            None => largest,
        }
    }

    fn with(&mut self, set: Set) -> u32 {
        self.sets.push(set);
        self.sets.len() as u32 - 1
    }
}

impl Set {
    fn contains(&self, other: &Set) -> bool {
        let (bits, others) = (self.bits.as_slice(), other.bits.as_slice());
        if others.len() > bits.len() {
            return false;
        }
        let mut place = 0;
        while place < others.len() {
            if others[place] & !bits[place] != 0 {
                return false;
            }
            place += 1;
        }
        true
    }

    /// Adds these to others.
    fn join(&self, others: &mut Set) {
        if others.bits.len() < self.bits.len() {
            others.bits.resize(self.bits.len(), 0);
        }
        for (word, own) in others.bits.iter_mut().zip(&self.bits) {
            *word |= own;
        }
        others.reads = others.reads.or(self.reads);
    }
}
