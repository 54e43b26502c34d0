//! Constructors of function calls, selections and conditions.

use super::graph::Graph;
use super::id::Id;
use super::node::Node;
use super::number::Number;
use super::op::{Function, Parity, Relation};

impl Graph {
    /// Builds a call. Calls of numbers are evaluated, and odd and even functions lose the sign of their argument.
    pub(crate) fn call(&mut self, function: Function, args: &[Id]) -> Id {
        let entry = function.entry();
        let numbers: Option<Vec<f64>> = args.iter().map(|id| self.as_number(*id).map(Number::to_f64)).collect();
        let value = numbers.filter(|_| entry.public).map(|x| (entry.value)(&x));
        if let Some(value) = value.filter(|value| value.is_finite()) {
            return self.number(Number::float(value));
        }
        match (entry.parity, args) {
            (Parity::Odd | Parity::Even, &[x]) if self.leads_negative(x) => {
                let x = self.negated_sum(x);
                let value = self.call(function, &[x]);
                if entry.parity == Parity::Odd { self.neg(value) } else { value }
            }
            _ => self.intern(Node::Call(function, args.to_vec())),
        }
    }

    /// Builds `if condition { first } else { second }`.
    pub(crate) fn select(&mut self, condition: Id, first: Id, second: Id) -> Id {
        match self.node(condition) {
            _ if first == second => first,
            Node::Truth(true) => first,
            Node::Truth(false) => second,
            _ => self.intern(Node::Select(condition, first, second)),
        }
    }

    /// Builds a comparison.
    pub(crate) fn compare(&mut self, relation: Relation, a: Id, b: Id) -> Id {
        match [a, b].map(|side| self.as_number(side).map(Number::to_f64).filter(|value| !value.is_nan())) {
            [Some(x), Some(y)] => self.truth(relation.holds(x, y)),
            _ => self.intern(Node::Compare(relation, a, b)),
        }
    }

    /// Builds a constant condition.
    pub(crate) fn truth(&mut self, value: bool) -> Id {
        self.intern(Node::Truth(value))
    }

    /// Returns the value of a constant condition.
    pub(crate) fn as_truth(&self, id: Id) -> Option<bool> {
        match self.node(id) {
            Node::Truth(value) => Some(*value),
            _ => None,
        }
    }

    /// Builds the conjunction of two conditions.
    pub(crate) fn and(&mut self, a: Id, b: Id) -> Id {
        match (self.as_truth(a), self.as_truth(b)) {
            (Some(true), _) => b,
            (_, Some(true)) => a,
            (Some(false), _) | (_, Some(false)) => self.truth(false),
            _ => self.intern(Node::And(a, b)),
        }
    }

    /// Builds the disjunction of two conditions.
    pub(crate) fn or(&mut self, a: Id, b: Id) -> Id {
        match (self.as_truth(a), self.as_truth(b)) {
            (Some(false), _) => b,
            (_, Some(false)) => a,
            (Some(true), _) | (_, Some(true)) => self.truth(true),
            _ => self.intern(Node::Or(a, b)),
        }
    }

    /// Builds the negation of a condition.
    pub(crate) fn not(&mut self, a: Id) -> Id {
        match *self.node(a) {
            Node::Truth(value) => self.truth(!value),
            Node::Not(inner) => inner,
            _ => self.intern(Node::Not(a)),
        }
    }
}
