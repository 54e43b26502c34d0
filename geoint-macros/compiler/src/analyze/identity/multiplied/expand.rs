//! Multiplies out, under the assumptions of a case.

use super::atoms::{Atoms, Formula, Kind};
use super::condition::{Assumptions, Comparison};
use super::normal::{Atom, Normal, Powers, multiplied};
use crate::ir::{Graph, HashMap, Id, Node, Number, Ratio, Relation, factors_of_radicand};
use std::rc::Rc;

/// Why there is no normal form.
#[derive(Debug)]
pub(super) enum Stop {
    /// The case does not say which branch is taken.
    Undecided(Comparison),
    /// Too many terms, or numbers that are too long.
    TooLong,
}

/// What a node is.
#[derive(Clone, Debug)]
enum Value {
    Number(Rc<Normal>),
    Truth(bool),
}

/// The normal forms of nodes.
pub(super) struct Expansion<'a> {
    graph: &'a Graph,
    assumptions: &'a Assumptions,
    pub(super) atoms: Atoms,
    done: HashMap<Id, Value>,
    /// How many products of two terms may be formed yet.
    products: usize,
}

impl<'a> Expansion<'a> {
    pub(super) fn new(graph: &'a Graph, assumptions: &'a Assumptions, products: usize) -> Self {
        let atoms = assumptions.atoms.clone();
        Expansion { graph, assumptions, atoms, done: HashMap::default(), products }
    }

    /// The normal form of a number. Of an `if` only the branch that is taken is looked at.
    pub(super) fn normal(&mut self, root: Id) -> Result<Rc<Normal>, Stop> {
        let mut open = vec![root];
        while let Some(id) = open.last().copied() {
            let needed = self.needed(id);
            match needed.iter().find(|child| !self.done.contains_key(child)) {
                Some(child) => open.push(*child),
                None => {
                    let value = self.value(id)?;
                    self.done.insert(id, value);
                    open.pop();
                }
            }
        }
        Ok(self.number(root))
    }

    /// What has to be known before a node is.
    fn needed(&self, id: Id) -> Vec<Id> {
        match self.graph.node(id) {
            Node::Select(condition, first, second) => match self.done.get(condition) {
                Some(Value::Truth(true)) => vec![*first],
                Some(_) => vec![*second],
                None => vec![*condition],
            },
            node => node.children(),
        }
    }

    fn number(&self, id: Id) -> Rc<Normal> {
        match self.done.get(&id) {
            Some(Value::Number(normal)) => normal.clone(),
            _ => Rc::new(Normal::default()),
        }
    }

    fn holds(&self, id: Id) -> bool {
        matches!(self.done.get(&id), Some(Value::Truth(true)))
    }

    /// A node for which all is known that is needed.
    fn value(&mut self, id: Id) -> Result<Value, Stop> {
        let number = |normal| Ok(Value::Number(Rc::new(normal)));
        match self.graph.node(id).clone() {
            Node::Number(value) => number(self.constant(value)),
            Node::Symbol(_) => number(Normal::atom(self.atoms.of(Kind::Symbol(id)))),
            Node::Linear(constant, terms) => {
                let mut sum = self.constant(constant);
                for (c, term) in terms {
                    let (c, term) = (self.constant(c), self.number(term));
                    let term = self.product(&c, &term)?;
                    sum = self.sum(sum, Ratio::ONE, &term)?;
                }
                number(sum)
            }
            Node::Product(ids) => {
                let mut product = Normal::number(Ratio::ONE);
                for id in ids {
                    let factor = self.number(id);
                    product = self.product(&product, &factor)?;
                }
                number(product)
            }
            Node::Power(base, exponent) => {
                let base = self.number(base);
                number(self.power(&base, exponent)?)
            }
            Node::Call(function, args) => {
                let args: Vec<Rc<Normal>> = args.iter().map(|arg| self.number(*arg)).collect();
                number(self.call(function, &args)?)
            }
            Node::Select(condition, first, second) => {
                number((*self.number(if self.holds(condition) { first } else { second })).clone())
            }
            Node::Compare(relation, a, b) => {
                let difference = self.sum((*self.number(b)).clone(), Ratio::integer(-1), &self.number(a))?;
                Ok(Value::Truth(self.compare(id, relation, &difference)?))
            }
            Node::And(a, b) => Ok(Value::Truth(self.holds(a) && self.holds(b))),
            Node::Or(a, b) => Ok(Value::Truth(self.holds(a) || self.holds(b))),
            Node::Not(a) => Ok(Value::Truth(!self.holds(a))),
            Node::Truth(value) => Ok(Value::Truth(value)),
        }
    }

    /// Whether a difference right − left is as it has to be.
    fn compare(&mut self, id: Id, relation: Relation, difference: &Normal) -> Result<bool, Stop> {
        if let Some(number) = difference.as_number() {
            return Ok(match relation {
                Relation::Less => number > Ratio::ZERO,
                Relation::LessEqual => number >= Ratio::ZERO,
                Relation::Equal => number == Ratio::ZERO,
            });
        }
        let comparison = Comparison::new(id, relation, difference).ok_or(Stop::TooLong)?;
        self.assumptions.decide(&comparison).ok_or(Stop::Undecided(comparison))
    }

