//! Which symbols a node reads.

use super::hash::HashMap;
use super::op::Symbol;
use std::rc::Rc;

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

/// A set of symbols: its place among the sets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Set(usize);

/// Sets of symbols. Many nodes read the same ones: each set stands here once, and each union is found once.
#[derive(Clone, Debug)]
pub(super) struct Sets {
    /// In order; the first one is empty.
    sets: Vec<(Rc<[Symbol]>, Reads)>,
    known: HashMap<Rc<[Symbol]>, Set>,
    unions: HashMap<(Set, Set), Set>,
}

impl Default for Sets {
    fn default() -> Self {
        let mut sets = Sets { sets: vec![], known: HashMap::default(), unions: HashMap::default() };
        sets.intern(vec![]);
        sets
    }
}

impl Sets {
    pub(super) fn symbols(&self, set: Set) -> &[Symbol] {
        &self.sets[set.0].0
    }

    pub(super) fn reads(&self, set: Set) -> Reads {
        self.sets[set.0].1
    }

    pub(super) fn single(&mut self, symbol: Symbol) -> Set {
        self.intern(vec![symbol])
    }

    pub(super) fn union(&mut self, a: Set, b: Set) -> Set {
        let empty = Set::default();
        if a == b || b == empty {
            return a;
        }
        if a == empty {
            return b;
        }
        if let Some(union) = self.unions.get(&(a, b)) {
            return *union;
        }
        let mut symbols = [self.symbols(a), self.symbols(b)].concat();
        symbols.sort();
        symbols.dedup();
        let union = self.intern(symbols);
        self.unions.insert((a, b), union);
        union
    }

    fn intern(&mut self, symbols: Vec<Symbol>) -> Set {
        let symbols: Rc<[Symbol]> = symbols.into();
        *self.known.entry(symbols).or_insert_with_key(|symbols| {
            let reads = symbols.iter().fold(Reads::default(), |all, symbol| all.or(Reads::of(*symbol)));
            self.sets.push((Rc::clone(symbols), reads));
            Set(self.sets.len() - 1)
        })
    }
}
