//! Arguments of exponentials, sines and powers as sums of terms, since e^Σ is a product; what symbols are powers of, so that their
//! roots are numbers.

use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio};

/// coefficient·Π factors.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) coefficient: Ratio,
    pub(super) factors: Vec<Id>,
}

/// A product of sums with more terms than this stays one factor.
const MOST_TERMS: usize = 16;

/// The terms of a node; equal ones are one.
fn terms(graph: &Graph, id: Id) -> Vec<Term> {
    let mut merged: Vec<Term> = vec![];
    for term in collect(graph, id) {
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

fn collect(graph: &Graph, id: Id) -> Vec<Term> {
    let whole = || vec![Term { coefficient: Ratio::ONE, factors: vec![id] }];
    match graph.node(id) {
        Node::Number(Number::Exact(value)) => vec![Term { coefficient: *value, factors: vec![] }],
        Node::Linear(Number::Exact(constant), terms) => {
            let mut all = vec![Term { coefficient: *constant, factors: vec![] }];
            for (c, term) in terms {
                let Number::Exact(c) = c else { return whole() };
                for inner in collect(graph, *term) {
                    let Some(coefficient) = inner.coefficient.mul(*c) else { return whole() };
                    all.push(Term { coefficient, ..inner });
                }
            }
            all
        }
        Node::Product(ids) => {
            let mut product = vec![Term { coefficient: Ratio::ONE, factors: vec![] }];
            for factor in ids {
                let factor = collect(graph, *factor);
                if product.len() * factor.len() > MOST_TERMS {
                    return whole();
                }
                let pairs = product.iter().flat_map(|a| factor.iter().map(move |b| (a, b)));
                let times = |(a, b): (&Term, &Term)| {
                    let mut factors = [&a.factors[..], &b.factors].concat();
                    factors.sort();
                    Some(Term { coefficient: a.coefficient.mul(b.coefficient)?, factors })
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

/// Larger denominators make degrees that prove nothing.
const LARGEST: i64 = 1 << 30;

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
        let terms = terms(graph, argument);
        for term in &terms {
            let denominator = i64::try_from(term.coefficient.denominator).ok()?;
            let common = common_multiple(self.denominator, denominator)?;
            self.denominator = Some(common).filter(|common| *common <= LARGEST)?;
        }
        self.terms.insert(argument, terms);
        Some(())
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
