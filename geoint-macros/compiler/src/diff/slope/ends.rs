//! The value of a node at the end of a step, its mean and its increment.

use super::super::sweep::Step;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Symbol};

type Replace = fn(&mut Graph, Symbol) -> Option<Id>;

/// Divided differences between (q, p, s) and (q + dq, p + dp, s + ds).
pub(in super::super) struct Slopes {
    end: Substitution<Replace>,
    affine_increments: HashMap<Id, Option<Id>>,
    increments: HashMap<Id, Id>,
}

impl Default for Slopes {
    fn default() -> Self {
        Slopes {
            end: Substitution::new(coordinate_at_end),
            affine_increments: HashMap::default(),
            increments: HashMap::default(),
        }
    }
}

/// The increment of a position, a momentum or the action.
pub(in super::super) fn coordinate_increment(graph: &mut Graph, symbol: Symbol) -> Option<Id> {
    match symbol {
        Symbol::Position(i) => Some(graph.symbol(Symbol::PositionIncrement(i))),
        Symbol::Momentum(i) => Some(graph.symbol(Symbol::MomentumIncrement(i))),
        Symbol::Action => Some(graph.symbol(Symbol::ActionIncrement)),
        _ => None,
    }
}

/// A coordinate in the middle of a step.
pub(crate) fn coordinate_in_middle(graph: &mut Graph, symbol: Symbol) -> Option<Id> {
    let increment = coordinate_increment(graph, symbol)?;
    let start = graph.symbol(symbol);
    Some(graph.build(start + Number::HALF * increment))
}

/// A coordinate at the end of a step.
pub(crate) fn coordinate_at_end(graph: &mut Graph, symbol: Symbol) -> Option<Id> {
    let increment = coordinate_increment(graph, symbol)?;
    let start = graph.symbol(symbol);
    Some(graph.add(start, increment))
}

impl Slopes {
    /// The value at the end of the step.
    pub(in super::super) fn end(&mut self, graph: &mut Graph, id: Id) -> Id {
        if let Some(increment) = self.affine_increment(graph, id) {
            return graph.add(id, increment);
        }
        // Continue an angle across its branch cut, so that no step jumps there. Functions of period 2π have the same values.
        for angle in self.end.unknown(graph, id) {
            if matches!(graph.node(angle), Node::Call(Function::Atan2, _)) {
                let increment = self.increment(graph, angle);
                let end = graph.add(angle, increment);
                self.end.insert(angle, end);
            }
        }
        self.end.apply(graph, id)
    }

    /// The mean (start + end)/2 of the values at both ends.
    pub(in super::super) fn mean(&mut self, graph: &mut Graph, id: Id) -> Id {
        match self.affine_increment(graph, id) {
            Some(increment) => graph.build(id + Number::HALF * increment),
            None => {
                let end = self.end(graph, id);
                graph.build(Number::HALF * (id + end))
            }
        }
    }

    /// The increment end − start from the increments of the coordinates, without a difference of two values.
    pub(in super::super) fn increment(&mut self, graph: &mut Graph, id: Id) -> Id {
        if let Some(increment) = self.affine_increment(graph, id).or_else(|| self.increments.get(&id).copied()) {
            return increment;
        }
        let mut parts = vec![];
        match self.step(graph, id) {
            Step::Operands(slopes) => {
                for (operand, slope) in slopes {
                    let increment = self.increment(graph, operand);
                    parts.push(graph.mul(slope, increment));
                }
            }
            Step::Coordinates(entries) => {
                for (symbol, slope) in entries {
                    if let Some(increment) = coordinate_increment(graph, symbol) {
                        parts.push(graph.mul(slope, increment));
                    }
                }
            }
        }
        let increment = graph.sum(&parts);
        self.increments.insert(id, increment);
        increment
    }

    /// Returns whether a node is known to have equal values at both ends.
    pub(in super::super) fn is_constant(&mut self, graph: &mut Graph, id: Id) -> bool {
        self.affine_increment(graph, id).is_some_and(|increment| graph.is_zero(increment))
    }

    /// The increment of a node that is affine in the coordinates, else `None`. It does not depend on the start of the step.
    fn affine_increment(&mut self, graph: &mut Graph, id: Id) -> Option<Id> {
        if let Some(known) = self.affine_increments.get(&id) {
            return *known;
        }
        let increment = match graph.node(id).clone() {
            Node::Symbol(symbol) => Some(coordinate_increment(graph, symbol).unwrap_or_else(|| graph.zero())),
            Node::Linear(_, terms) => terms
                .into_iter()
                .map(|(c, term)| self.affine_increment(graph, term).map(|increment| graph.scale(c, increment)))
                .collect::<Option<Vec<_>>>()
                .map(|parts| graph.sum(&parts)),
            node => {
                let constant = node.children().iter().all(|child| self.is_constant(graph, *child));
                constant.then(|| graph.zero())
            }
        };
        self.affine_increments.insert(id, increment);
        increment
    }
}