    fn constant(&mut self, value: Number) -> Normal {
        match value {
            Number::Exact(ratio) => Normal::number(ratio),
            Number::Root(c, r) => {
                let factors = factors_of_radicand(r).into_iter();
                let mut powers: Powers =
                    factors.map(|p| (self.atoms.of(Kind::Ratio(Ratio::integer(p.into()))), Ratio::HALF)).collect();
                powers.sort_unstable();
                Normal::term(powers, c)
            }
            Number::Float(_) => {
                let magnitude = self.atoms.of(Kind::Float(value.to_f64().abs().to_bits()));
                let sign = if value.is_negative() { -1 } else { 1 };
                Normal::term(vec![(magnitude, Ratio::ONE)], Ratio::integer(sign))
            }
        }
    }

    // ------------------------------------------------------------------------------------------ sums and products

    /// a + factor·b.
    pub(super) fn sum(&self, a: Normal, factor: Ratio, b: &Normal) -> Result<Normal, Stop> {
        a.add(factor, b).ok_or(Stop::TooLong)
    }

    pub(super) fn product(&mut self, a: &Normal, b: &Normal) -> Result<Normal, Stop> {
        self.products = self.products.checked_sub(a.len() * b.len()).ok_or(Stop::TooLong)?;
        let mut product = Normal::default();
        for (left, c) in a.terms() {
            for (right, d) in b.terms() {
                let powers = multiplied(left, right).ok_or(Stop::TooLong)?;
                let coefficient = c.mul(d).ok_or(Stop::TooLong)?;
                match self.reducible(&powers) {
                    None => product.add_term(powers, coefficient).ok_or(Stop::TooLong)?,
                    Some(i) => {
                        let reduced = self.reduced(powers, i)?;
                        product = self.sum(product, coefficient, &reduced)?;
                    }
                }
            }
        }
        Ok(product)
    }

    /// The place of an atom in a monomial that can be written without that power.
    fn reducible(&self, powers: &Powers) -> Option<usize> {
        let too_high = |(atom, exponent): &(Atom, Ratio)| {
            self.atoms.reducible_from(*atom).is_some_and(|from| *exponent >= Ratio::integer(from))
        };
        powers.iter().position(too_high)
    }

    /// A monomial without the whole powers of its `i`-th atom.
    fn reduced(&mut self, mut powers: Powers, i: usize) -> Result<Normal, Stop> {
        let (atom, exponent) = powers[i];
        let from = self.atoms.reducible_from(atom).unwrap_or(1);
        let times = exponent.floor() / from;
        let left = exponent.add(Ratio::integer(-times * from)).ok_or(Stop::TooLong)?;
        if left == Ratio::ZERO {
            powers.remove(i);
        } else {
            powers[i].1 = left;
        }
        let unit = match self.atoms.kind(atom).clone() {
            Kind::Sum(base) | Kind::Cbrt(base) => base,
            Kind::Ratio(ratio) => Normal::number(ratio),
            Kind::Call(_, args) => {
                // cos² = 1 − sin².
                let sine = self.atoms.of(Kind::Call(crate::ir::Function::Sin, args));
                let square = Normal::term(vec![(sine, Ratio::integer(2))], Ratio::integer(-1));
                self.sum(square, Ratio::ONE, &Normal::number(Ratio::ONE))?
            }
            _ => Normal::atom(atom),
        };
        let mut product = Normal::number(Ratio::ONE);
        for _ in 0..times {
            product = self.product(&product, &unit)?;
        }
        self.product(&Normal::term(powers, Ratio::ONE), &product)
    }

    // ----------------------------------------------------------------------------------------------------- results

    /// Whether a sum is zero wherever it is defined: it is multiplied by what it is divided by.
    pub(super) fn is_zero(&mut self, normal: &Normal) -> Result<bool, Stop> {
        let mut cleared = normal.clone();
        while let Some((atom, times)) = self.divisor(&cleared) {
            let mut product = Normal::default();
            for (powers, coefficient) in cleared.terms() {
                let powers = multiplied(powers, &vec![(atom, times)]).ok_or(Stop::TooLong)?;
                let reduced = self.product(&Normal::number(Ratio::ONE), &Normal::term(powers, Ratio::ONE))?;
                product = self.sum(product, coefficient, &reduced)?;
            }
            cleared = product;
        }
        Ok(cleared.is_empty())
    }

    /// The last atom that is divided by and could be reduced, and how often: earlier ones may be inside of it.
    fn divisor(&self, normal: &Normal) -> Option<(Atom, Ratio)> {
        let powers = normal.terms().flat_map(|(powers, _)| powers);
        let negative =
            powers.filter(|(atom, exponent)| *exponent < Ratio::ZERO && self.atoms.reducible_from(*atom).is_some());
        let (last, lowest) = negative.max_by_key(|(atom, exponent)| (*atom, exponent.neg()))?;
        Some((*last, Ratio::integer(-lowest.floor())))
    }

    /// Whether a sum that is not empty is certainly not zero everywhere: it is one term, or made of symbols and numbers alone.
    pub(super) fn is_plain(&self, normal: &Normal) -> bool {
        let plain = |(atom, _): &(Atom, Ratio)| matches!(self.atoms.kind(*atom), Kind::Symbol(_));
        normal.len() == 1 || normal.terms().all(|(powers, _)| powers.iter().all(plain))
    }

    /// A sum, to be written as a node.
    pub(super) fn formula(&self, normal: &Normal) -> Formula {
        Formula { atoms: self.atoms.clone(), normal: normal.clone() }
    }
}
