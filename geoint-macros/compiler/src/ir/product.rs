//! Products, quotients and powers: one node for every base, never expanded.

use super::graph::Graph;
use super::id::Id;
use super::node::Node;
use super::number::Number;
use super::number::Ratio;

impl Graph {
    /// A node as coefficient·rest.
    pub(crate) fn coefficient(&self, id: Id) -> (Number, Id) {
        match self.node(id) {
            Node::Linear(constant, terms) if constant.is_zero() && terms.len() == 1 => terms[0],
            _ => (Number::ONE, id),
        }
    }

    /// Bases and exponents of a product, however nested.
    pub(crate) fn factors(&self, id: Id) -> Vec<(Id, Ratio)> {
        let mut factors = vec![];
        self.push_factors(id, &mut factors);
        factors
    }

    fn push_factors(&self, id: Id, factors: &mut Vec<(Id, Ratio)>) {
        match self.node(id) {
            Node::Product(ids) => {
                for id in ids.iter().rev() {
                    self.push_factors(*id, factors);
                }
            }
            Node::Power(base, exponent) => factors.push((*base, *exponent)),
            _ => factors.push((id, Ratio::ONE)),
        }
    }

    /// Whether a node, or something that it is a product or power of, is one of others.
    fn is_made_of(&self, id: Id, others: &[Id]) -> bool {
        for other in others {
            if *other == id {
                return true;
            }
        }
        match self.node(id) {
            Node::Product(ids) => {
                for id in ids {
                    if self.is_made_of(*id, others) {
                        return true;
                    }
                }
                false
            }
            Node::Power(base, _) => others.contains(base),
            _ => false,
        }
    }

    /// Whether two nodes may have a base in common.
    fn may_meet(&self, a: Id, b: Id) -> bool {
        match self.node(a) {
            Node::Product(_) => {
                let mut bases = vec![a];
                self.push_bases(a, &mut bases);
                self.is_made_of(b, &bases)
            }
            Node::Power(base, _) => self.is_made_of(b, &[a, *base]),
            _ => self.is_made_of(b, &[a]),
        }
    }

    fn push_bases(&self, id: Id, bases: &mut Vec<Id>) {
        match self.node(id) {
            Node::Product(ids) => {
                for id in ids {
                    self.push_bases(*id, bases);
                }
            }
            Node::Power(base, _) => bases.push(*base),
            _ => bases.push(id),
        }
    }

    /// a·b. Stays nested as it was written (a product that others use as well is computed once), unless some base
    /// meets an equal one: then powers are merged.
    pub(crate) fn mul(&mut self, a: Id, b: Id) -> Id {
        if let Node::Number(c) = *self.node(a) {
            return self.scale(c, b);
        }
        if let Node::Number(c) = *self.node(b) {
            return self.scale(c, a);
        }
        let ((ca, a), (cb, b)) = (self.coefficient(a), self.coefficient(b));
        let merged = if self.may_meet(a, b) { self.met(a, b) } else { self.met_opposite(a, b) };
        let product = merged.unwrap_or_else(|| self.intern(Node::Product(if a < b { vec![a, b] } else { vec![b, a] })));
        self.scale(ca.mul(cb), product)
    }

    /// a·b with merged powers, if some base meets an equal one.
    fn met(&mut self, a: Id, b: Id) -> Option<Id> {
        let (mut left, mut right) = (self.factors(a), self.factors(b));
        // A product that is the base of the other side's power meets it as a whole.
        if right.iter().any(|(base, _)| *base == a) {
            left = vec![(a, Ratio::ONE)];
        }
        if left.iter().any(|(base, _)| *base == b) {
            right = vec![(b, Ratio::ONE)];
        }
        let meets = right.iter().any(|(base, _)| left.iter().any(|(other, _)| other == base));
        meets.then(|| self.merged(left.into_iter().chain(right).collect()))
    }

    /// a·b with merged powers, if a sum meets its opposite: (b − a)(a − b)² is −(a − b)³.
    fn met_opposite(&mut self, a: Id, b: Id) -> Option<Id> {
        if !self.any_sum(a, &|left| self.any_sum(b, &|right| self.is_opposite(left, right))) {
            return None;
        }
        let (mut left, right) = (self.factors(a), self.factors(b));
        let mut coefficient = None;
        for (base, exponent) in left.iter_mut().filter(|(_, exponent)| exponent.is_integer()) {
            if let Some((opposite, _)) = right.iter().find(|(other, _)| self.is_opposite(*base, *other)) {
                let sign = if exponent.numerator % 2 == 0 { Number::ONE } else { Number::ONE.neg() };
                coefficient = Some(sign.mul(coefficient.unwrap_or(Number::ONE)));
                *base = *opposite;
            }
        }
        let coefficient = coefficient?;
        let product = self.merged(left.into_iter().chain(right).collect());
        Some(self.scale(coefficient, product))
    }

