//! Branches and connectives, whose operands are evaluated under a condition.

use super::Lowering;
use super::value::Value;
use crate::ir::Id;
use syn::{BinOp, ExprBinary, ExprIf};

impl Lowering {
    /// Evaluates `a && b` and `a || b`. The right side is evaluated under the condition that the left side does not decide.
    pub(super) fn connective(&mut self, binary: &ExprBinary) -> Value {
        let left = self.expr(&binary.left);
        let is_or = matches!(binary.op, BinOp::Or(_));
        let condition = match left {
            Value::Truth(id) if self.graph.as_truth(id) == Some(is_or) => return left,
            Value::Truth(id) if is_or => self.graph.not(id),
            Value::Truth(id) => id,
            _ => self.graph.truth(true),
        };
        let right = self.under(condition, |lowering| lowering.expr(&binary.right));
        self.arithmetic(binary, &binary.op, left, right)
    }

    /// Evaluates an `if`.
    pub(super) fn branch(&mut self, branch: &ExprIf) -> Value {
        let condition = match self.expr(&branch.cond) {
            Value::Truth(id) => id,
            Value::Poison => return Value::Poison,
            other => {
                return self.refuse(&branch.cond, format!("a condition compares numbers; this is {}", other.kind()));
            }
        };
        // A condition on loop indices is known. Only one branch is evaluated.
        if let Some(truth) = self.graph.as_truth(condition) {
            return match (&branch.else_branch, truth) {
                (_, true) => self.block(&branch.then_branch),
                (Some((_, other)), false) => self.expr(other),
                (None, false) => Value::unit(),
            };
        }
        let errors = self.errors.len();
        let first = self.under(condition, |lowering| lowering.block(&branch.then_branch));
        let Some((_, otherwise)) = &branch.else_branch else {
            // A branch without a value usually assigns. The message about the assignment is better.
            if self.errors.len() == errors {
                self.refuse(&branch.if_token, "give this `if` an `else`: it must have a value on both sides");
            }
            return Value::Poison;
        };
        let opposite = self.graph.not(condition);
        let second = self.under(opposite, |lowering| lowering.expr(otherwise));
        self.select(branch, condition, first, second)
    }

    /// Returns `if condition { first } else { second }`, element by element.
    fn select(&mut self, syntax: &ExprIf, condition: Id, first: Value, second: Value) -> Value {
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
                Value::list(pairs.map(|(a, b)| self.select(syntax, condition, a, b)))
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
