//! An expression as a sum of powers of some of its symbols, with coefficients that are free of them.

use crate::analyze;
use crate::diff;
use crate::ir::{Graph, Id, Node, Ratio, Symbol, Table};
use std::collections::BTreeMap;

/// Which symbols to which powers; those to the power 0 left out.
pub(super) type Monomial = BTreeMap<Symbol, Ratio>;

/// Σ coefficient·monomial. Powers may be negative, or half of an odd number.
#[derive(Clone, Debug)]
pub(super) struct Polynomial(BTreeMap<Key, (Monomial, Id)>);

/// A monomial in an order of its own.
type Key = Vec<(Symbol, (i128, i128))>;

/// Products of sums have this many terms at most.
const MAX_TERMS: usize = 64;

impl Polynomial {
    /// `root` as powers of the symbols that `counts` picks, if it is such a sum.
    pub(super) fn of(graph: &mut Graph, root: Id, counts: &impl Fn(Symbol) -> bool) -> Option<Polynomial> {
        // Most expressions are none, and looking costs less than products do.
        if can_be(graph, root, counts) { Self::found(graph, root, counts) } else { None }
    }

    fn found(graph: &mut Graph, root: Id, counts: &impl Fn(Symbol) -> bool) -> Option<Polynomial> {
        match graph.node(root).clone() {
            Node::Symbol(symbol) if counts(symbol) => {
                let one = graph.integer(1);
                Some(Self::term(Monomial::from([(symbol, Ratio::ONE)]), one))
            }
            _ if is_free(graph, root, counts) => Some(Self::term(Monomial::new(), root)),
            Node::Linear(constant, terms) => {
                let constant = graph.number(constant);
                let mut sum = Self::term(Monomial::new(), constant);
                for (c, term) in terms {
                    for (monomial, coefficient) in Self::found(graph, term, counts)?.0.into_values() {
                        let coefficient = graph.scale(c, coefficient);
                        sum.add(graph, monomial, coefficient);
                    }
                }
                Some(sum.cleaned(graph))
            }
            Node::Product(ids) => {
                let one = graph.integer(1);
                ids.into_iter().try_fold(Self::term(Monomial::new(), one), |product, id| {
                    let factor = Self::found(graph, id, counts)?;
                    product.times(graph, &factor)
                })
            }
            Node::Power(base, exponent) => {
                let base = Self::found(graph, base, counts)?;
                if let Some((monomial, coefficient)) = base.single() {
                    let powers: Option<Monomial> = monomial.iter().map(|(s, r)| Some((*s, r.mul(exponent)?))).collect();
                    // √(x²) is |x|.
                    let signed = exponent.is_integer() || monomial.values().all(|r| !r.is_integer());
                    let plain = monomial.values().all(|r| *r == Ratio::ONE);
                    if signed || plain && is_one(graph, coefficient) {
                        let coefficient = graph.pow(coefficient, exponent);
                        return Some(Self::term(powers?, coefficient));
                    }
                    return None;
                }
                let times = u32::try_from(exponent.numerator).ok().filter(|_| exponent.is_integer())?;
                let one = graph.integer(1);
                (0..times).try_fold(Self::term(Monomial::new(), one), |power, _| power.times(graph, &base))
            }
            _ => None,
        }
    }

    fn term(monomial: Monomial, coefficient: Id) -> Polynomial {
        Polynomial(BTreeMap::from([(key(&monomial), (monomial, coefficient))]))
    }

    fn add(&mut self, graph: &mut Graph, monomial: Monomial, coefficient: Id) {
        let entry = self.0.entry(key(&monomial));
        entry.and_modify(|(_, sum)| *sum = graph.add(*sum, coefficient)).or_insert((monomial, coefficient));
    }

    fn cleaned(mut self, graph: &Graph) -> Polynomial {
        self.0.retain(|_, (_, coefficient)| !graph.is_zero(*coefficient));
        self
    }

    fn times(&self, graph: &mut Graph, other: &Polynomial) -> Option<Polynomial> {
        let mut product = Polynomial(BTreeMap::new());
        for (left, a) in self.0.values() {
            for (right, b) in other.0.values() {
                let mut monomial = left.clone();
                for (symbol, power) in right {
                    let sum = monomial.get(symbol).map_or(Some(*power), |own| own.add(*power))?;
                    monomial.insert(*symbol, sum);
                }
                monomial.retain(|_, power| power.numerator != 0);
                let coefficient = graph.mul(*a, *b);
                product.add(graph, monomial, coefficient);
            }
        }
        (product.0.len() <= MAX_TERMS).then(|| product.cleaned(graph))
    }

    /// The terms: powers and coefficient.
    pub(super) fn terms(&self) -> impl Iterator<Item = (&Monomial, Id)> {
        self.0.values().map(|(monomial, coefficient)| (monomial, *coefficient))
    }

    /// The same, kept for when the graph is written to.
    pub(super) fn into_terms(self) -> impl Iterator<Item = (Monomial, Id)> {
        self.0.into_values()
    }

    /// The only term, if there is just one.
    pub(super) fn single(&self) -> Option<(&Monomial, Id)> {
        let mut terms = self.terms();
        terms.next().filter(|_| terms.next().is_none())
    }

