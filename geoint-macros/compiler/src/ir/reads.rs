//! The symbols that a node reads.

use super::hash::HashMap;
use super::id::Id;
use super::node::Node;
use super::symbol::Symbol;
use super::table::Table;
use std::collections::BTreeSet;

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

/// Cache of the symbols that nodes read. Many nodes read the same symbols, so nodes share sets.
#[derive(Clone, Debug, Default)]
pub(super) struct Symbols {
    /// Sorted sets of symbols, all different.
    sets: Vec<Vec<Symbol>>,
    /// The places of the unions of sets, by the places of these sets.
    unions: HashMap<Vec<u32>, u32>,
    /// The place of each node's set.
    pub(super) of: Table<u32>,
}

impl Symbols {
    /// Returns the symbols that a node reads, in order.
    pub(super) fn of(&self, id: Id) -> &[Symbol] {
        &self.sets[self.of[id] as usize]
    }

    /// Adds the set of a node. Precondition: the sets of its operands are present.
    pub(super) fn insert(&mut self, id: Id, node: &Node) {
        let mut sets: Vec<u32> = vec![];
        node.for_each_child(|child| sets.push(self.of[child]));
        sets.sort_unstable();
        sets.dedup();
        let set = match (node, &sets[..]) {
            (Node::Symbol(symbol), _) => self.push(vec![*symbol]),
            (_, [set]) => *set,
            _ => match self.unions.get(&sets) {
                Some(union) => *union,
                None => {
                    let union: BTreeSet<Symbol> =
                        sets.iter().flat_map(|set| &self.sets[*set as usize]).copied().collect();
                    let union = self.push(union.into_iter().collect());
                    self.unions.insert(sets, union);
                    union
                }
            },
        };
        self.of.insert(id, set);
    }

    /// Returns the place of a set, and adds it if it is new. There are few sets.
    fn push(&mut self, set: Vec<Symbol>) -> u32 {
        let place = self.sets.iter().position(|known| *known == set).unwrap_or(self.sets.len());
        if place == self.sets.len() {
            self.sets.push(set);
        }
        place as u32
    }
}
