//! Expressions as sums of powers of chosen symbols. The coefficients do not read these symbols.

use crate::analyze;
use crate::diff;
use crate::ir::formula::pow;
use crate::ir::{Graph, Id, Node, Number, Ratio, Symbol, Table};
use std::collections::BTreeMap;

/// The exponent of each symbol in a product of powers. Symbols with exponent 0 are absent.
pub(super) type Monomial = BTreeMap<Symbol, Ratio>;

/// Σ coefficient·monomial. Exponents are integers or halves of odd integers, and may be negative.
#[derive(Clone, Debug)]
pub(super) struct Polynomial(BTreeMap<Monomial, Id>);

/// The largest number of terms of a product of polynomials.
const MAX_TERMS: usize = 64;

impl Polynomial {
    /// Returns `root` as a polynomial in the symbols that `counts` selects, or `None` if `root` is not a polynomial.
    pub(super) fn of(graph: &mut Graph, root: Id, counts: &impl Fn(Symbol) -> bool) -> Option<Polynomial> {
        // Most expressions are not polynomials, and the test costs less than the expansion of products.
        if is_algebraic(graph, root, counts) { Self::expanded(graph, root, counts) } else { None }
    }

    fn expanded(graph: &mut Graph, root: Id, counts: &impl Fn(Symbol) -> bool) -> Option<Polynomial> {
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
                    for (monomial, coefficient) in Self::expanded(graph, term, counts)?.0 {
                        let coefficient = graph.scale(c, coefficient);
                        sum.add(graph, monomial, coefficient);
                    }
                }
                Some(sum.without_zeros(graph))
            }
            Node::Product(ids) => {
                let one = graph.integer(1);
                ids.into_iter().try_fold(Self::term(Monomial::new(), one), |product, id| {
                    let factor = Self::expanded(graph, id, counts)?;
                    product.times(graph, &factor)
                })
            }
            Node::Power(base, exponent) => {
                let base = Self::expanded(graph, base, counts)?;
                if let Some((monomial, coefficient)) = base.single() {
                    let powers: Option<Monomial> = monomial.iter().map(|(s, r)| Some((*s, r.mul(exponent)?))).collect();
                    // √(x²) is |x|, so exponents multiply only if no sign is lost.
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
        Polynomial(BTreeMap::from([(monomial, coefficient)]))
    }

    fn add(&mut self, graph: &mut Graph, monomial: Monomial, coefficient: Id) {
        self.0.entry(monomial).and_modify(|sum| *sum = graph.add(*sum, coefficient)).or_insert(coefficient);
    }

    fn without_zeros(mut self, graph: &Graph) -> Polynomial {
        self.0.retain(|_, coefficient| !graph.is_zero(*coefficient));
        self
    }

    fn times(&self, graph: &mut Graph, other: &Polynomial) -> Option<Polynomial> {
        let mut product = Polynomial(BTreeMap::new());
        for (left, a) in &self.0 {
            for (right, b) in &other.0 {
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
        (product.0.len() <= MAX_TERMS).then(|| product.without_zeros(graph))
    }

    /// Returns the monomials with their coefficients.
    pub(super) fn terms(&self) -> impl Iterator<Item = (&Monomial, Id)> {
        self.0.iter().map(|(monomial, coefficient)| (monomial, *coefficient))
    }

    /// Returns the monomials with their coefficients, and consumes the polynomial.
    pub(super) fn into_terms(self) -> impl Iterator<Item = (Monomial, Id)> {
        self.0.into_iter()
    }

    /// Returns the term of a polynomial with exactly one term.
    pub(super) fn single(&self) -> Option<(&Monomial, Id)> {
        let mut terms = self.terms();
        terms.next().filter(|_| terms.next().is_none())
    }

    /// Returns the coefficient of a product of powers, or zero if there is no such term.
    pub(super) fn coefficient(&self, graph: &mut Graph, powers: &[(Symbol, i128)]) -> Id {
        let monomial: Monomial = powers.iter().map(|(symbol, power)| (*symbol, Ratio::integer(*power))).collect();
        self.0.get(&monomial).copied().unwrap_or_else(|| graph.zero())
    }

    /// Returns the constant ∂²/∂a∂b of the quadratic terms.
    pub(super) fn second_derivative(&self, graph: &mut Graph, a: Symbol, b: Symbol) -> Id {
        if a == b {
            let half = self.coefficient(graph, &[(a, 2)]);
            return graph.scale(Number::integer(2), half);
        }
        self.coefficient(graph, &[(a, 1), (b, 1)])
    }

    /// Returns whether all monomials are `allowed`.
    pub(super) fn has_only(&self, allowed: impl Fn(&Monomial) -> bool) -> bool {
        self.0.keys().all(allowed)
    }

    /// Returns whether every term has degree 0 or 1.
    pub(super) fn is_affine(&self) -> bool {
        self.has_only(|monomial| monomial.is_empty() || is_linear(monomial))
    }
}

/// Returns whether only sums, products and powers lie between an expression and the selected symbols. Visits each node once.
fn is_algebraic(graph: &Graph, root: Id, counts: &impl Fn(Symbol) -> bool) -> bool {
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

fn is_one(graph: &Graph, id: Id) -> bool {
    graph.as_number(id).is_some_and(|x| x.to_f64() == 1.0)
}

/// Returns whether an expression reads none of the symbols that `counts` selects.
pub(super) fn is_free(graph: &Graph, root: Id, counts: &impl Fn(Symbol) -> bool) -> bool {
    !graph.reads_any(root, counts)
}

/// Returns whether an expression reads a symbol.
pub(super) fn reads(graph: &Graph, root: Id, symbol: Symbol) -> bool {
    graph.reads_any(root, |other| other == symbol)
}

/// Returns a of a·x + b if a and b do not read x. Conditions must not read x either, because derivatives do not show that b changes at a
/// condition.
pub(super) fn slope_of_line(graph: &mut Graph, line: Id, x: Symbol) -> Option<Id> {
    let slope = diff::partial_derivative(graph, line, x);
    let conditions = analyze::conditions(graph, line);
    [slope].iter().chain(&conditions).all(|id| !reads(graph, *id, x)).then_some(slope)
}

/// Returns coefficient·monomial.
pub(super) fn times_powers(graph: &mut Graph, coefficient: Id, monomial: &Monomial) -> Id {
    monomial.iter().fold(coefficient, |term, (symbol, power)| {
        let symbol = graph.symbol(*symbol);
        graph.build(term * pow(symbol, *power))
    })
}

/// Returns the exponent of a symbol in a monomial.
pub(super) fn power(monomial: &Monomial, symbol: Symbol) -> Ratio {
    monomial.get(&symbol).copied().unwrap_or(Ratio::ZERO)
}

/// Returns the degree of a monomial, or `None` on overflow.
pub(super) fn degree(monomial: &Monomial) -> Option<Ratio> {
    monomial.values().copied().try_fold(Ratio::ZERO, Ratio::add)
}

/// Returns whether all exponents are positive integers.
pub(super) fn is_whole(monomial: &Monomial) -> bool {
    monomial.values().all(|power| power.is_integer() && power.numerator > 0)
}

/// Returns whether a monomial is a single symbol.
pub(super) fn is_linear(monomial: &Monomial) -> bool {
    monomial.values().eq([&Ratio::ONE])
}

/// Returns the momentum of a monomial that contains exactly one, as its index and exponent.
pub(super) fn single_momentum(monomial: &Monomial) -> Option<(u32, Ratio)> {
    let mut momenta = monomial.iter().filter_map(|(symbol, power)| match symbol {
        Symbol::Momentum(i) => Some((*i, *power)),
        _ => None,
    });
    momenta.next().filter(|_| momenta.next().is_none())
}

/// Returns the index of the degree of freedom of a position or momentum.
pub(super) fn degree_of_freedom(symbol: Symbol) -> Option<u32> {
    match symbol {
        Symbol::Position(i) | Symbol::Momentum(i) => Some(i),
        _ => None,
    }
}

/// Returns whether a symbol is a momentum.
pub(super) fn is_momentum(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Momentum(_))
}
