//! Factors sums whose terms share factors: a·x + a·y = a·(x + y) takes one multiplication of series in place of two.
//!
//! The nodes of the rates stay unchanged, because other methods emit them in their order.

use super::Builder;
use crate::ir::{Id, Node, Number, Ratio};

/// The factors of a product that move, repeated by multiplicity.
type Factors = Vec<(Id, Ratio)>;

impl Builder<'_> {
    /// Factors the terms of a sum as long as two terms share a factor.
    pub(super) fn factored(&mut self, mut terms: Vec<(Number, Id)>) -> Vec<(Number, Id)> {
        while let Some(next) = self.with_common_factor(&terms) {
            terms = next;
        }
        terms
    }

    /// Joins squares with equal factors that are read nowhere else: a sum of squares is one sum over coefficients. Terms are pairs (factor, node).
    pub(super) fn with_squares_together(&mut self, terms: Vec<(Id, Id)>) -> Vec<(Id, Id)> {
        let mut rest: Vec<(Id, Id)> = vec![];
        let mut together: Vec<(Id, Vec<Id>)> = vec![];
        for (factor, moving) in terms {
            if self.own_square(moving).is_none() {
                rest.push((factor, moving));
                continue;
            }
            match together.iter_mut().find(|(other, _)| *other == factor) {
                Some((_, squares)) => squares.push(moving),
                None => together.push((factor, vec![moving])),
            }
        }
        rest.extend(together.into_iter().map(|(factor, squares)| (factor, self.graph.sum(&squares))));
        rest
    }

    /// The bases of a square or of a sum of squares. Returns `None` if a square is read elsewhere.
    pub(super) fn own_squares(&mut self, id: Id) -> Option<Vec<Id>> {
        match self.graph.node(id).clone() {
            Node::Linear(_, terms) => {
                let is_one = |(c, term): (Number, Id)| (c == Number::ONE).then_some(term);
                terms.into_iter().map(|term| self.own_square(is_one(term)?)).collect()
            }
            _ => Some(vec![self.own_square(id)?]),
        }
    }

    /// The base of a square that is read nowhere else.
    fn own_square(&mut self, id: Id) -> Option<Id> {
        let shared = self.uses.get(&id).is_some_and(|uses| *uses > 1) || self.sources.contains_key(&id);
        match *self.graph.node(id) {
            Node::Power(base, exponent) if exponent == Ratio::integer(2) && !shared => {
                (!self.is_constant(base) && self.slope(base).is_none()).then_some(base)
            }
            _ => None,
        }
    }

    /// Writes the terms that contain the most frequent factor as one product. Returns `None` if no two terms share a factor.
    fn with_common_factor(&mut self, terms: &[(Number, Id)]) -> Option<Vec<(Number, Id)>> {
        let all: Vec<Option<Factors>> = terms.iter().map(|(_, term)| self.own_factors(*term)).collect();
        let has =
            |factors: &Option<Factors>, factor: &(Id, Ratio)| factors.as_ref().is_some_and(|own| own.contains(factor));
        let number = |factor: &(Id, Ratio)| all.iter().filter(|factors| has(factors, factor)).count();
        let mut most: Option<((Id, Ratio), usize)> = None;
        for factor in all.iter().flatten().flatten() {
            let number = number(factor);
            if number > most.map_or(1, |(_, number)| number) {
                most = Some((*factor, number));
            }
        }
        let (factor, _) = most?;
        let (mut rest, mut inner, mut common) = (vec![], vec![], None::<Factors>);
        for (factors, (c, term)) in all.into_iter().zip(terms) {
            match factors.filter(|own| own.contains(&factor)) {
                Some(own) => {
                    common = Some(common.map_or_else(|| own.clone(), |common| shared(&common, &own)));
                    inner.push((*c, own, *term));
                }
                None => rest.push((*c, *term)),
            }
        }
        let common = common?;
        let mut sum = self.graph.zero();
        for (c, own, term) in inner {
            let (scale, term) = self.graph.coefficient(term);
            let mut left = self.graph.number(c.mul(scale));
            // Keep constant factors, and moving factors outside of the common ones.
            let mut taken = common.clone();
            for (base, exponent) in self.graph.factors(term) {
                for part in parts(base, exponent) {
                    if let Some(place) = taken.iter().position(|other| *other == part && own.contains(&part)) {
                        taken.swap_remove(place);
                        continue;
                    }
                    let part = self.graph.pow(part.0, part.1);
                    left = self.graph.mul(left, part);
                }
            }
            sum = self.graph.add(sum, left);
        }
        // If the sum in brackets cancels or is constant, nothing is gained.
        if self.is_constant(sum) {
            return None;
        }
        let mut product = sum;
        for (base, exponent) in common {
            let part = self.graph.pow(base, exponent);
            product = self.graph.mul(product, part);
        }
        let (c, product) = self.graph.coefficient(product);
        rest.push((c, product));
        Some(rest)
    }

    /// The moving factors of a product that is read once. Returns `None` if there are fewer than two.
    fn own_factors(&mut self, term: Id) -> Option<Factors> {
        let shared = self.uses.get(&term).is_some_and(|uses| *uses > 1);
        let all = self.graph.factors(self.graph.coefficient(term).1);
        let moving: Factors = all
            .into_iter()
            .filter(|(base, _)| !self.is_constant(*base))
            .flat_map(|(base, exponent)| parts(base, exponent))
            .collect();
        (!shared && moving.len() > 1).then_some(moving)
    }
}

/// Splits a small integer power into single factors.
fn parts(base: Id, exponent: Ratio) -> Vec<(Id, Ratio)> {
    let times = exponent.numerator.unsigned_abs();
    if exponent.is_integer() && (1..=4).contains(&times) {
        return vec![(base, Ratio::integer(exponent.numerator.signum())); times as usize];
    }
    vec![(base, exponent)]
}

/// The common factors of both, with multiplicity.
fn shared(a: &Factors, b: &Factors) -> Factors {
    let mut left = b.clone();
    let taken = a.iter().filter(|factor| {
        let place = left.iter().position(|other| other == *factor);
        place.map(|place| left.swap_remove(place)).is_some()
    });
    taken.copied().collect()
}
