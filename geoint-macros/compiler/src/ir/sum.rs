//! Sums: a constant and terms with coefficients, equal terms merged.

use super::graph::Graph;
use super::id::Id;
use super::node::Node;
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
        let (constant, mut terms) = self.terms(a, a != b);
        let (c, mut right) = self.terms(b, self.meets(&terms, b));
        terms.append(&mut right);
        self.linear(constant.add(c), terms)
    }

    /// Whether one of some terms is a term of a node.
    fn meets(&self, terms: &[(Number, Id)], id: Id) -> bool {
        let is_there = |id: Id| terms.iter().any(|(_, term)| *term == id);
        match self.node(id) {
            Node::Number(_) => false,
            Node::Linear(_, terms) => terms.iter().any(|(_, term)| is_there(*term)),
            _ => is_there(id),
        }
    }

    pub(crate) fn neg(&mut self, a: Id) -> Id {
        self.scale(Number::MINUS_ONE, a)
    }

    pub(crate) fn sub(&mut self, a: Id, b: Id) -> Id {
        if a == b {
            return self.zero();
        }
        // Sums that share a term are taken apart.
        let (constant, mut terms) = self.terms(a, true);
        if self.meets(&terms, b) {
            let (c, right) = self.terms(b, true);
            terms.extend(right.into_iter().map(|(c, t)| (c.neg(), t)));
            return self.linear(constant.add(c.neg()), terms);
        }
        let b = self.neg(b);
        self.add(a, b)
    }

    /// Σ aᵢ bᵢ.
    pub(crate) fn dot(&mut self, a: &[Id], b: &[Id]) -> Id {
        let products: Vec<Id> = a.iter().zip(b).map(|(a, b)| self.mul(*a, *b)).collect();
        self.sum(&products)
    }

    /// Σ of all, equal ones merged.
    pub(crate) fn sum(&mut self, ids: &[Id]) -> Id {
        let mut constant = Number::ZERO;
        let mut all = vec![];
        for id in ids {
            match self.node(*id) {
                Node::Number(_) | Node::Linear(..) => {
                    let (c, mut terms) = self.terms(*id, false);
                    constant = constant.add(c);
                    all.append(&mut terms);
                }
                _ => all.push((Number::ONE, *id)),
            }
        }
        self.linear(constant, all)
    }

    /// constant + Σ coefficient·node.
    pub(super) fn scaled_sum(&mut self, constant: Number, scaled: &[(Number, Id)]) -> Id {
        let mut constant = constant;
        let mut all = vec![];
        for (c, id) in scaled {
            match self.node(*id) {
                Node::Number(_) | Node::Linear(..) => {
                    let (k, terms) = self.terms(*id, false);
                    constant = constant.add(k.mul(*c));
                    for (k, id) in terms {
                        all.push((k.mul(*c), id));
                    }
                }
                _ => all.push((*c, *id)),
            }
        }
        self.linear(constant, all)
    }

    /// c·a.
    pub(crate) fn scale(&mut self, c: Number, a: Id) -> Id {
        if c.is_one() {
            return a;
        }
        match self.node(a) {
            Node::Number(_) | Node::Linear(..) => {
                let (constant, mut terms) = self.terms(a, false);
                for (k, _) in &mut terms {
                    *k = k.mul(c);
                }
                self.linear(constant.mul(c), terms)
            }
            _ => self.linear(Number::ZERO, vec![(c, a)]),
        }
    }

    /// constant + Σ coefficient·term, from terms that are not numbers.
    pub(crate) fn linear(&mut self, constant: Number, mut terms: Vec<(Number, Id)>) -> Id {
        if !are_in_order(&terms) {
            terms.sort_by_key(|(_, id)| *id);
            terms.dedup_by(|next, kept| {
                let same = next.1 == kept.1;
                if same {
                    kept.0 = kept.0.add(next.0);
                }
                same
            });
            terms.retain(|(c, _)| !c.is_zero());
        }
        match terms.as_slice() {
            [] => self.number(constant),
            [(c, id)] if constant.is_zero() => {
                let (c, id) = (*c, *id);
                if c.is_one() {
                    return id;
                }
                // A number times a sum times a number.
                match self.node(id) {
                    Node::Linear(k, inner) if k.is_zero() && inner.len() == 1 => {
                        let (k, id) = inner[0];
                        self.linear(Number::ZERO, vec![(c.mul(k), id)])
                    }
                    _ => self.intern(Node::Linear(constant, terms)),
                }
            }
            _ => self.intern(Node::Linear(constant, terms)),
        }
    }

    /// Whether the first coefficient of a sum, or the only one, is negative.
    pub(crate) fn leads_negative(&self, id: Id) -> bool {
        match self.node(id) {
            Node::Linear(_, terms) => terms[0].0.is_negative(),
            Node::Number(value) => value.is_negative(),
            _ => false,
        }
    }

    /// −u with the sign in the sum.
    pub(crate) fn negated_sum(&mut self, id: Id) -> Id {
        let (constant, terms) = self.terms(id, true);
        self.linear(constant.neg(), terms.into_iter().map(|(c, t)| (c.neg(), t)).collect())
    }
}

/// Whether terms are as those of nodes: no term twice, in order, and none with the coefficient zero.
fn are_in_order(terms: &[(Number, Id)]) -> bool {
    let mut next = 0;
    for (c, id) in terms {
        if c.is_zero() || id.index() < next {
            return false;
        }
        next = id.index() + 1;
    }
    true
}
