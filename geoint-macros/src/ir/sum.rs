//! Sums: a constant and terms with coefficients, equal terms merged.

use super::graph::{Graph, Node};
use super::id::Id;
use super::number::Number;

impl Graph {
    /// A node as constant + Σ coefficient·term, where a sum with several terms may be taken apart or be one term.
    fn terms(&self, id: Id, apart: bool) -> (Number, Vec<(Number, Id)>) {
        match self.node(id) {
            Node::Number(value) => (*value, vec![]),
            Node::Linear(constant, terms) if apart || (terms.len() == 1 && constant.is_zero()) => {
                (*constant, terms.clone())
            }
            _ => (Number::ZERO, vec![(Number::ONE, id)]),
        }
    }

    /// a + b. A sum on the left is continued; one on the right stays together as it was written, unless some term of it
    /// meets an equal one.
    pub(crate) fn add(&mut self, a: Id, b: Id) -> Id {
        let left = self.terms(a, a != b);
        let right = self.terms(b, false);
        let apart = self.terms(b, true);
        let meets = apart.1.iter().any(|(_, t)| left.1.iter().any(|(_, s)| s == t));
        let right = if meets { apart } else { right };
        self.linear(left.0.add(right.0), left.1.into_iter().chain(right.1).collect())
    }

    pub(crate) fn neg(&mut self, a: Id) -> Id {
        self.scale(Number::MINUS_ONE, a)
    }

    pub(crate) fn sub(&mut self, a: Id, b: Id) -> Id {
        if a == b {
            return self.zero();
        }
        // Sums that share a term are taken apart.
        let (left, right) = (self.terms(a, true), self.terms(b, true));
        if right.1.iter().any(|(_, t)| left.1.iter().any(|(_, s)| s == t)) {
            let negated = right.1.into_iter().map(|(c, t)| (c.neg(), t));
            return self.linear(left.0.add(right.0.neg()), left.1.into_iter().chain(negated).collect());
        }
        let b = self.neg(b);
        self.add(a, b)
    }

    /// Σ of all, equal ones merged.
    pub(crate) fn sum(&mut self, ids: &[Id]) -> Id {
        let mut constant = Number::ZERO;
        let mut all = vec![];
        for id in ids {
            let (c, terms) = self.terms(*id, false);
            constant = constant.add(c);
            all.extend(terms);
        }
        self.linear(constant, all)
    }

    /// c·a.
    pub(crate) fn scale(&mut self, c: Number, a: Id) -> Id {
        if c == Number::ONE {
            return a;
        }
        let (constant, terms) = self.terms(a, false);
        self.linear(constant.mul(c), terms.into_iter().map(|(k, t)| (k.mul(c), t)).collect())
    }

    /// constant + Σ coefficient·term, from terms that are not numbers.
    pub(crate) fn linear(&mut self, constant: Number, mut terms: Vec<(Number, Id)>) -> Id {
        terms.sort_by_key(|(_, id)| *id);
        terms.dedup_by(|next, kept| {
            let same = next.1 == kept.1;
            if same {
                kept.0 = kept.0.add(next.0);
            }
            same
        });
        terms.retain(|(c, _)| !c.is_zero());
        match terms[..] {
            [] => self.number(constant),
            [(Number::ONE, id)] if constant.is_zero() => id,
            // A number times a sum times a number.
            [(c, id)] if constant.is_zero() => match self.node(id) {
                Node::Linear(k, inner) if k.is_zero() && inner.len() == 1 => {
                    let (k, id) = inner[0];
                    self.linear(Number::ZERO, vec![(c.mul(k), id)])
                }
                _ => self.intern(Node::Linear(constant, terms)),
            },
            _ => self.intern(Node::Linear(constant, terms)),
        }
    }

    /// Whether the first coefficient of a sum, or the only one, is negative.
    pub(super) fn leads_negative(&self, id: Id) -> bool {
        match self.node(id) {
            Node::Linear(_, terms) => terms[0].0.is_negative(),
            Node::Number(value) => value.is_negative(),
            _ => false,
        }
    }

    pub(super) fn negated_sum(&mut self, id: Id) -> Id {
        let (constant, terms) = self.terms(id, true);
        self.linear(constant.neg(), terms.into_iter().map(|(c, t)| (c.neg(), t)).collect())
    }
}
