//! Values of nodes at a point: symbols are pseudorandom elements, square roots are roots in the field, and conditions are choices.

use super::super::OpenBoundaries;
use super::arguments::Arguments;
use super::choices::{Choices, Question};
use super::prime::{Element, Prime};
use super::pseudorandom;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Relation, factors_of_radicand};
use std::cmp::Ordering;

/// The nodes to evaluate, and properties of them that hold at all points.
pub(super) struct Plan<'a> {
    pub(super) graph: &'a Graph,
    /// Operands precede the nodes that use them.
    pub(super) order: Vec<Id>,
    pub(super) arguments: Arguments,
    /// Zero is a third sign of a number in a condition. Necessary if several conditions may disagree about their boundary.
    zero_is_a_sign: bool,
}

impl<'a> Plan<'a> {
    /// `None` if exponents have denominators that are too large.
    pub(super) fn new(graph: &'a Graph, roots: &[Id]) -> Option<Plan<'a>> {
        let order = graph.reachable(roots);
        let arguments = Arguments::of(graph, &order)?;
        let relation = |id: &Id| match graph.node(*id) {
            Node::Compare(relation, ..) => Some(*relation),
            _ => None,
        };
        let relations: Vec<Relation> = order.iter().filter_map(relation).collect();
        let is_signum = |id: &Id| matches!(graph.node(*id), Node::Call(Function::Signum, _));
        let has_several = relations.len() > 1 || relations.len() == 1 && order.iter().any(is_signum);
        let zero_is_a_sign = has_several || relations.contains(&Relation::Equal);
        Some(Plan { graph, order, arguments, zero_is_a_sign })
    }
}

/// How square roots are evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SquareRoots {
    /// Roots are unknowns, independent of their radicands.
    Independent,
    /// Roots are elements of the field, with both signs.
    BothSigns,
}

/// The reason why the evaluation stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Halt {
    /// The node divides by zero, with these choices.
    Undefined,
    /// A number has no root. Another point is needed.
    Redraw,
    /// There are too many choices, or numbers are too long.
    GiveUp,
    /// The identity does not hold. Further points are not needed.
    Refuted,
}

/// The evaluation at one point.
pub(super) struct Evaluation<'a> {
    pub(super) plan: &'a Plan<'a>,
    pub(super) prime: Prime,
    /// The seed of the unknowns. It defines the point.
    seed: u64,
    square_roots: SquareRoots,
    /// Values by index of the node; `None` where undefined. A condition is 1 if it holds, and 0 otherwise.
    values: Vec<Option<Element>>,
    pub(super) choices: Choices,
    /// The position in the plan of the node that is being evaluated.
    position: usize,
}

impl<'a> Evaluation<'a> {
    pub(super) fn new(plan: &'a Plan<'a>, prime: Prime, seed: u64, square_roots: SquareRoots) -> Self {
        let values = vec![None; plan.order.last().map_or(0, |last| last.index() + 1)];
        Evaluation { plan, prime, seed, square_roots, values, choices: Choices::default(), position: 0 }
    }

    /// Evaluates the nodes from a position of the plan on.
    pub(super) fn run(&mut self, from: usize) -> Result<(), Halt> {
        let plan = self.plan;
        for (position, id) in plan.order.iter().enumerate().skip(from) {
            self.position = position;
            self.values[id.index()] = match self.value(*id) {
                Ok(value) => Some(value),
                Err(Halt::Undefined) => None,
                Err(halt) => return Err(halt),
            };
        }
        Ok(())
    }

    /// The value of an evaluated node.
    pub(super) fn number(&self, id: Id) -> Result<Element, Halt> {
        self.values[id.index()].ok_or(Halt::Undefined)
    }

    fn holds(&self, condition: Id) -> Result<bool, Halt> {
        Ok(!self.number(condition)?.is_zero())
    }

    fn value(&mut self, id: Id) -> Result<Element, Halt> {
        let (plan, prime) = (self.plan, self.prime);
        let holds = match plan.graph.node(id) {
            Node::Number(value) => return self.constant(*value),
            Node::Symbol(_) => return self.power(self.root_of_symbol(id), plan.arguments.power_of_symbol(id)),
            Node::Linear(constant, terms) => {
                return terms.iter().try_fold(self.constant(*constant)?, |sum, (c, term)| {
                    Ok(prime.sum(sum, prime.product(self.constant(*c)?, self.number(*term)?)))
                });
            }
            Node::Product(ids) => {
                return ids.iter().try_fold(Element::ONE, |product, id| Ok(prime.product(product, self.number(*id)?)));
            }
            Node::Power(base, exponent) => return self.ratio_power(*base, *exponent),
            Node::Call(function, args) => return self.call(*function, args),
            Node::Select(condition, first, second) => {
                return self.number(if self.holds(*condition)? { *first } else { *second });
            }
            Node::Compare(relation, a, b) => {
                let difference = prime.difference(self.number(*b)?, self.number(*a)?);
                relation.holds(Ordering::Equal, self.sign(difference)?)
            }
            // One operand may decide alone, even if the other one is undefined.
            Node::And(a, b) => match (self.holds(*a), self.holds(*b)) {
                (Ok(false), _) | (_, Ok(false)) => false,
                (a, b) => a.and(b)?,
            },
            Node::Or(a, b) => match (self.holds(*a), self.holds(*b)) {
                (Ok(true), _) | (_, Ok(true)) => true,
                (a, b) => a.and(b)?,
            },
            Node::Not(a) => !self.holds(*a)?,
            Node::Truth(holds) => *holds,
        };
        Ok(if holds { Element::ONE } else { Element::ZERO })
    }

