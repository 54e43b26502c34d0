//! Arguments of exponentials, sines and powers as sums of terms, because e^Σ is a product over the terms. Symbols under a root are powers of
//! an unknown, so that their roots are polynomials.

use super::super::is_exponential;
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio};

/// coefficient·scale·Π factors.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) coefficient: Ratio,
    /// 1, unless the coefficient would have a long denominator, as 2π has.
    pub(super) scale: Ratio,
    pub(super) factors: Vec<Id>,
}

impl Term {
    fn new(coefficient: Ratio, factors: Vec<Id>) -> Term {
        Term { coefficient, scale: Ratio::ONE, factors }
    }

    /// The number before the factors, if it is an integer.
    pub(super) fn integer_coefficient(&self) -> Option<i64> {
        self.coefficient.to_i64().filter(|_| self.scale == Ratio::ONE)
    }

    /// The term with a scale between 1 and 2, and a coefficient ±2ᵏ. `None` if numbers are too long.
    fn scaled(self) -> Option<Term> {
        let (mut scale, mut coefficient) = (self.coefficient, Ratio::ONE);
        if scale < Ratio::ZERO {
            (scale, coefficient) = (scale.neg(), coefficient.neg());
        }
        for _ in 0..SHIFTS {
            if scale < Ratio::ONE {
                (scale, coefficient) = (scale.mul(Ratio::integer(2))?, coefficient.mul(Ratio::HALF)?);
            } else if scale >= Ratio::integer(2) {
                (scale, coefficient) = (scale.mul(Ratio::HALF)?, coefficient.mul(Ratio::integer(2))?);
            }
        }
        Some(Term { coefficient, scale, ..self })
    }
}

/// A product of sums with more terms than this stays one factor.
const MOST_TERMS: usize = 16;

/// The largest number of nodes of an argument that are expanded. Shared nodes count at every use.
const MOST_NODES: u32 = 100;

/// The terms of a node. Terms with equal factors are merged.
fn terms(graph: &Graph, id: Id) -> Vec<Term> {
    let (mut merged, mut nodes): (Vec<Term>, u32) = (vec![], MOST_NODES);
    for term in expanded(graph, id, &mut nodes) {
        let known = merged.iter_mut().find(|other| other.factors == term.factors);
        match known.and_then(|known| Some((known.coefficient.add(term.coefficient)?, known))) {
            Some((sum, known)) => known.coefficient = sum,
            None => merged.push(term),
        }
    }
    merged.retain(|term| term.coefficient != Ratio::ZERO);
    merged
}

/// The terms of a node. A node that cannot be expanded is one term. `nodes` is the number of nodes that may still be visited.
fn expanded(graph: &Graph, id: Id, nodes: &mut u32) -> Vec<Term> {
    expansion(graph, id, nodes).unwrap_or_else(|| vec![Term::new(Ratio::ONE, vec![id])])
}

fn expansion(graph: &Graph, id: Id, nodes: &mut u32) -> Option<Vec<Term>> {
    *nodes = nodes.checked_sub(1)?;
    match graph.node(id) {
        Node::Number(Number::Exact(value)) => Some(vec![Term::new(*value, vec![])]),
        Node::Linear(Number::Exact(constant), terms) => {
            let mut all = vec![Term::new(*constant, vec![])];
            for (c, term) in terms {
                let Number::Exact(c) = c else { return None };
                for inner in expanded(graph, *term, nodes) {
                    all.push(Term { coefficient: inner.coefficient.mul(*c)?, ..inner });
                }
            }
            Some(all)
        }
        Node::Product(ids) => {
            let mut product = vec![Term::new(Ratio::ONE, vec![])];
            for factor in ids {
                let factor = expanded(graph, *factor, nodes);
                if product.len() * factor.len() > MOST_TERMS {
                    return None;
                }
                let pairs = product.iter().flat_map(|a| factor.iter().map(move |b| (a, b)));
                let times = |(a, b): (&Term, &Term)| {
                    let mut factors = [&a.factors[..], &b.factors].concat();
                    factors.sort();
                    Some(Term::new(a.coefficient.mul(b.coefficient)?, factors))
                };
                product = pairs.map(times).collect::<Option<_>>()?;
            }
            Some(product)
        }
        _ => None,
    }
}

