//! The value of nodes at a point: symbols and functions are numbers that look random, roots are roots, conditions are choices.

use super::super::OpenBoundaries;
use super::arguments::Arguments;
use super::choices::{Choices, Question};
use super::prime::{Element, Prime};
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Relation, factors_of_radicand};

/// What is evaluated.
pub(super) struct Plan<'a> {
    pub(super) graph: &'a Graph,
    /// Operands first.
    pub(super) order: Vec<Id>,
    pub(super) arguments: Arguments,
    /// Whether the boundary of conditions is a case of its own: with several, they need not hold on the same side of it.
    pub(super) boundary: bool,
}

impl<'a> Plan<'a> {
    /// `None` if exponents have denominators that are too large.
    pub(super) fn new(graph: &'a Graph, roots: &[Id]) -> Option<Plan<'a>> {
        let order = graph.reachable(roots);
        let arguments = Arguments::of(graph, &order)?;
        let relations = order.iter().filter_map(|id| match graph.node(*id) {
            Node::Compare(relation, ..) => Some(*relation),
            _ => None,
        });
        let relations: Vec<Relation> = relations.collect();
        let signum = |id: &Id| matches!(graph.node(*id), Node::Call(Function::Signum, _));
        let several = relations.len() + order.iter().filter(|id| signum(id)).count().min(1) > 1;
        let boundary = !relations.is_empty() && several || relations.contains(&Relation::Equal);
        Some(Plan { graph, order, arguments, boundary })
    }
}

/// Why a node has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Halt {
    /// It divides by zero, with these choices.
    Undefined,
    /// A number has no root: another point is needed.
    Redraw,
    /// Too many choices, or numbers that are too long.
    GiveUp,
}

#[derive(Clone, Copy, Debug)]
enum Value {
    Number(Element),
    Truth(bool),
    Undefined,
}

/// Values at one point.
pub(super) struct Evaluation<'a> {
    pub(super) plan: &'a Plan<'a>,
    pub(super) prime: Prime,
    /// The point.
    seed: u64,
    /// Whether roots are unknowns of their own, of which it is not known what their squares are.
    free_roots: bool,
    values: Vec<Value>,
    pub(super) choices: Choices,
    position: usize,
}

impl<'a> Evaluation<'a> {
    pub(super) fn new(plan: &'a Plan<'a>, prime: Prime, seed: u64, free_roots: bool) -> Self {
        let values = vec![Value::Undefined; plan.order.last().map_or(0, |last| last.index() + 1)];
        Evaluation { plan, prime, seed, free_roots, values, choices: Choices::default(), position: 0 }
    }

    /// Evaluates what comes at a position or after it.
    pub(super) fn run(&mut self, from: usize) -> Result<(), Halt> {
        let plan = self.plan;
        for (position, id) in plan.order.iter().enumerate().skip(from) {
            self.position = position;
            self.values[id.index()] = match self.value(*id) {
                Ok(value) => value,
                Err(Halt::Undefined) => Value::Undefined,
                Err(halt) => return Err(halt),
            };
        }
        Ok(())
    }

    /// The number that a node is.
    pub(super) fn number(&self, id: Id) -> Result<Element, Halt> {
        match self.values[id.index()] {
            Value::Number(value) => Ok(value),
            _ => Err(Halt::Undefined),
        }
    }

    fn holds(&self, id: Id) -> Result<bool, Halt> {
        match self.values[id.index()] {
            Value::Truth(value) => Ok(value),
            _ => Err(Halt::Undefined),
        }
    }

    fn value(&mut self, id: Id) -> Result<Value, Halt> {
        let (plan, prime) = (self.plan, self.prime);
        let number = match plan.graph.node(id) {
            Node::Number(value) => self.constant(*value)?,
            Node::Symbol(_) => {
                let root = self.unknown(SYMBOL, &[], id.index() as u64);
                self.power(root, plan.arguments.power_of_symbol(id))?
            }
            Node::Linear(constant, terms) => {
                let mut sum = self.constant(*constant)?;
                for (c, term) in terms {
                    let (c, term) = (self.constant(*c)?, self.number(*term)?);
                    sum = prime.sum(sum, prime.product(c, term));
                }
                sum
            }
            Node::Product(ids) => {
                let mut product = Element::ONE;
                for id in ids {
                    product = prime.product(product, self.number(*id)?);
                }
                product
            }
            Node::Power(base, exponent) => self.ratio_power(*base, *exponent)?,
            Node::Call(function, args) => self.call(*function, args)?,
            Node::Select(condition, first, second) => {
                self.number(if self.holds(*condition)? { *first } else { *second })?
            }
            Node::Compare(relation, a, b) => {
                let difference = prime.difference(self.number(*b)?, self.number(*a)?);
                return Ok(Value::Truth(self.compare(*relation, difference)?));
            }
            Node::And(a, b) => return self.truth(self.holds(*a), self.holds(*b), false),
            Node::Or(a, b) => return self.truth(self.holds(*a), self.holds(*b), true),
            Node::Not(a) => return Ok(Value::Truth(!self.holds(*a)?)),
            Node::Truth(value) => return Ok(Value::Truth(*value)),
        };
        Ok(Value::Number(number))
    }

    /// Of two truths, one that settles the matter alone need not wait for the other.
    fn truth(&self, a: Result<bool, Halt>, b: Result<bool, Halt>, settles: bool) -> Result<Value, Halt> {
        if a == Ok(settles) || b == Ok(settles) {
            return Ok(Value::Truth(settles));
        }
        a.and(b).map(|_| Value::Truth(!settles))
    }