    /// The value of a constant. Rounded numbers are unknowns.
    pub(super) fn constant(&self, value: Number) -> Result<Element, Halt> {
        match value {
            Number::Exact(ratio) => self.prime.ratio(ratio).ok_or(Halt::GiveUp),
            // Either root of a prime will do: an identity that holds for one holds for its conjugate.
            Number::Root(c, r) => {
                factors_of_radicand(r).into_iter().try_fold(self.prime.ratio(c).ok_or(Halt::GiveUp)?, |product, p| {
                    let p = self.prime.ratio(Ratio::integer(p.into())).ok_or(Halt::GiveUp)?;
                    Ok(self.prime.product(product, self.prime.root(p).ok_or(Halt::Redraw)?))
                })
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

    /// The unknown of which a symbol is a power.
    fn root_of_symbol(&self, symbol: Id) -> Element {
        self.unknown(SYMBOL, &[], symbol.index() as u64)
    }

    /// baseᵉ. The base may be a symbol that is a power itself.
    pub(super) fn ratio_power(&mut self, base: Id, exponent: Ratio) -> Result<Element, Halt> {
        if let Some(k) = self.plan.arguments.power_of_root(base, exponent) {
            return self.power(self.root_of_symbol(base), k);
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
        if self.square_roots == SquareRoots::Independent {
            return Ok(self.unknown(ROOT, &[radicand], 2));
        }
        let root = self.prime.root(radicand).ok_or(Halt::Redraw)?;
        let answer = self.choices.answer(Question::Root(radicand), 2, self.position).ok_or(Halt::GiveUp)?;
        Ok(if answer == 0 { root } else { self.prime.negative(root) })
    }

    /// The chosen order of a number relative to zero.
    fn sign(&mut self, x: Element) -> Result<Ordering, Halt> {
        let (size, is_negated) = self.prime.without_sign(x);
        if size.is_zero() {
            return Ok(Ordering::Equal);
        }
        let answers = if self.plan.zero_is_a_sign { 3 } else { 2 };
        match self.choices.answer(Question::Sign(size), answers, self.position).ok_or(Halt::GiveUp)? {
            ZERO => Ok(Ordering::Equal),
            answer if (answer == 1) == is_negated => Ok(Ordering::Greater),
            _ => Ok(Ordering::Less),
        }
    }

    /// Returns whether a number counts as negative. Zero does not.
    pub(super) fn is_negative(&mut self, x: Element) -> Result<bool, Halt> {
        Ok(self.sign(x)?.is_lt())
    }

    /// Returns whether the choices put this point on a boundary.
    pub(super) fn is_on_any(&self, boundaries: &OpenBoundaries) -> bool {
        boundaries.iter().any(|id| {
            let difference = match self.plan.graph.node(*id) {
                Node::Compare(_, a, b) => self.number(*b).and_then(|b| Ok(self.prime.difference(b, self.number(*a)?))),
                Node::Call(_, args) => self.number(args[0]),
                _ => return false,
            };
            difference.is_ok_and(|difference| {
                let (size, _) = self.prime.without_sign(difference);
                size.is_zero() || self.choices.known(Question::Sign(size)) == Some(ZERO)
            })
        })
    }

    /// The unknown for a function of these values. It is the same at every use in this point.
    pub(super) fn unknown(&self, kind: u64, values: &[Element], detail: u64) -> Element {
        let words = values.iter().flat_map(|value| [value.real, value.imaginary]);
        let words = [kind, detail].into_iter().chain(words);
        self.prime.unknown(words.fold(self.seed, |hash, word| pseudorandom(hash ^ pseudorandom(word))))
    }
}

/// The answer to [`Question::Sign`] by which a number is zero.
const ZERO: u8 = 2;

/// The kinds of unknowns. The kind of a function is its number above [`FUNCTION`].
const SYMBOL: u64 = 0;
const FLOAT: u64 = 1;
const ROOT: u64 = 2;
pub(super) const FUNCTION: u64 = 8;
