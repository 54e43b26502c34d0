//! Arguments of exponentials, sines and powers as sums of terms, since e^Σ is a product; what symbols are powers of, so that their
//! roots are numbers.

use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio};

/// coefficient·scale·Π factors.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) coefficient: Ratio,
    /// Not 1 if the coefficient would have a long denominator, as 2π has.
    pub(super) scale: Ratio,
    pub(super) factors: Vec<Id>,
}

impl Term {
    fn new(coefficient: Ratio, factors: Vec<Id>) -> Term {
        Term { coefficient, scale: Ratio::ONE, factors }
    }

    /// The coefficient, if it is an integer and all that is before the factors.
    pub(super) fn whole(&self) -> Option<i64> {
        self.coefficient.to_integer().filter(|_| self.scale == Ratio::ONE)
    }

    /// With a scale between 1 and 2 for the coefficient, and what power of two is left of it.
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

/// So many nodes of an argument are taken apart; shared ones would be again and again.
const MOST_NODES: u32 = 100;

/// The terms of a node; equal ones are one.
fn terms(graph: &Graph, id: Id) -> Vec<Term> {
    let (mut merged, mut nodes): (Vec<Term>, u32) = (vec![], MOST_NODES);
    for term in collect(graph, id, &mut nodes) {
        match merged.iter_mut().find(|other| other.factors == term.factors) {
            Some(other) => match other.coefficient.add(term.coefficient) {
                Some(sum) => other.coefficient = sum,
                None => merged.push(term),
            },
            None => merged.push(term),
        }
    }
    merged.retain(|term| term.coefficient != Ratio::ZERO);
    merged
}

fn collect(graph: &Graph, id: Id, nodes: &mut u32) -> Vec<Term> {
    let whole = || vec![Term::new(Ratio::ONE, vec![id])];
    let Some(left) = nodes.checked_sub(1) else { return whole() };
    *nodes = left;
    match graph.node(id) {
        Node::Number(Number::Exact(value)) => vec![Term::new(*value, vec![])],
        Node::Linear(Number::Exact(constant), terms) => {
            let mut all = vec![Term::new(*constant, vec![])];
            for (c, term) in terms {
                let Number::Exact(c) = c else { return whole() };
                for inner in collect(graph, *term, nodes) {
                    let Some(coefficient) = inner.coefficient.mul(*c) else { return whole() };
                    all.push(Term { coefficient, ..inner });
                }
            }
            all
        }
        Node::Product(ids) => {
            let mut product = vec![Term::new(Ratio::ONE, vec![])];
            for factor in ids {
                let factor = collect(graph, *factor, nodes);
                if product.len() * factor.len() > MOST_TERMS {
                    return whole();
                }
                let pairs = product.iter().flat_map(|a| factor.iter().map(move |b| (a, b)));
                let times = |(a, b): (&Term, &Term)| {
                    let mut factors = [&a.factors[..], &b.factors].concat();
                    factors.sort();
                    Some(Term::new(a.coefficient.mul(b.coefficient)?, factors))
                };
                let Some(next) = pairs.map(times).collect::<Option<Vec<Term>>>() else { return whole() };
                product = next;
            }
            product
        }
        _ => whole(),
    }
}

/// What is known of the nodes before they are evaluated.
#[derive(Debug)]
pub(super) struct Arguments {
    /// Exponents and angles.
    terms: HashMap<Id, Vec<Term>>,
    /// The coefficients in exponents are multiples of its reciprocal.
    pub(super) denominator: i64,
    /// Symbols that roots are taken of are such powers.
    powers: HashMap<Id, i64>,
}

/// Larger denominators make degrees that prove little.
const LARGEST: i64 = 1 << 20;

/// Scales are within so many powers of two.
const SHIFTS: u32 = 16;

/// A symbol is a power up to this one.
const LARGEST_POWER: i64 = 720;

impl Arguments {
    /// `None` if denominators are too large.
    pub(super) fn of(graph: &Graph, order: &[Id]) -> Option<Arguments> {
        let mut arguments = Arguments { terms: HashMap::default(), denominator: 1, powers: HashMap::default() };
        for id in order {
            match graph.node(*id) {
                Node::Power(base, exponent) => arguments.root(graph, *base, exponent.denominator),
                Node::Call(Function::Root | Function::Hypot, args) => arguments.root(graph, args[0], 2),
                Node::Call(Function::Cbrt, args) => arguments.root(graph, args[0], 3),
                Node::Call(Function::Powf, args) => match graph.as_number(args[1]) {
                    Some(Number::Exact(exponent)) => arguments.root(graph, args[0], exponent.denominator),
                    _ => arguments.exponent(graph, args[1])?,
                },
                Node::Call(function, args) if is_exponential(*function) => arguments.exponent(graph, args[0])?,
                _ => {}
            }
        }
        Some(arguments)
    }

    /// Notes that a root is taken of a base.
    fn root(&mut self, graph: &Graph, base: Id, degree: i128) {
        let Ok(degree) = i64::try_from(degree) else { return };
        if degree > 1 && matches!(graph.node(base), Node::Symbol(_)) {
            let known = self.powers.get(&base).copied().unwrap_or(1);
            if let Some(common) = common_multiple(known, degree).filter(|common| *common <= LARGEST_POWER) {
                self.powers.insert(base, common);
            }
        }
    }

    fn exponent(&mut self, graph: &Graph, argument: Id) -> Option<()> {
        let mut terms = terms(graph, argument);
        for term in &mut terms {
            if self.common(term.coefficient).is_none() {
                *term = term.clone().scaled()?;
            }
            self.denominator = self.common(term.coefficient)?;
        }
        self.terms.insert(argument, terms);
        Some(())
    }

    /// The common denominator with one more coefficient, unless it is too large.
    fn common(&self, coefficient: Ratio) -> Option<i64> {
        let denominator = i64::try_from(coefficient.denominator).ok()?;
        common_multiple(self.denominator, denominator).filter(|common| *common <= LARGEST)
    }

    pub(super) fn terms(&self, argument: Id) -> &[Term] {
        self.terms.get(&argument).map_or(&[], |terms| terms)
    }

    /// coefficient·denominator.
    pub(super) fn whole(&self, coefficient: Ratio) -> Option<i64> {
        coefficient.mul(Ratio::integer(self.denominator.into()))?.to_integer()
    }

    /// The n for which a symbol is an n-th power.
    pub(super) fn power_of_symbol(&self, id: Id) -> i64 {
        self.powers.get(&id).copied().unwrap_or(1)
    }

    /// k for which baseᵉ is the k-th power of the number whose power the base is, if it is a symbol with such a root.
    pub(super) fn power_of_root(&self, base: Id, exponent: Ratio) -> Option<i64> {
        let whole = *self.powers.get(&base)?;
        exponent.mul(Ratio::integer(whole.into()))?.to_integer()
    }
}

/// Functions that are rational in exponentials of their argument.
pub(super) fn is_exponential(function: Function) -> bool {
    use Function::{Cos, Cosh, Exp, Exp2, ExpM1, Sin, Sinh, Tan, Tanh};
    matches!(function, Exp | Exp2 | ExpM1 | Sinh | Cosh | Tanh | Sin | Cos | Tan)
}

fn common_multiple(a: i64, b: i64) -> Option<i64> {
    let (mut x, mut y) = (a, b);
    while y != 0 {
        (x, y) = (y, x % y);
    }
    (a / x).checked_mul(b)
}