    /// Whether that holds of some sum among the bases of a product.
    fn any_sum(&self, id: Id, holds: &dyn Fn(Id) -> bool) -> bool {
        match self.node(id) {
            Node::Linear(..) => holds(id),
            Node::Power(base, _) => matches!(self.node(*base), Node::Linear(..)) && holds(*base),
            Node::Product(ids) => {
                for id in ids {
                    if self.any_sum(*id, holds) {
                        return true;
                    }
                }
                false
            }
            _ => false,
        }
    }

    fn is_opposite(&self, a: Id, b: Id) -> bool {
        match (self.node(a), self.node(b)) {
            (Node::Linear(c, left), Node::Linear(d, right)) => {
                let opposite = |(a, b): (&(Number, Id), &(Number, Id))| a.1 == b.1 && a.0 == b.0.neg();
                *c == d.neg() && left.len() == right.len() && left.iter().zip(right).all(opposite)
            }
            _ => false,
        }
    }

    fn merged(&mut self, mut factors: Vec<(Id, Ratio)>) -> Id {
        factors.sort_by_key(|(base, _)| *base);
        let mut powers: Vec<(Id, Ratio)> = vec![];
        for (base, exponent) in factors {
            match powers.last_mut() {
                Some((last, e)) if *last == base => {
                    // Exponents are small; should their sum ever overflow, the factors stay apart.
                    match e.add(exponent) {
                        Some(total) => *e = total,
                        None => powers.push((base, exponent)),
                    }
                }
                _ => powers.push((base, exponent)),
            }
        }
        let mut coefficient = Number::ONE;
        let mut ids = vec![];
        for (base, exponent) in powers {
            let power = self.pow(base, exponent);
            match self.as_number(power) {
                Some(c) => coefficient = coefficient.mul(c),
                None => {
                    let (c, power) = self.coefficient(power);
                    coefficient = coefficient.mul(c);
                    ids.push(power);
                }
            }
        }
        ids.sort();
        let product = match ids[..] {
            [] => return self.number(coefficient),
            [id] => id,
            _ => self.intern(Node::Product(ids)),
        };
        self.scale(coefficient, product)
    }

    pub(crate) fn product(&mut self, ids: &[Id]) -> Id {
        let [first, rest @ ..] = ids else { return self.integer(1) };
        let mut product = *first;
        for id in rest {
            product = self.mul(product, *id);
        }
        product
    }

    pub(crate) fn recip(&mut self, a: Id) -> Id {
        self.pow(a, Ratio::integer(-1))
    }

    pub(crate) fn div(&mut self, a: Id, b: Id) -> Id {
        let b = self.recip(b);
        self.mul(a, b)
    }

    pub(crate) fn sqrt(&mut self, a: Id) -> Id {
        self.pow(a, Ratio::HALF)
    }

    /// baseᵉ for an exponent that is an integer or half of one.
    pub(crate) fn pow(&mut self, base: Id, exponent: Ratio) -> Id {
        if exponent.numerator == 0 {
            return self.integer(1);
        }
        if exponent == Ratio::ONE {
            return base;
        }
        match self.node(base).clone() {
            Node::Number(value) => {
                if let Some(power) = value.pow(exponent) {
                    return self.number(power);
                }
            }
            // (xʳ)ᵉ = xʳᵉ unless a sign was lost on the way: √(x²) is |x|.
            Node::Power(inner, r) if exponent.is_integer() || !r.is_integer() => {
                if let Some(total) = r.mul(exponent).filter(|total| total.denominator <= 2) {
                    return self.pow(inner, total);
                }
            }
            Node::Linear(constant, terms) if constant.is_zero() && terms.len() == 1 => {
                let (c, rest) = terms[0];
                if exponent.is_integer()
                    && let Some(c) = c.pow(exponent)
                {
                    let power = self.pow(rest, exponent);
                    return self.scale(c, power);
                }
            }
            // (b − a)² and (a − b)² are one node, and so are (b − a)³ and −(a − b)³. A pole is called as it was written.
            Node::Linear(..) if exponent.is_integer() && exponent.numerator != -1 && self.leads_negative(base) => {
                let positive = self.negated_sum(base);
                let power = self.pow(positive, exponent);
                return if exponent.numerator % 2 == 0 { power } else { self.neg(power) };
            }
            _ => {}
        }
        self.intern(Node::Power(base, exponent))
    }
}
