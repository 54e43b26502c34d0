//! Families of energies, pieces of an energy, and their flows.

use super::polynomial::is_free;
use super::time::Clock;
use crate::ir::op::Domain;
use crate::ir::{Function, Graph, Id, Node, Symbol};
use crate::schedule::Levels;

/// The coordinates of a system.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Space {
    pub(crate) degrees: u32,
    /// Whether s is a coordinate, whose flow must then be known, too.
    pub(crate) action: bool,
}

/// Terms of an energy that are tried as one piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group {
    pub(super) energy: Id,
    pub(super) degrees: u32,
    pub(super) clock: Clock,
}

/// Other families, asked for the flow of a group.
pub(super) type Rules<'a> = &'a dyn Fn(&mut Graph, &Group) -> Option<Flow>;

/// A rule that finds the flow from flows of other energies.
type Derived = fn(&mut Graph, &Group, Rules<'_>) -> Option<Flow>;

/// How a family finds the flow of a group. Every rule returns `None` if the group does not belong to the family.
#[derive(Clone, Copy)]
pub(super) enum Solve {
    /// From the energy alone.
    Direct(fn(&mut Graph, &Group) -> Option<Flow>),
    /// From the flow of another energy, by families earlier in the list.
    Transformed(Derived),
    /// From the flow of the energy in another gauge, by families that transform no energy.
    ByGauge(Derived),
    /// From the flows of its parts, by families earlier in the list.
    InParts(Derived),
}

/// A family of energies whose flow is known.
pub(crate) struct Family {
    /// Its name in reports.
    pub(crate) name: &'static str,
    /// The energies, with the conditions on their coefficients.
    pub(crate) energies: &'static str,
    /// A publication about such energies, or about the method that gives their flow.
    pub(crate) source: &'static str,
    /// Whether the flow of s is known, as contact systems need it.
    pub(super) action: bool,
    /// The rule that finds the flow.
    pub(super) solve: Solve,
}

impl std::fmt::Debug for Family {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// q, p and s at the end of a flow of length h, as functions of q, p and s at its start. s stays where the system has no action.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Flow {
    pub(crate) q: Vec<Id>,
    pub(crate) p: Vec<Id>,
    pub(crate) s: Id,
}

impl Flow {
    /// Returns the flow that moves nothing.
    pub(super) fn rest(graph: &mut Graph, degrees: u32) -> Flow {
        let [q, p] = [Symbol::Position as fn(u32) -> Symbol, Symbol::Momentum]
            .map(|of| (0..degrees).map(of).collect::<Vec<_>>());
        let mut symbols = |all: Vec<Symbol>| all.into_iter().map(|symbol| graph.symbol(symbol)).collect();
        Flow { q: symbols(q), p: symbols(p), s: symbols(vec![Symbol::Action]).remove(0) }
    }

    /// Sets the end of a coordinate.
    pub(super) fn moves(&mut self, symbol: Symbol, end: Id) {
        match symbol {
            Symbol::Position(i) => self.q[i as usize] = end,
            Symbol::Momentum(i) => self.p[i as usize] = end,
            _ => self.s = end,
        }
    }

    /// Returns the coordinates that the flow changes, with their ends.
    pub(crate) fn changed(&self, graph: &mut Graph) -> Vec<(Symbol, Id)> {
        let start = Flow::rest(graph, self.q.len() as u32);
        let ends = self.all().into_iter().zip(start.all());
        let symbol = |id: Id| match graph.node(id) {
            Node::Symbol(symbol) => Some(*symbol),
            _ => None,
        };
        ends.filter(|(end, start)| end != start).filter_map(|(end, start)| Some((symbol(start)?, end))).collect()
    }

    /// Returns whether the flow contains functions that give NaN where the flow ends early.
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

/// Returns whether a flow may end early at points where its energy is defined. The flow then contains expressions that are undefined
/// there. Other results that are not finite come from overflow or from parameters that are not finite.
pub(crate) fn may_end(graph: &Graph, energy: Id, ends: &[Id]) -> bool {
    let divided_by = |id: &Id| match graph.node(*id) {
        Node::Power(base, exponent) if exponent.numerator < 0 || !exponent.is_integer() => Some(*base),
        _ => None,
    };
    // A singularity in time is an end as well: the flow continues to times at which the energy is not evaluated.
    let steady = |id: &Id| is_free(graph, *id, &|symbol| symbol == Symbol::Time);
    let of_energy: Vec<Id> = graph.reachable(&[energy]).into_iter().filter(steady).collect();
    let bases: Vec<Id> = of_energy.iter().filter_map(divided_by).collect();
    graph.reachable(ends).iter().any(|id| match graph.node(*id) {
        Node::Call(function, _) => {
            function.ends_flows() || function.entry().domain != Domain::Everywhere && !of_energy.contains(id)
        }
        _ => divided_by(id).is_some_and(|base| !bases.contains(&base) && !is_constant(graph, base)),
    })
}

/// Returns whether an expression reads neither coordinates, nor time, nor the length of the flow.
fn is_constant(graph: &Graph, id: Id) -> bool {
    is_free(graph, id, &|symbol| symbol.is_coordinate() || matches!(symbol, Symbol::Time | Symbol::StepLength))
}

/// A part of the energy whose flow is known in closed form.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) energy: Id,
    /// The family whose rule found the flow.
    pub(crate) family: &'static Family,
    pub(crate) flow: Flow,
    pub(crate) clock: Clock,
}

impl Piece {
    /// Returns the order in which symbols become known: parameters and h first, then frozen time.
    pub(crate) fn levels(&self) -> Levels {
        match self.clock {
            Clock::Own => Levels::Unfrozen,
            Clock::Stage => Levels::Frozen,
        }
    }
}
