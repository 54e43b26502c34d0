//! Normal forms of nodes under the assumptions of a case.

use super::atoms::{Atoms, Kind};
use super::condition::{Assumptions, Comparison};
use super::normal::{Atom, Monomial, Normal, product_of_monomials};
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio, factors_of_radicand};
use std::rc::Rc;

/// The reason why a node has no normal form.
#[derive(Debug)]
pub(super) enum Stop {
    /// The case does not decide a condition.
    Undecided(Comparison),
    /// There are too many terms, or numbers are too long.
    TooLong,
}

/// Multiplies out nodes in one case.
pub(super) struct Expansion<'a> {
    graph: &'a Graph,
    assumptions: &'a Assumptions,
    pub(super) atoms: Atoms,
    /// Normal forms of visited nodes. A condition has the form 1 if it holds, and 0 otherwise.
    done: HashMap<Id, Rc<Normal>>,
    /// The number of products of two terms that may still be formed.
    products: usize,
}

impl<'a> Expansion<'a> {
    /// An expansion that may form `products` products of two terms.
    pub(super) fn new(graph: &'a Graph, assumptions: &'a Assumptions, products: usize) -> Self {
        let atoms = assumptions.atoms.clone();
        Expansion { graph, assumptions, atoms, done: HashMap::default(), products }
    }

    /// Returns the normal form of a node. An `if` needs only the branch that is taken.
    pub(super) fn normal(&mut self, root: Id) -> Result<Rc<Normal>, Stop> {
        let mut open = vec![root];
        while let Some(id) = open.last().copied() {
            let needed = self.needed(id);
            match needed.iter().find(|child| !self.done.contains_key(child)) {
                Some(child) => open.push(*child),
                None => {
                    let normal = self.of_known_operands(id)?;
                    self.done.insert(id, Rc::new(normal));
                    open.pop();
                }
            }
        }
        Ok(self.known(root))
    }

    /// The operands that the normal form of a node depends on, as far as conditions are known.
    fn needed(&self, id: Id) -> Vec<Id> {
        match self.graph.node(id) {
            Node::Select(condition, ..) if !self.done.contains_key(condition) => vec![*condition],
            Node::Select(condition, first, second) => vec![if self.holds(*condition) { *first } else { *second }],
            node => node.children(),
        }
    }

    fn known(&self, id: Id) -> Rc<Normal> {
        self.done.get(&id).cloned().unwrap_or_default()
    }

    fn holds(&self, condition: Id) -> bool {
        !self.known(condition).is_empty()
    }

    /// The normal form of a node whose needed operands are known.
    fn of_known_operands(&mut self, id: Id) -> Result<Normal, Stop> {
        let graph = self.graph;
        let holds = match graph.node(id) {
            Node::Number(value) => return Ok(self.constant(*value)),
            Node::Symbol(_) => return Ok(Normal::atom(self.atoms.of(Kind::Symbol(id)))),
            Node::Linear(constant, terms) => {
                let mut sum = self.constant(*constant);
                for (c, term) in terms {
                    let (c, term) = (self.constant(*c), self.known(*term));
                    let term = self.product(&c, &term)?;
                    sum = self.sum(sum, Ratio::ONE, &term)?;
                }
                return Ok(sum);
            }
            Node::Product(ids) => {
                let mut product = Normal::number(Ratio::ONE);
                for id in ids {
                    product = self.product(&product, &self.known(*id))?;
                }
                return Ok(product);
            }
            Node::Power(base, exponent) => return self.power(&self.known(*base), *exponent),
            Node::Call(function, args) => {
                let args: Vec<Rc<Normal>> = args.iter().map(|arg| self.known(*arg)).collect();
                return self.call(*function, &args);
            }
            Node::Select(condition, first, second) => {
                return Ok((*self.known(if self.holds(*condition) { *first } else { *second })).clone());
            }
            Node::Compare(relation, a, b) => {
                let difference = self.sum((*self.known(*b)).clone(), Ratio::integer(-1), &self.known(*a))?;
                match difference.as_number() {
                    Some(number) => relation.holds(Ratio::ZERO, number),
                    None => {
                        let comparison = Comparison::new(id, *relation, &difference).ok_or(Stop::TooLong)?;
                        self.assumptions.decide(&comparison).ok_or(Stop::Undecided(comparison))?
                    }
                }
            }
            Node::And(a, b) => self.holds(*a) && self.holds(*b),
            Node::Or(a, b) => self.holds(*a) || self.holds(*b),
            Node::Not(a) => !self.holds(*a),
            Node::Truth(holds) => *holds,
        };
        Ok(Normal::number(Ratio::integer(holds.into())))
    }

