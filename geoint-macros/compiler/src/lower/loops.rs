//! Loops are unrolled. `continue` and `break` end a round or the loop.

use super::value::Value;
use super::{Lowering, MAX_EVALUATIONS, MAX_NODES};
use crate::messages::BY_HAND;
use quote::ToTokens;
use syn::{ExprForLoop, Lifetime};

/// A loop around the current expression.
pub(super) struct Loop {
    label: Option<Lifetime>,
    /// Number of branches around the loop.
    branches: usize,
}

/// A pending `continue` or `break`.
#[derive(Clone, Copy)]
pub(super) struct Leaving {
    /// Number of loops around the target loop.
    depth: usize,
    exit: Exit,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Exit {
    Continue,
    Break,
}

impl Lowering {
    pub(super) fn for_loop(&mut self, for_loop: &ExprForLoop) -> Value {
        let domain = self.expr(&for_loop.expr);
        let Some(items) = self.list(&for_loop.expr, domain) else { return Value::Poison };
        let (errors, depth) = (self.errors.len(), self.loops.len());
        let label = for_loop.label.as_ref().map(|label| label.name.clone());
        self.loops.push(Loop { label, branches: self.conditions.len() });
        for item in items.iter() {
            // Further rounds would repeat an error.
            if self.errors.len() > errors || self.exhausted(&for_loop.for_token) {
                break;
            }
            self.scopes.enter();
            self.bind(&for_loop.pat, item.clone());
            self.block(&for_loop.body);
            self.scopes.leave();
            match self.leaving {
                Some(leaving) if leaving.depth < depth => break,
                Some(leaving) => {
                    self.leaving = None;
                    if leaving.exit == Exit::Break {
                        break;
                    }
                }
                None => {}
            }
        }
        self.loops.pop();
        Value::unit()
    }

    /// Evaluates `continue` or `break`.
    pub(super) fn leave(&mut self, syntax: &impl ToTokens, label: Option<&Lifetime>, exit: Exit) -> Value {
        let depth = match label {
            Some(label) => self.loops.iter().rposition(|around| around.label.as_ref() == Some(label)),
            None => self.loops.len().checked_sub(1),
        };
        let Some(depth) = depth else { return self.refuse(syntax, "only a `for` loop can be left") };
        if self.loops[depth].branches != self.conditions.len() {
            return self.refuse(
                syntax,
                "loops are unrolled, so that data cannot decide how long they are: make what follows the value of a branch, \
                 as in `x += if … { … } else { 0.0 }`",
            );
        }
        self.leaving = Some(Leaving { depth, exit });
        Value::Poison
    }

    /// Returns whether a `continue` or `break` is pending.
    pub(super) fn is_leaving(&self) -> bool {
        self.leaving.is_some()
    }

    /// Returns whether unrolled loops and inlined calls exceed a limit. Reports the limit once.
    pub(super) fn exhausted(&mut self, syntax: &impl ToTokens) -> bool {
        let exhausted = self.graph.len() > MAX_NODES || self.evaluations > MAX_EVALUATIONS;
        if exhausted && !self.is_exhausted {
            self.is_exhausted = true;
            self.refuse(
                syntax,
                format!(
                    "this unrolls to more than {MAX_NODES} operations, which rustc could not compile in good time; larger systems are \
                     written by hand, see {BY_HAND}"
                ),
            );
        }
        exhausted
    }
}
