//! A product with a sum as a sum of products.

use super::polynomial::factors;
use crate::analyze;
use crate::ir::{Graph, Id, Node, Ratio};

/// Powers of sums are taken apart up to this one.
const MAX_POWER: i128 = 4;

/// And into so many products at most.
const MAX_PRODUCTS: usize = 1 << 10;

/// A product with a sum, or with a power of one.
struct WithSum {
    sum: Id,
    power: u32,
    others: Id,
}

impl WithSum {
    /// A term as such a product; the sum is one that `apart` picks.
    fn of(graph: &mut Graph, term: Id, apart: impl Fn(&Graph, Id) -> bool) -> Option<WithSum> {
        let (c, rest) = graph.coefficient(term);
        let mut factors = factors(graph, rest);
        let is_sum = |(base, exponent): &(Id, Ratio)| {
            exponent.is_integer()
                && (1..=MAX_POWER).contains(&exponent.numerator)
                && matches!(graph.node(*base), Node::Linear(..))
                && apart(graph, *base)
        };
        let place = factors.iter().position(is_sum)?;
        let (sum, power) = factors.remove(place);
        let mut others = graph.number(c);
        for (base, exponent) in factors {
            let factor = graph.pow(base, exponent);
            others = graph.mul(others, factor);
        }
        Some(WithSum { sum, power: u32::try_from(power.numerator).ok()?, others })
    }

    /// One product for each choice of terms of the sum.
    fn multiplied_out(&self, graph: &mut Graph) -> Option<Vec<Id>> {
        let terms = analyze::terms(graph, self.sum);
        if terms.len() < 2 || terms.len().checked_pow(self.power)? > MAX_PRODUCTS {
            return None;
        }
        let mut products = vec![self.others];
        for _ in 0..self.power {
            let pairs = products.iter().flat_map(|product| terms.iter().map(move |term| (*product, *term)));
            products = pairs.collect::<Vec<_>>().into_iter().map(|(product, term)| graph.mul(product, term)).collect();
        }
        Some(products)
    }
}

/// A product with a sum, or with a power of one, as a sum of products; the sum is one that `apart` picks.
pub(super) fn multiplied_out(graph: &mut Graph, term: Id, apart: impl Fn(&Graph, Id) -> bool) -> Option<Vec<Id>> {
    WithSum::of(graph, term, apart)?.multiplied_out(graph)
}

/// The terms of a sum that `known` knows, and the others. A product of what it knows and a sum is multiplied out, as in (1 + a/r)/r.
pub(super) fn known_terms<T>(
    graph: &mut Graph,
    root: Id,
    known: impl Fn(&mut Graph, Id) -> Option<T>,
) -> (Vec<T>, Vec<Id>) {
    let (mut found, mut others) = (vec![], vec![]);
    let mut open = analyze::single_terms(graph, root);
    open.reverse();
    while let Some(term) = open.pop() {
        if let Some(term) = known(graph, term) {
            found.push(term);
            continue;
        }
        let product = WithSum::of(graph, term, |graph, sum| graph.reads(sum).state());
        let product = product.filter(|product| known(graph, product.others).is_some());
        match product.and_then(|product| product.multiplied_out(graph)) {
            Some(products) => open.extend(products.into_iter().rev()),
            None => others.push(term),
        }
    }
    (found, others)
}
