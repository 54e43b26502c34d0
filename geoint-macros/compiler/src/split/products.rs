//! Products: their factors, their quotients, and their expansion into sums. Also products of matrices.

use super::polynomial::{is_free, reads};
use crate::analyze;
use crate::ir::{Graph, Id, Node, Ratio, Symbol};

/// The largest power of a sum that is expanded.
const MAX_POWER: i128 = 4;

/// The largest number of products in an expansion.
const MAX_PRODUCTS: usize = 1 << 10;

/// Returns the factors of a product as bases with exponents. Integer powers of products are separated into their factors.
pub(super) fn factors(graph: &Graph, id: Id) -> Vec<(Id, Ratio)> {
    let within = |(base, exponent): (Id, Ratio)| match graph.node(base) {
        Node::Product(_) if exponent.is_integer() => {
            let inner = factors(graph, base).into_iter();
            let powers: Option<Vec<_>> = inner.map(|(base, inner)| Some((base, inner.mul(exponent)?))).collect();
            powers.unwrap_or_else(|| vec![(base, exponent)])
        }
        _ => vec![(base, exponent)],
    };
    graph.factors(id).into_iter().flat_map(within).collect()
}

/// Multiplies `start` by powers.
pub(super) fn times_factors(graph: &mut Graph, start: Id, factors: impl IntoIterator<Item = (Id, Ratio)>) -> Id {
    factors.into_iter().fold(start, |product, (base, exponent)| {
        let factor = graph.pow(base, exponent);
        graph.mul(product, factor)
    })
}

/// Returns a/b. Common factors are cancelled, because they may be zero.
pub(super) fn quotient(graph: &mut Graph, a: Id, b: Id) -> Id {
    let ((above, a), (below, b)) = (graph.coefficient(a), graph.coefficient(b));
    let (mut remaining, mut divisors) = (factors(graph, a), factors(graph, b));
    remaining.retain(|factor| {
        let common = divisors.iter().position(|divisor| divisor == factor);
        common.map(|i| divisors.swap_remove(i)).is_none()
    });
    let [above, below] = [above, below].map(|c| graph.number(c));
    let dividend = times_factors(graph, above, remaining);
    let divisor = times_factors(graph, below, divisors);
    graph.div(dividend, divisor)
}

/// Returns the product of two square matrices.
pub(super) fn matrix_product(graph: &mut Graph, a: &[Vec<Id>], b: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let column = |j: usize| b.iter().map(|row| row[j]).collect::<Vec<Id>>();
    a.iter().map(|row| (0..b.len()).map(|j| graph.dot(row, &column(j))).collect()).collect()
}

/// A product, separated by whether its factors read a symbol.
pub(super) struct Separated {
    /// The product of the factors that do not read the symbol.
    pub(super) free: Id,
    /// The product of the factors that read the symbol.
    pub(super) reading: Id,
}

/// Separates a product by whether its factors read a symbol.
pub(super) fn separated(graph: &mut Graph, id: Id, symbol: Symbol) -> Separated {
    let (c, rest) = graph.coefficient(id);
    let (mut free, mut reading) = (graph.number(c), graph.integer(1));
    for (base, exponent) in factors(graph, rest) {
        let factor = graph.pow(base, exponent);
        let side = if reads(graph, factor, symbol) { &mut reading } else { &mut free };
        *side = graph.mul(*side, factor);
    }
    Separated { free, reading }
}

/// A product coefficient·base^exponent in which only the base reads the selected symbols.
pub(super) struct ScaledPower {
    pub(super) coefficient: Id,
    pub(super) base: Id,
    pub(super) exponent: Ratio,
}

impl ScaledPower {
    /// Returns a product in this form if exactly one of its factors reads symbols that `counts` selects.
    pub(super) fn of(graph: &mut Graph, id: Id, counts: &impl Fn(Symbol) -> bool) -> Option<ScaledPower> {
        let (c, rest) = graph.coefficient(id);
        let (free, reading): (Vec<_>, Vec<_>) =
            factors(graph, rest).into_iter().partition(|(base, _)| is_free(graph, *base, counts));
        let [(base, exponent)] = reading[..] else { return None };
        let c = graph.number(c);
        Some(ScaledPower { coefficient: times_factors(graph, c, free), base, exponent })
    }
}

/// A product others·sumⁿ.
struct WithSum {
    sum: Id,
    power: u32,
    others: Id,
}

impl WithSum {
    /// Returns a term as such a product with the first sum that `apart` selects.
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
        let c = graph.number(c);
        Some(WithSum { sum, power: u32::try_from(power.numerator).ok()?, others: times_factors(graph, c, factors) })
    }

    /// Returns one product for each choice of terms of the sum.
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

/// Expands a product with a sum, or with a power of a sum, into the terms of a sum. `apart` selects the sum.
pub(super) fn multiplied_out(graph: &mut Graph, term: Id, apart: impl Fn(&Graph, Id) -> bool) -> Option<Vec<Id>> {
    WithSum::of(graph, term, apart)?.multiplied_out(graph)
}

/// Separates the terms of a sum into results of `known` and the terms without a result. If `known` has a result for the other factors of a
/// product with a sum, the product is expanded first. An example is (1 + a/r)/r.
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
