//! Families of energies, pieces of an energy, and their flows.

use super::polynomial::is_free;
use super::time::Clock;
use crate::ir::op::Domain;
use crate::ir::{Function, Graph, Id, Node, Symbol};
use crate::schedule::{Levels, cost};

/// The coordinates of a system.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Space {
    pub(crate) degrees: u32,
    /// Whether the action s is a coordinate. Its flow must then be known, too.
    pub(crate) action: bool,
}

/// Terms of an energy that are tried as one piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group {
    pub(super) energy: Id,
    pub(super) degrees: u32,
    pub(super) clock: Clock,
}

/// A search for the flow of a group among other families.
pub(super) type Rules<'a> = &'a dyn Fn(&mut Graph, &Group) -> Option<Flow>;

/// A rule that derives the flow of a group from flows of other energies.
type Derived = fn(&mut Graph, &Group, Rules<'_>) -> Option<Flow>;

/// The rule by which a family finds the flow of a group. Every rule returns `None` if the group does not belong to the family.
#[derive(Clone, Copy)]
pub(super) enum Solve {
    /// The rule needs the energy only.
    Direct(fn(&mut Graph, &Group) -> Option<Flow>),
    /// The rule transforms the energy and asks families earlier in the list.
    Transformed(Derived),
    /// The rule changes the gauge and asks families of the kinds `Direct` and `InParts`.
    ByGauge(Derived),
    /// The rule splits the energy and asks families earlier in the list.
    InParts(Derived),
}

/// A family of energies with a known flow.
pub(crate) struct Family {
    /// The name in reports.
    pub(crate) name: &'static str,
    /// The energies, with the conditions on their coefficients.
    pub(crate) energies: &'static str,
    /// A publication about the energies or about the method for their flow.
    pub(crate) source: &'static str,
    /// Whether the flow of s is known. Contact systems need it.
    pub(super) action: bool,
    /// The rule that finds the flow.
    pub(super) solve: Solve,
}

impl std::fmt::Debug for Family {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// q, p and s at the end of a flow of length h, as functions of q, p and s at its start. Systems without an action keep s.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Flow {
    pub(crate) q: Vec<Id>,
    pub(crate) p: Vec<Id>,
    pub(crate) s: Id,
}

impl Flow {
    /// Returns the identity: every coordinate keeps its value.
    pub(super) fn rest(graph: &mut Graph, degrees: u32) -> Flow {
        let q = (0..degrees).map(|i| graph.symbol(Symbol::Position(i))).collect();
        let p = (0..degrees).map(|i| graph.symbol(Symbol::Momentum(i))).collect();
        Flow { q, p, s: graph.symbol(Symbol::Action) }
    }

    /// Sets the end value of a coordinate.
    pub(super) fn set(&mut self, symbol: Symbol, end: Id) {
        match symbol {
            Symbol::Position(i) => self.q[i as usize] = end,
            Symbol::Momentum(i) => self.p[i as usize] = end,
            _ => self.s = end,
        }
    }

    /// Returns the coordinates that the flow changes, with their end values.
    pub(crate) fn changed(&self, graph: &mut Graph) -> Vec<(Symbol, Id)> {
        let start = Flow::rest(graph, self.q.len() as u32);
        let ends = self.all().into_iter().zip(start.all());
        let symbol = |id: Id| match graph.node(id) {
            Node::Symbol(symbol) => Some(*symbol),
            _ => None,
        };
        ends.filter(|(end, start)| end != start).filter_map(|(end, start)| Some((symbol(start)?, end))).collect()
    }

    /// Returns whether the flow contains functions that give NaN at points where the flow ends early.
    pub(super) fn ends_early(&self, graph: &Graph) -> bool {
        let stops = |id: &Id| {
            matches!(
                graph.node(*id),
                Node::Call(Function::NotNegative | Function::RecipPositive | Function::AtMost | Function::Powf, _)
            )
        };
        graph.reachable(&self.all()).iter().any(stops)
    }

    /// Returns all end values in the order q, p, s.
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

/// A part of the energy with a flow in closed form.
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

    /// Returns the estimated cost of one evaluation of the flow, in units of one sum.
    ///
    /// The cost is the weight of the operations in the last routine of the flow's schedule, plus 1 for each coordinate that the flow changes.
    /// Thus one kick costs less than two kicks with the same operations. Operations that need only h, parameters and frozen time do not
    /// count, because they run once for each step length or step. `split` calls the scheduler only here:
    /// a count needs the statements that the scheduler shares and moves. The schedule is discarded, but it may add nodes to the graph.
    pub(super) fn cost(&self, graph: &mut Graph) -> usize {
        let ends: Vec<Id> = self.flow.changed(graph).into_iter().map(|(_, end)| end).collect();
        ends.len() + cost(graph, self.levels(), &ends)
    }
}
