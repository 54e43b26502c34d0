//! Notes about new nodes: places, heights, and the conditions under which partial functions are computed.

use super::value::{Around, Value};
use super::{Lowering, MAX_HEIGHT, Place};
use crate::ir::{Id, Node, UndefinedAt};
use quote::ToTokens;

impl Lowering {
    /// Notes the place of a number and checks all new nodes.
    pub(super) fn written(&mut self, id: Id, syntax: &impl ToTokens, place: impl FnOnce() -> Place) -> Value {
        self.places.entry(id).or_insert_with(place);
        self.noted(syntax, Value::Real(id))
    }

    /// Checks all new nodes. Refuses deeply nested operations and constants such as 1/0, which have no derivative.
    pub(super) fn noted(&mut self, syntax: &impl ToTokens, value: Value) -> Value {
        let new: Vec<Id> = self.graph.ids_from(self.heights.len()).collect();
        for id in &new {
            let below = self.graph.node(*id).children().iter().map(|child| self.heights[child.index()]).max();
            self.heights.push(below.map_or(0, |height| height + 1));
        }
        if new.iter().any(|id| self.heights[id.index()] > MAX_HEIGHT) {
            return self
                .refuse(syntax, "this is nested too deeply: it depends on a value that depends on a value, and so on");
        }
        self.note_partial();
        if !new.iter().all(|id| self.is_finite(*id)) {
            return self.refuse(syntax, "this is not a finite number, whatever the state is");
        }
        value
    }

    /// Notes new nodes that are not defined everywhere, with the conditions around them.
    pub(super) fn note_partial(&mut self) {
        let nodes = self.graph.take_partial();
        if nodes.is_empty() {
            return;
        }
        self.noted_partial += nodes.len();
        let all = self.conditions.iter().copied().reduce(|a, b| self.graph.and(a, b));
        for node in nodes {
            self.partial.entry(node).or_default().insert(all);
        }
    }

    /// Returns all nodes that are not defined everywhere, each with one condition. Precondition: the evaluation has ended.
    pub(super) fn all_partial(&mut self) -> Vec<UndefinedAt> {
        self.note_partial();
        self.graph.stop_recording();
        let partial = std::mem::take(&mut self.partial).into_iter().map(|(node, conditions)| {
            let all: Option<Vec<Id>> = conditions.into_iter().collect();
            UndefinedAt { node, condition: all.and_then(|all| all.into_iter().reduce(|a, b| self.graph.or(a, b))) }
        });
        partial.collect()
    }

    /// Evaluates the side of a branch in which a condition holds.
    pub(super) fn under(&mut self, condition: Id, evaluate: impl FnOnce(&mut Self) -> Value) -> Value {
        self.note_partial();
        self.conditions.push(condition);
        let barrier = self.scopes.close(Around::Branch);
        let value = evaluate(self);
        self.note_partial();
        self.conditions.pop();
        self.scopes.barrier = barrier;
        value
    }

    /// Returns whether the constants in a node are finite. Finite operations on constants have been folded to one number.
    fn is_finite(&self, id: Id) -> bool {
        let is_number = |id: &Id| self.graph.as_number(*id).is_some();
        match self.graph.node(id) {
            Node::Number(x) => x.to_f64().is_finite(),
            Node::Linear(constant, terms) => {
                terms.iter().map(|(c, _)| c).chain([constant]).all(|c| c.to_f64().is_finite())
            }
            Node::Power(base, _) => !is_number(base),
            Node::Call(_, args) => !args.iter().all(is_number),
            _ => true,
        }
    }
}