/// Properties of the arguments of functions.
#[derive(Debug)]
pub(super) struct Arguments {
    /// The terms of exponents and angles.
    terms: HashMap<Id, Vec<Term>>,
    /// A common denominator of the coefficients of these terms.
    pub(super) denominator: i64,
    /// For symbols under a root: the n for which the symbol is an n-th power of an unknown.
    powers: HashMap<Id, i64>,
}

/// The largest common denominator. Larger ones give degrees that prove little.
const LARGEST: i64 = 1 << 20;

/// The largest number of factors of 2 in a coefficient that are separated from the scale.
const SHIFTS: u32 = 16;

/// The largest power of an unknown that a symbol stands for.
const LARGEST_POWER: i64 = 720;

impl Arguments {
    /// Collects the arguments of the nodes in `order`. `None` if denominators are too large.
    pub(super) fn of(graph: &Graph, order: &[Id]) -> Option<Arguments> {
        let mut arguments = Arguments { terms: HashMap::default(), denominator: 1, powers: HashMap::default() };
        for id in order {
            match graph.node(*id) {
                Node::Power(base, exponent) => arguments.add_root(graph, *base, exponent.denominator),
                Node::Call(Function::Root | Function::Hypot, args) => arguments.add_root(graph, args[0], 2),
                Node::Call(Function::Cbrt, args) => arguments.add_root(graph, args[0], 3),
                Node::Call(Function::Powf, args) => match graph.as_number(args[1]) {
                    Some(Number::Exact(exponent)) => arguments.add_root(graph, args[0], exponent.denominator),
                    _ => arguments.add_exponent(graph, args[1])?,
                },
                Node::Call(function, args) if is_exponential(*function) => arguments.add_exponent(graph, args[0])?,
                _ => {}
            }
        }
        Some(arguments)
    }

    fn add_root(&mut self, graph: &Graph, base: Id, degree: i128) {
        let Ok(degree) = i64::try_from(degree) else { return };
        if degree > 1 && matches!(graph.node(base), Node::Symbol(_)) {
            let common = common_multiple(self.power_of_symbol(base), degree);
            if let Some(common) = common.filter(|common| *common <= LARGEST_POWER) {
                self.powers.insert(base, common);
            }
        }
    }

    fn add_exponent(&mut self, graph: &Graph, argument: Id) -> Option<()> {
        let mut terms = terms(graph, argument);
        for term in &mut terms {
            if self.common_denominator(term.coefficient).is_none() {
                *term = term.clone().scaled()?;
            }
            self.denominator = self.common_denominator(term.coefficient)?;
        }
        self.terms.insert(argument, terms);
        Some(())
    }

    /// The common denominator after one more coefficient, unless it is too large.
    fn common_denominator(&self, coefficient: Ratio) -> Option<i64> {
        let denominator = i64::try_from(coefficient.denominator).ok()?;
        common_multiple(self.denominator, denominator).filter(|common| *common <= LARGEST)
    }

    /// The terms of an exponent or angle.
    pub(super) fn terms(&self, argument: Id) -> &[Term] {
        self.terms.get(&argument).map_or(&[], |terms| terms)
    }

    /// coefficient·denominator.
    pub(super) fn times_denominator(&self, coefficient: Ratio) -> Option<i64> {
        coefficient.mul(Ratio::integer(self.denominator.into()))?.to_i64()
    }

    /// The n for which a symbol is the n-th power of an unknown.
    pub(super) fn power_of_symbol(&self, id: Id) -> i64 {
        self.powers.get(&id).copied().unwrap_or(1)
    }

    /// The integer k for which baseᵉ is the k-th power of an unknown. `None` unless the base is a symbol with a root of this degree.
    pub(super) fn power_of_root(&self, base: Id, exponent: Ratio) -> Option<i64> {
        let n = *self.powers.get(&base)?;
        exponent.mul(Ratio::integer(n.into()))?.to_i64()
    }
}

fn common_multiple(a: i64, b: i64) -> Option<i64> {
    let (mut x, mut y) = (a, b);
    while y != 0 {
        (x, y) = (y, x % y);
    }
    (a / x).checked_mul(b)
}