    fn constant(&mut self, value: Number) -> Normal {
        match value {
            Number::Exact(ratio) => Normal::number(ratio),
            Number::Root(c, r) => {
                let factors = factors_of_radicand(r).into_iter();
                let mut roots: Monomial =
                    factors.map(|p| (self.atoms.of(Kind::Ratio(Ratio::integer(p.into()))), Ratio::HALF)).collect();
                roots.sort_unstable();
                Normal::term(roots, c)
            }
            Number::Float(_) => {
                let magnitude = self.atoms.of(Kind::Float(value.to_f64().abs().to_bits()));
                let sign = if value.is_negative() { -1 } else { 1 };
                Normal::term(vec![(magnitude, Ratio::ONE)], Ratio::integer(sign))
            }
        }
    }

    /// a + factor·b.
    pub(super) fn sum(&self, a: Normal, factor: Ratio, b: &Normal) -> Result<Normal, Stop> {
        a.add(factor, b).ok_or(Stop::TooLong)
    }

    /// a·b, where powers of atoms are reduced.
    pub(super) fn product(&mut self, a: &Normal, b: &Normal) -> Result<Normal, Stop> {
        self.products = self.products.checked_sub(a.len() * b.len()).ok_or(Stop::TooLong)?;
        let mut product = Normal::default();
        for (left, c) in a.terms() {
            for (right, d) in b.terms() {
                let monomial = product_of_monomials(left, right).ok_or(Stop::TooLong)?;
                let coefficient = c.mul(d).ok_or(Stop::TooLong)?;
                match self.reducible(&monomial) {
                    None => product.add_term(monomial, coefficient).ok_or(Stop::TooLong)?,
                    Some(i) => {
                        let reduced = self.reduced(monomial, i)?;
                        product = self.sum(product, coefficient, &reduced)?;
                    }
                }
            }
        }
        Ok(product)
    }

    /// The index of the first factor of a monomial whose power has to be reduced.
    fn reducible(&self, monomial: &Monomial) -> Option<usize> {
        let too_high = |(atom, exponent): &(Atom, Ratio)| {
            self.atoms.reducible_from(*atom).is_some_and(|from| *exponent >= Ratio::integer(from))
        };
        monomial.iter().position(too_high)
    }

    /// A monomial in which the power of the `i`-th factor is reduced.
    fn reduced(&mut self, mut monomial: Monomial, i: usize) -> Result<Normal, Stop> {
        let (atom, exponent) = monomial[i];
        let from = self.atoms.reducible_from(atom).unwrap_or(1);
        let times = exponent.floor() / from;
        let left = exponent.add(Ratio::integer(-times * from)).ok_or(Stop::TooLong)?;
        if left == Ratio::ZERO {
            monomial.remove(i);
        } else {
            monomial[i].1 = left;
        }
        let replacement = match self.atoms.kind(atom).clone() {
            Kind::Sum(base) | Kind::Cbrt(base) => base,
            Kind::Ratio(ratio) => Normal::number(ratio),
            Kind::Call(_, args) => {
                // cos² = 1 − sin².
                let sine = self.atoms.of(Kind::Call(Function::Sin, args));
                let square = Normal::term(vec![(sine, Ratio::integer(2))], Ratio::integer(-1));
                self.sum(square, Ratio::ONE, &Normal::number(Ratio::ONE))?
            }
            _ => Normal::atom(atom),
        };
        let mut product = Normal::number(Ratio::ONE);
        for _ in 0..times {
            product = self.product(&product, &replacement)?;
        }
        self.product(&Normal::term(monomial, Ratio::ONE), &product)
    }

    /// Returns whether a sum is zero wherever it is defined. Multiplies it by its denominators.
    pub(super) fn is_zero(&mut self, normal: &Normal) -> Result<bool, Stop> {
        let mut cleared = normal.clone();
        while let Some(denominator) = self.last_denominator(&cleared) {
            cleared = self.product(&Normal::term(vec![denominator], Ratio::ONE), &cleared)?;
        }
        Ok(cleared.is_empty())
    }

    /// The last reducible atom in a denominator, with the power that clears the denominator. Earlier atoms may occur inside of it.
    fn last_denominator(&self, normal: &Normal) -> Option<(Atom, Ratio)> {
        let factors = normal.terms().flat_map(|(monomial, _)| monomial);
        let negative =
            factors.filter(|(atom, exponent)| *exponent < Ratio::ZERO && self.atoms.reducible_from(*atom).is_some());
        let (last, lowest) = negative.max_by_key(|(atom, exponent)| (*atom, exponent.neg()))?;
        Some((*last, Ratio::integer(-lowest.floor())))
    }
}
