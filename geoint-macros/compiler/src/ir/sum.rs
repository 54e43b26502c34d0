//! Constructors of sums: a constant and terms with coefficients. Equal terms are merged.

use super::graph::Graph;
use super::id::Id;
use super::node::Node;
use super::number::Number;

impl Graph {
    /// Splits a node into constant + Σ coefficient·term.
    fn addends(&self, id: Id) -> (Number, Vec<(Number, Id)>) {
        match self.node(id) {
            Node::Number(value) => (*value, vec![]),
            Node::Linear(constant, terms) => (*constant, terms.clone()),
            _ => (Number::ZERO, vec![(Number::ONE, id)]),
        }
    }

    /// Builds a + b. The left sum is continued. The right sum stays one term, as it was written, unless it shares a term with the left sum.
    pub(crate) fn add(&mut self, a: Id, b: Id) -> Id {
        if a == b {
            return self.scale(Number::integer(2), a);
        }
        let (constant, mut terms) = self.addends(a);
        if self.shares_term(&terms, b) || self.as_number(b).is_some() {
            let (c, right) = self.addends(b);
            terms.extend(right);
            return self.linear(constant.add(c), terms);
        }
        terms.push(self.coefficient(b));
        self.linear(constant, terms)
    }

    /// Returns whether one of `terms` is a term of a node.
    fn shares_term(&self, terms: &[(Number, Id)], id: Id) -> bool {
        let contains = |id: Id| terms.iter().any(|(_, term)| *term == id);
        match self.node(id) {
            Node::Number(_) => false,
            Node::Linear(_, terms) => terms.iter().any(|(_, term)| contains(*term)),
            _ => contains(id),
        }
    }

    /// Builds −a.
    pub(crate) fn neg(&mut self, a: Id) -> Id {
        self.scale(Number::MINUS_ONE, a)
    }

    /// Builds a − b. Terms that both sums share are merged.
    pub(crate) fn sub(&mut self, a: Id, b: Id) -> Id {
        if a == b {
            return self.zero();
        }
        let (constant, mut terms) = self.addends(a);
        if self.shares_term(&terms, b) {
            let (c, right) = self.addends(b);
            terms.extend(right.into_iter().map(|(c, t)| (c.neg(), t)));
            return self.linear(constant.add(c.neg()), terms);
        }
        let b = self.neg(b);
        self.add(a, b)
    }

    /// Builds Σ aᵢ bᵢ.
    pub(crate) fn dot(&mut self, a: &[Id], b: &[Id]) -> Id {
        let products: Vec<Id> = a.iter().zip(b).map(|(a, b)| self.mul(*a, *b)).collect();
        self.sum(&products)
    }

    /// Builds the sum of all nodes. Equal nodes are merged.
    pub(crate) fn sum(&mut self, ids: &[Id]) -> Id {
        let ids: Vec<(Number, Id)> = ids.iter().map(|id| (Number::ONE, *id)).collect();
        self.scaled_sum(Number::ZERO, &ids)
    }

    /// Builds constant + Σ coefficient·node. The nodes may be numbers or scaled nodes; nested sums stay one term.
    pub(super) fn scaled_sum(&mut self, mut constant: Number, scaled: &[(Number, Id)]) -> Id {
        let mut terms = vec![];
        for (c, id) in scaled {
            match self.as_number(*id) {
                Some(number) => constant = constant.add(number.mul(*c)),
                None => {
                    let (own, rest) = self.coefficient(*id);
                    terms.push((own.mul(*c), rest));
                }
            }
        }
        self.linear(constant, terms)
    }

    /// Builds c·a.
    pub(crate) fn scale(&mut self, c: Number, a: Id) -> Id {
        if c.is_one() { a } else { self.scaled_sum(Number::ZERO, &[(c, a)]) }
    }

    /// Builds constant + Σ coefficient·term. Precondition: no term is a number.
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
        match terms[..] {
            [] => self.number(constant),
            [(c, id)] if constant.is_zero() && c.is_one() => id,
            [(c, id)] if constant.is_zero() => match self.coefficient(id) {
                (_, rest) if rest == id => self.intern(Node::Linear(constant, terms)),
                // The term is a scaled node: c·(k·rest).
                (k, rest) => self.linear(Number::ZERO, vec![(c.mul(k), rest)]),
            },
            _ => self.intern(Node::Linear(constant, terms)),
        }
    }

    /// Returns whether the first coefficient of a sum, or the number, is negative.
    pub(crate) fn leads_negative(&self, id: Id) -> bool {
        match self.node(id) {
            Node::Linear(_, terms) => terms[0].0.is_negative(),
            Node::Number(value) => value.is_negative(),
            _ => false,
        }
    }

    /// Builds −a with the sign moved into the terms of the sum.
    pub(crate) fn negated_sum(&mut self, id: Id) -> Id {
        let (constant, terms) = self.addends(id);
        self.linear(constant.neg(), terms.into_iter().map(|(c, t)| (c.neg(), t)).collect())
    }
}

/// Returns whether terms are in the form of nodes: sorted, no term twice, and no coefficient zero.
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