    /// The coefficient of a product of powers; zero if there is no such term.
    pub(super) fn coefficient(&self, graph: &mut Graph, powers: &[(Symbol, i128)]) -> Id {
        let monomial: Monomial = powers.iter().map(|(symbol, power)| (*symbol, Ratio::integer(*power))).collect();
        self.0.get(&key(&monomial)).map_or_else(|| graph.zero(), |(_, coefficient)| *coefficient)
    }

    /// Whether all terms have one of these powers.
    pub(super) fn has_only(&self, allowed: impl Fn(&Monomial) -> bool) -> bool {
        self.terms().all(|(monomial, _)| allowed(monomial))
    }
}

/// Whether nothing but sums, products and powers is between an expression and the symbols. Each node is asked once: sums of sums may share them.
fn can_be(graph: &Graph, root: Id, counts: &impl Fn(Symbol) -> bool) -> bool {
    let mut seen: Table<()> = Table::default();
    let mut open = vec![root];
    while let Some(id) = open.pop() {
        if seen.contains(id) || is_free(graph, id, counts) {
            continue;
        }
        seen.insert(id, ());
        match graph.node(id) {
            Node::Symbol(_) => {}
            node @ (Node::Linear(..) | Node::Product(_) | Node::Power(..)) => {
                node.for_each_child(|child| open.push(child));
            }
            _ => return false,
        }
    }
    true
}

fn key(monomial: &Monomial) -> Key {
    monomial.iter().map(|(symbol, r)| (*symbol, (r.numerator, r.denominator))).collect()
}

fn is_one(graph: &Graph, id: Id) -> bool {
    graph.as_number(id).is_some_and(|x| x.to_f64() == 1.0)
}

/// Whether a node reads none of the symbols.
pub(super) fn is_free(graph: &Graph, root: Id, counts: &impl Fn(Symbol) -> bool) -> bool {
    !graph.reads_any(root, counts)
}

/// a of a·x + b with a and b that are free of x. Derivatives do not show that b is another one beyond a condition that x changes.
pub(super) fn slope_of_line(graph: &mut Graph, line: Id, x: Symbol) -> Option<Id> {
    let slope = diff::partial(graph, line, x);
    let conditions = analyze::conditions(graph, line);
    let steady = |id: &Id| is_free(graph, *id, &|symbol| symbol == x);
    [slope].iter().chain(&conditions).all(steady).then_some(slope)
}

/// coefficient·monomial.
pub(super) fn times_powers(graph: &mut Graph, coefficient: Id, monomial: &Monomial) -> Id {
    monomial.iter().fold(coefficient, |term, (symbol, power)| {
        let symbol = graph.symbol(*symbol);
        let power = graph.pow(symbol, *power);
        graph.mul(term, power)
    })
}

/// The exponents of one symbol in a monomial.
pub(super) fn power(monomial: &Monomial, symbol: Symbol) -> Ratio {
    monomial.get(&symbol).copied().unwrap_or(Ratio::integer(0))
}

/// Bases and exponents of a product, also within powers of products.
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

/// a/b without the factors that both have: they may be zero.
pub(super) fn quotient(graph: &mut Graph, a: Id, b: Id) -> Id {
    let ((above, a), (below, b)) = (graph.coefficient(a), graph.coefficient(b));
    let (mut quotient, mut divisors) = (graph.number(above), factors(graph, b));
    for (base, exponent) in factors(graph, a) {
        match divisors.iter().position(|divisor| *divisor == (base, exponent)) {
            Some(i) => drop(divisors.swap_remove(i)),
            None => {
                let factor = graph.pow(base, exponent);
                quotient = graph.mul(quotient, factor);
            }
        }
    }
    let mut divisor = graph.number(below);
    for (base, exponent) in divisors {
        let factor = graph.pow(base, exponent);
        divisor = graph.mul(divisor, factor);
    }
    graph.div(quotient, divisor)
}

/// The only momentum of a monomial, and its power.
pub(super) fn single_momentum(monomial: &Monomial) -> Option<(u32, Ratio)> {
    let mut momenta = monomial.iter().filter_map(|(symbol, power)| match symbol {
        Symbol::Momentum(i) => Some((*i, *power)),
        _ => None,
    });
    momenta.next().filter(|_| momenta.next().is_none())
}

/// The factors of a product that do not read a symbol, and those that do.
pub(super) fn parted(graph: &mut Graph, id: Id, symbol: Symbol) -> (Id, Id) {
    let (c, rest) = graph.coefficient(id);
    let (mut free, mut reading) = (graph.number(c), graph.integer(1));
    for (base, exponent) in factors(graph, rest) {
        let factor = graph.pow(base, exponent);
        let side = if is_free(graph, factor, &|other| other == symbol) { &mut free } else { &mut reading };
        *side = graph.mul(*side, factor);
    }
    (free, reading)
}

pub(super) fn is_momentum(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Momentum(_))
}

/// Σ powers, each of the momenta together.
pub(super) fn degree(powers: impl IntoIterator<Item = Ratio>) -> Option<Ratio> {
    powers.into_iter().try_fold(Ratio::ZERO, Ratio::add)
}
