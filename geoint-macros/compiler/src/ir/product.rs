//! Constructors of products, quotients and powers. Equal bases are merged, and products are never expanded.

use super::graph::Graph;
use super::id::Id;
use super::node::Node;
use super::number::{Number, Ratio};

impl Graph {
    /// Splits a node into coefficient·rest.
    pub(crate) fn coefficient(&self, id: Id) -> (Number, Id) {
        match self.node(id) {
            Node::Linear(constant, terms) if constant.is_zero() && terms.len() == 1 => terms[0],
            _ => (Number::ONE, id),
        }
    }

    /// Returns the bases and exponents of a product and of the products nested in it.
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

    /// Builds a·b. Powers of a base that both sides share are merged. Other products stay nested as they were written, so a product that other
    /// expressions use as well is computed once.
    pub(crate) fn mul(&mut self, a: Id, b: Id) -> Id {
        if let Some(c) = self.as_number(a) {
            return self.scale(c, b);
        }
        if let Some(c) = self.as_number(b) {
            return self.scale(c, a);
        }
        let ((ca, a), (cb, b)) = (self.coefficient(a), self.coefficient(b));
        let (left, right) = (self.factors(a), self.factors(b));
        let product = if let Some(factors) = with_shared_base(a, &left, b, &right) {
            self.merged(factors)
        } else if let Some((sign, factors)) = self.with_opposite_sum(&left, &right) {
            let product = self.merged(factors);
            self.scale(sign, product)
        } else {
            self.intern(Node::Product(if a < b { vec![a, b] } else { vec![b, a] }))
        };
        self.scale(ca.mul(cb), product)
    }

    /// Returns the sign and factors of a product in which sums on the left have their opposite on the right: (b − a)(a − b)² is −(a − b)³.
    fn with_opposite_sum(&self, left: &[(Id, Ratio)], right: &[(Id, Ratio)]) -> Option<(Number, Vec<(Id, Ratio)>)> {
        let opposite = |(base, exponent): &(Id, Ratio)| {
            let (opposite, _) = right.iter().find(|(other, _)| self.is_opposite(*base, *other))?;
            exponent.is_integer().then_some(*opposite)
        };
        // Most products have none.
        if !left.iter().any(|factor| opposite(factor).is_some()) {
            return None;
        }
        let (mut sign, mut factors) = (Number::ONE, left.to_vec());
        for factor in &mut factors {
            if let Some(base) = opposite(factor) {
                factor.0 = base;
                if factor.1.numerator % 2 != 0 {
                    sign = sign.neg();
                }
            }
        }
        factors.extend(right);
        Some((sign, factors))
    }

    /// Returns whether two sums are opposite term by term.
    fn is_opposite(&self, a: Id, b: Id) -> bool {
        match (self.node(a), self.node(b)) {
            (Node::Linear(c, left), Node::Linear(d, right)) => {
                let opposite = |(a, b): (&(Number, Id), &(Number, Id))| a.1 == b.1 && a.0 == b.0.neg();
                *c == d.neg() && left.len() == right.len() && left.iter().zip(right).all(opposite)
            }
            _ => false,
        }
    }

    /// Builds the product of powers with equal bases merged.
    fn merged(&mut self, mut factors: Vec<(Id, Ratio)>) -> Id {
        factors.sort_by_key(|(base, _)| *base);
        let mut powers: Vec<(Id, Ratio)> = vec![];
        for (base, exponent) in factors {
            match powers.last_mut() {
                Some((last, e)) if *last == base => {
                    // Exponents are small. If their sum overflows, the factors stay apart.
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

    /// Builds the product of all nodes, from left to right.
    pub(crate) fn product(&mut self, ids: &[Id]) -> Id {
        let [first, rest @ ..] = ids else { return self.integer(1) };
        rest.iter().fold(*first, |product, id| self.mul(product, *id))
    }

    /// Builds 1/a.
    pub(crate) fn recip(&mut self, a: Id) -> Id {
        self.pow(a, Ratio::integer(-1))
    }

    /// Builds a/b.
    pub(crate) fn div(&mut self, a: Id, b: Id) -> Id {
        let b = self.recip(b);
        self.mul(a, b)
    }

    /// Builds √a.
    pub(crate) fn sqrt(&mut self, a: Id) -> Id {
        self.pow(a, Ratio::HALF)
    }

    /// Builds baseᵉ for an exponent that is an integer or half of an integer.
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
            // (xʳ)ᵉ = xʳᵉ, except for an even r and a half-integral e: √(x²) is |x|.
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
            // (b − a)² and (a − b)² are one node, and so are (b − a)³ and −(a − b)³. A reciprocal keeps its sign, because messages name its pole as
            // the user wrote it.
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

/// Returns the factors of a·b if both sides share a base. A side that is itself a base of the other side stays whole.
fn with_shared_base(a: Id, left: &[(Id, Ratio)], b: Id, right: &[(Id, Ratio)]) -> Option<Vec<(Id, Ratio)>> {
    let contains = |factors: &[(Id, Ratio)], id: Id| factors.iter().any(|(base, _)| *base == id);
    let (whole_a, whole_b) = ([(a, Ratio::ONE)], [(b, Ratio::ONE)]);
    let left = if contains(right, a) { &whole_a[..] } else { left };
    let right = if contains(left, b) { &whole_b[..] } else { right };
    right.iter().any(|(base, _)| contains(left, *base)).then(|| [left, right].concat())
}
