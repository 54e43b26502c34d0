//! What is evaluated under a condition.

use super::Lowering;
use super::value::Value;
use crate::ir::Id;
use syn::{BinOp, ExprBinary, ExprIf};

impl Lowering {
    /// `a && b` and `a || b`: what is on the right exists only if the left does not decide.
    pub(super) fn connective(&mut self, binary: &ExprBinary) -> Value {
        let left = self.expr(&binary.left);
        if let Value::Truth(id) = left
            && self.graph.as_truth(id) == Some(matches!(binary.op, BinOp::Or(_)))
        {
            return left;
        }
        let condition = match left {
            Value::Truth(id) if matches!(binary.op, BinOp::Or(_)) => self.graph.not(id),
            Value::Truth(id) => id,
            _ => self.graph.truth(true),
        };
        let before = self.enter_branch(condition);
        let right = self.expr(&binary.right);
        self.leave_branch(before);
        self.arithmetic(binary, &binary.op, left, right)
    }

    pub(super) fn branch(&mut self, branch: &ExprIf) -> Value {
        let condition = match self.expr(&branch.cond) {
            Value::Truth(id) => id,
            Value::Poison => return Value::Poison,
            other => {
                return self.refuse(&branch.cond, format!("a condition compares numbers; this is {}", other.kind()));
            }
        };
        // A condition on loop indices is decided now: only one branch exists.
        if let Some(truth) = self.graph.as_truth(condition) {
            return match (&branch.else_branch, truth) {
                (_, true) => self.block(&branch.then_branch),
                (Some((_, other)), false) => self.expr(other),
                (None, false) => Value::unit(),
            };
        }
        let Some((_, otherwise)) = &branch.else_branch else {
            // What the branch would do is to assign; that message is the better one.
            let said = self.errors.len();
            let before = self.enter_branch(condition);
            self.block(&branch.then_branch);
            self.leave_branch(before);
            if self.errors.len() == said {
                self.refuse(&branch.if_token, "give this `if` an `else`: it must have a value on both sides");
            }
            return Value::Poison;
        };
        let before = self.enter_branch(condition);
        let first = self.block(&branch.then_branch);
        self.leave_branch(before);
        let opposite = self.graph.not(condition);
        let before = self.enter_branch(opposite);
        let second = self.expr(otherwise);
        self.leave_branch(before);
        self.select(branch, condition, first, second)
    }

    /// `if condition { first } else { second }`, element by element.
    pub(super) fn select(&mut self, syntax: &ExprIf, condition: Id, first: Value, second: Value) -> Value {
        use Value::{List, Opaque, Poison, Real, Truth, Tuple, Vector};
        match (first, second) {
            (Poison, _) | (_, Poison) => Poison,
            (a @ (Real(_) | Opaque(_)), b @ (Real(_) | Opaque(_))) => {
                let (a, b) = (self.real(syntax, a), self.real(syntax, b));
                Real(self.graph.select(condition, a, b))
            }
            (Vector(a), Vector(b)) if a.len() == b.len() => {
                Vector(a.iter().zip(&b).map(|(a, b)| self.graph.select(condition, *a, *b)).collect())
            }
            (List(a), List(b)) if a.len() == b.len() => {
                let pairs = a.iter().cloned().zip(b.iter().cloned());
                Value::list(pairs.map(|(a, b)| self.select(syntax, condition, a, b)).collect())
            }
            (Tuple(a), Tuple(b)) if a.len() == b.len() => {
                Tuple(a.into_iter().zip(b).map(|(a, b)| self.select(syntax, condition, a, b)).collect())
            }
            (Truth(a), Truth(b)) => {
                let graph = &mut self.graph;
                let (yes, no) = (graph.and(condition, a), graph.not(condition));
                let no = graph.and(no, b);
                Truth(graph.or(yes, no))
            }
            (a, b) => self.refuse(
                &syntax.if_token,
                format!("both sides of an `if` are numbers; here one is {} and the other {}", a.kind(), b.kind()),
            ),
        }
    }
}