    pub(super) fn constant(&self, value: Number) -> Result<Element, Halt> {
        match value {
            Number::Exact(ratio) => self.prime.ratio(ratio).ok_or(Halt::GiveUp),
            // Which root of a prime it is does not matter: what holds for one holds for the other.
            Number::Root(c, r) => {
                let mut product = self.prime.ratio(c).ok_or(Halt::GiveUp)?;
                for p in factors_of_radicand(r) {
                    let p = self.prime.ratio(Ratio::integer(p.into())).ok_or(Halt::GiveUp)?;
                    product = self.prime.product(product, self.prime.root(p).ok_or(Halt::Redraw)?);
                }
                Ok(product)
            }
            Number::Float(_) => {
                let size = self.unknown(FLOAT, &[], value.to_f64().abs().to_bits());
                Ok(if value.is_negative() { self.prime.negative(size) } else { size })
            }
        }
    }

    pub(super) fn power(&self, base: Element, n: i64) -> Result<Element, Halt> {
        self.prime.power(base, n).ok_or(Halt::Undefined)
    }

    pub(super) fn reciprocal(&self, x: Element) -> Result<Element, Halt> {
        self.prime.reciprocal(x).ok_or(Halt::Undefined)
    }

    /// baseᵉ, where the base may be a symbol that is a power itself.
    pub(super) fn ratio_power(&mut self, base: Id, exponent: Ratio) -> Result<Element, Halt> {
        if let Some(k) = self.plan.arguments.power_of_root(base, exponent) {
            let root = self.unknown(SYMBOL, &[], base.index() as u64);
            return self.power(root, k);
        }
        let value = self.number(base)?;
        let numerator = i64::try_from(exponent.numerator).map_err(|_| Halt::GiveUp)?;
        let root = match exponent.denominator {
            1 => value,
            2 => self.root(value)?,
            degree => self.unknown(ROOT, &[value], degree as u64),
        };
        self.power(root, numerator)
    }

    /// One of the two square roots.
    pub(super) fn root(&mut self, radicand: Element) -> Result<Element, Halt> {
        if radicand.is_zero() {
            return Ok(radicand);
        }
        if self.free_roots {
            return Ok(self.unknown(ROOT, &[radicand], 2));
        }
        let root = self.prime.root(radicand).ok_or(Halt::Redraw)?;
        let answer = self.choices.answer(Question::Root(radicand), 2, self.position).ok_or(Halt::GiveUp)?;
        Ok(if answer == 0 { root } else { self.prime.negative(root) })
    }

    /// Whether a number is negative, zero or positive.
    fn order(&mut self, x: Element) -> Result<std::cmp::Ordering, Halt> {
        let (size, negative) = self.prime.without_sign(x);
        if size.is_zero() {
            return Ok(std::cmp::Ordering::Equal);
        }
        let answers = if self.plan.boundary { 3 } else { 2 };
        match self.choices.answer(Question::Sign(size), answers, self.position).ok_or(Halt::GiveUp)? {
            EQUAL => Ok(std::cmp::Ordering::Equal),
            answer if (answer == 1) == negative => Ok(std::cmp::Ordering::Greater),
            _ => Ok(std::cmp::Ordering::Less),
        }
    }

    /// Whether the choices put this point on a boundary.
    pub(super) fn is_on_any(&self, boundaries: &OpenBoundaries) -> bool {
        boundaries.iter().any(|id| {
            let difference = match self.plan.graph.node(*id) {
                Node::Compare(_, a, b) => self.number(*b).and_then(|b| Ok(self.prime.difference(b, self.number(*a)?))),
                Node::Call(_, args) => self.number(args[0]),
                _ => return false,
            };
            difference.is_ok_and(|difference| {
                let (size, _) = self.prime.without_sign(difference);
                size.is_zero() || self.choices.of(Question::Sign(size)) == Some(EQUAL)
            })
        })
    }

    /// Whether a number counts as negative; at the boundary either is right.
    pub(super) fn is_negative(&mut self, x: Element) -> Result<bool, Halt> {
        Ok(self.order(x)?.is_lt())
    }

    fn compare(&mut self, relation: Relation, difference: Element) -> Result<bool, Halt> {
        let order = self.order(difference)?;
        Ok(match relation {
            Relation::Less => order.is_gt(),
            Relation::LessEqual => order.is_ge(),
            Relation::Equal => order.is_eq(),
        })
    }

    /// A number that stands for a function of these values, the same whenever it is asked for at this point.
    pub(super) fn unknown(&self, kind: u64, values: &[Element], detail: u64) -> Element {
        let words = values.iter().flat_map(|value| [value.real, value.imaginary]);
        let hash = [kind, detail].into_iter().chain(words).fold(self.seed, |hash, word| mixed(hash ^ mixed(word)));
        self.prime.unknown(hash)
    }
}

/// The answer to the question for a sign by which a number is zero.
const EQUAL: u8 = 2;

/// What numbers stand for; functions have numbers from [`FUNCTION`] on.
const SYMBOL: u64 = 0;
const FLOAT: u64 = 1;
const ROOT: u64 = 2;
pub(super) const FUNCTION: u64 = 8;

/// A permutation of words under which they look random (G. L. Steele, D. Lea & C. H. Flood, OOPSLA 2014, SplitMix).
pub(super) fn mixed(word: u64) -> u64 {
    let word = word.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^ (word >> 31)
}
