//! Which coordinates a node reads.

use crate::ir::{Graph, Id, Node, Symbol};
use std::collections::BTreeSet;

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

    /// What reading a symbol is.
    pub(crate) fn of(symbol: Symbol) -> Reads {
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

/// What every node of a graph reads.
pub(crate) struct Dependence(Vec<Reads>);

impl Dependence {
    pub(crate) fn of(graph: &Graph) -> Dependence {
        let mut reads: Vec<Reads> = Vec::with_capacity(graph.len());
        for id in graph.ids() {
            let own = match graph.node(id) {
                Node::Symbol(symbol) => Reads::of(*symbol),
                node => {
                    let mut all = Reads::default();
                    node.for_each_child(|child| all = all.or(reads[child.index()]));
                    all
                }
            };
            reads.push(own);
        }
        Dependence(reads)
    }

    pub(crate) fn reads(&self, id: Id) -> Reads {
        self.0[id.index()]
    }
}

/// Whether positions and momenta do not move without s, which decay at the rate ∂H/∂s and move by these derivatives else: by a condition a
/// derivative reads s, too, where nothing is differentiated by it.
pub(crate) fn acts_back(graph: &Graph, decay: Id, slopes: impl IntoIterator<Item = Id>) -> bool {
    reads(graph, decay).state() || slopes.into_iter().any(|slope| reads(graph, slope).s)
}

/// What a node reads.
pub(crate) fn reads(graph: &Graph, root: Id) -> Reads {
    symbols(graph, root).into_iter().fold(Reads::default(), |all, symbol| all.or(Reads::of(symbol)))
}

/// All symbols that a node reads.
pub(crate) fn symbols(graph: &Graph, root: Id) -> BTreeSet<Symbol> {
    let symbol = |id: Id| match graph.node(id) {
        Node::Symbol(symbol) => Some(*symbol),
        _ => None,
    };
    graph.reachable(&[root]).into_iter().filter_map(symbol).collect()
}
