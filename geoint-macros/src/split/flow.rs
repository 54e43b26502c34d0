//! What families of energies, pieces and their flows are.

use super::polynomial::is_free;
use super::time::Clock;
use crate::ir::op::Domain;
use crate::ir::{Function, Graph, Id, Node, Symbol};
use crate::schedule::Levels;

/// Which coordinates there are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Space {
    pub(crate) degrees: u32,
    /// Whether s is among them: then its flow has to be known, too.
    pub(crate) action: bool,
}

/// Terms that are to be one piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group {
    pub(super) energy: Id,
    pub(super) degrees: u32,
    pub(super) clock: Clock,
}

/// The flow of a group, if it belongs to a family.
pub(super) type Solve = fn(&mut Graph, &Group) -> Option<Flow>;

/// A family of energies whose flow is known.
pub(crate) struct Family {
    /// What it is called in reports.
    pub(crate) name: &'static str,
    /// The energies, with what is asked of their coefficients.
    pub(crate) energies: &'static str,
    /// Where such energies, or what their flow follows from, can be read about.
    pub(crate) source: &'static str,
    /// Whether the flow of s is known, so that it serves contact systems.
    pub(super) action: bool,
    /// The flow, if an energy belongs to the family.
    pub(super) solve: Solve,
}

impl std::fmt::Debug for Family {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// q, p and s at the end of a flow of length h, in terms of those at its start; s stays where its flow is not asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Flow {
    pub(crate) q: Vec<Id>,
    pub(crate) p: Vec<Id>,
    pub(crate) s: Id,
}

impl Flow {
    /// Nothing moves.
    pub(super) fn rest(graph: &mut Graph, degrees: u32) -> Flow {
        let [q, p] = [Symbol::Q as fn(u32) -> Symbol, Symbol::P].map(|of| (0..degrees).map(of).collect::<Vec<_>>());
        let mut symbols = |all: Vec<Symbol>| all.into_iter().map(|symbol| graph.symbol(symbol)).collect();
        Flow { q: symbols(q), p: symbols(p), s: symbols(vec![Symbol::S]).remove(0) }
    }

    /// A coordinate ends here.
    pub(super) fn moves(&mut self, symbol: Symbol, end: Id) {
        match symbol {
            Symbol::Q(i) => self.q[i as usize] = end,
            Symbol::P(i) => self.p[i as usize] = end,
            _ => self.s = end,
        }
    }

    /// Everything that the flow changes, with its symbol.
    pub(crate) fn changed(&self, graph: &mut Graph) -> Vec<(Symbol, Id)> {
        let start = Flow::rest(graph, self.q.len() as u32);
        let ends = self.all().into_iter().zip(start.all());
        let symbol = |id: Id| match graph.node(id) {
            Node::Symbol(symbol) => Some(*symbol),
            _ => None,
        };
        ends.filter(|(end, start)| end != start).filter_map(|(end, start)| Some((symbol(start)?, end))).collect()
    }

    /// Whether it may end before its time, by functions that are not numbers then.
    pub(super) fn ends_early(&self, graph: &Graph) -> bool {
        let stops = |id: &Id| {
            matches!(
                graph.node(*id),
                Node::Call(Function::NotNegative | Function::RecipPositive | Function::AtMost | Function::Powf, _)
            )
        };
        graph.reachable(&self.all()).iter().any(stops)
    }

    pub(super) fn all(&self) -> Vec<Id> {
        [&self.q[..], &self.p, &[self.s]].concat()
    }
}

/// Whether a flow may end before its time at points where its energy is defined: it reads then what is not a number there. What is not
/// finite otherwise has overflown, or is made of parameters that are not finite.
pub(crate) fn may_end(graph: &Graph, energy: Id, ends: &[Id]) -> bool {
    let divided_by = |id: &Id| match graph.node(*id) {
        Node::Power(base, exponent) if exponent.numerator < 0 || !exponent.is_integer() => Some(*base),
        _ => None,
    };
    // What becomes singular in time is an end as well: the flow goes on to times at which the energy is not asked for.
    let steady = |id: &Id| is_free(graph, *id, &|symbol| symbol == Symbol::T);
    let of_energy: Vec<Id> = graph.reachable(&[energy]).into_iter().filter(steady).collect();
    let bases: Vec<Id> = of_energy.iter().filter_map(divided_by).collect();
    graph.reachable(ends).iter().any(|id| match graph.node(*id) {
        Node::Call(function, _) => {
            function.ends_flows() || function.entry().domain != Domain::Everywhere && !of_energy.contains(id)
        }
        _ => divided_by(id).is_some_and(|base| !bases.contains(&base) && !is_constant(graph, base)),
    })
}

/// Whether nothing that moves, nor the length of a flow, is read.
fn is_constant(graph: &Graph, id: Id) -> bool {
    is_free(graph, id, &|symbol| symbol.is_coordinate() || matches!(symbol, Symbol::T | Symbol::H))
}

/// A part of the energy whose flow is known in closed form.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) energy: Id,
    /// The family that it belongs to.
    pub(crate) family: &'static Family,
    pub(crate) flow: Flow,
    pub(crate) clock: Clock,
}

impl Piece {
    /// When symbols are known: parameters and h first, then frozen time.
    pub(crate) fn levels(&self) -> Levels {
        match self.clock {
            Clock::Own => Levels::Unfrozen,
            Clock::Stage => Levels::Frozen,
        }
    }
}
