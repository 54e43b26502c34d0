//! Sums, products and powers as operations of two operands, in an order that keeps the processor busy.

use super::block::{Instruction, Operand};
use super::lowering::{Lowering, Of, Powers};
use crate::analyze::has_edge;
use crate::ir::{HashMap, Id, Node, Number, Ratio, Symbol};

/// A summand or factor: a sign and a value, or a product that has not been taken yet.
#[derive(Clone, Copy)]
struct Term {
    negative: bool,
    value: Operand,
    times: Option<Operand>,
}

impl<F: Fn(Symbol) -> usize> Lowering<'_, F> {
    // -------------------------------------------------------------------------------------------------------- sums

    pub(super) fn linear(&mut self, constant: Number, terms: Vec<(Number, Id)>) -> Operand {
        let (constant, terms) = self.spread(constant, terms);
        // What is known earlier is added up earlier.
        let (mut now, mut early) = (vec![], vec![]);
        for (c, id) in terms {
            if self.is_now(id) { now.push((c, id)) } else { early.push((c, id)) }
        }
        let now = self.factored(now);
        // What is there and needs no sign: others are added to it.
        let has_start = now.iter().any(|(c, id)| c.is_one() && !matches!(self.graph.node(*id), Node::Product(_)));
        let mut summands = vec![];
        match early[..] {
            [] if constant.is_zero() => {}
            [] => summands.push(Term {
                negative: constant.is_negative(),
                value: Operand::Constant(if constant.is_negative() { constant.neg() } else { constant }),
                times: None,
            }),
            [(Number::MINUS_ONE, id)] if constant.is_zero() && has_start => {
                let value = self.operand(id);
                summands.push(Term { negative: true, value, times: None });
            }
            _ => {
                let sum = self.graph.linear(constant, early);
                let value = self.operand(sum);
                summands.push(Term { negative: false, value, times: None });
            }
        }
        for (c, id) in now {
            let (c, id) = self.multiple(c, id);
            let (c, id) = self.as_product(c, id);
            summands.push(self.summand(c, id));
        }
        // What is there last is added last. Start with something that is there already and needs no sign.
        if summands.len() > 1 {
            summands.sort_by_key(|term| self.ready(&term.value).max(term.times.map_or(0, |times| self.ready(&times))));
        }
        let start = summands
            .iter()
            .position(|term| !term.negative && term.times.is_none())
            .or_else(|| summands.iter().position(|term| !term.negative))
            .unwrap_or(0);
        let first = summands.remove(start);
        let mut sum = self.single(first);
        for term in summands {
            sum = match term {
                Term { negative: false, value, times: None } => self.emit(Instruction::Add(sum, value)),
                Term { negative: true, value, times: None } => self.emit(Instruction::Sub(sum, value)),
                Term { negative, value, times: Some(other) } => {
                    let value = if negative { self.emit(Instruction::Neg(value)) } else { value };
                    self.emit(Instruction::MulAdd(value, other, sum))
                }
            };
        }
        sum
    }

    /// c·(sum) as the sum of its multiples, if that is needed anyway: ½(2q + d) is the mean q + d/2. Of a power of two the bits are the same, but
    /// for numbers that are too small or too large to keep all of theirs.
    pub(super) fn multiple(&mut self, c: Number, id: Id) -> (Number, Id) {
        let Node::Linear(constant, terms) = self.graph.node(id) else { return (c, id) };
        let (constant, terms) = (constant.mul(c), terms.iter().map(|(k, id)| (k.mul(c), *id)).collect());
        let sum = self.graph.linear(constant, terms);
        if self.uses.contains(sum) { (Number::ONE, sum) } else { (c, id) }
    }

    /// Whether a node is computed at this level.
    pub(super) fn is_now(&mut self, id: Id) -> bool {
        matches!(self.levels.of(self.graph, id), Some(level) if level == self.level)
    }

    /// A term as one value.
    fn single(&mut self, term: Term) -> Operand {
        let value = match term.times {
            Some(other) => self.emit(Instruction::Mul(term.value, other)),
            None => term.value,
        };
        if term.negative { self.emit(Instruction::Neg(value)) } else { value }
    }

    // ---------------------------------------------------------------------------------------------------- products

    pub(super) fn product(&mut self, id: Id) -> Operand {
        let term = self.summand(Number::ONE, id);
        self.single(term)
    }

    /// c·node, its last multiplication left to be fused. What is known earlier is multiplied earlier, c with it.
    fn summand(&mut self, c: Number, id: Id) -> Term {
        let (mut now, mut early) = (vec![], vec![]);
        self.by_level(id, &mut now, &mut early);
        let mut negative = c.is_negative() && early.is_empty();
        let mut above = vec![];
        if !early.is_empty() || (c != Number::ONE && c != Number::MINUS_ONE) {
            let prefactor = self.graph.product(&early);
            let prefactor = self.graph.scale(c, prefactor);
            if self.absorbed(prefactor, &mut now) {
                negative = false;
            } else if early.is_empty() {
                above.push(Operand::Constant(if negative { c.neg() } else { c }));
            } else {
                above.push(self.operand(prefactor));
            }
        }
        let mut below = vec![];
        for id in now {
            match *self.graph.node(id) {
                Node::Power(base, exponent)
                    if exponent.numerator < 0
                        && self.is_single(id)
                        && !self.reciprocals.contains_key(&(base, Powers::of(exponent))) =>
                {
                    below.push(self.positive_power(base, exponent));
                }
                _ => above.push(self.operand(id)),
            }
        }
        // What is there last is multiplied last.
        above.sort_by_key(|factor| self.ready(factor));
        let denominator = below.into_iter().reduce(|a, b| self.emit(Instruction::Mul(a, b)));
        let last = if denominator.is_none() && above.len() > 1 { above.pop() } else { None };
        let mut numerator = None;
        for factor in above {
            numerator = Some(numerator.map_or(factor, |product| self.emit(Instruction::Mul(product, factor))));
        }
        let value = match (numerator, denominator) {
            (Some(a), Some(b)) => self.emit(Instruction::Div(a, b)),
            (None, Some(b)) => self.emit(Instruction::Div(Operand::Constant(Number::ONE), b)),
            (Some(a), None) => a,
            (None, None) => Operand::Constant(Number::ONE),
        };
        Term { negative, value, times: last }
    }

    /// The factors of a product, taken apart where nothing else needs it as a whole.
    pub(super) fn flat_factors(&self, id: Id, root: bool, factors: &mut Vec<Id>) {
        match self.graph.node(id) {
            Node::Product(ids) if root || self.is_single(id) => {
                for id in ids {
                    self.flat_factors(*id, false, factors);
                }
            }
            _ => factors.push(id),
        }
    }

    /// Whether a node has one use and no value yet.
    pub(super) fn is_single(&self, id: Id) -> bool {
        self.uses.get(id).is_none_or(|uses| uses <= 1) && self.known(id).is_none()
    }

    // ------------------------------------------------------------------------------------------------------ powers

    pub(super) fn find_reciprocals(&mut self, reachable: &[Id]) {
        let mut powers: HashMap<Id, [Vec<Id>; 2]> = HashMap::default();
        for id in reachable {
            match *self.graph.node(*id) {
                Node::Power(base, exponent)
                    if exponent.numerator < 0 && self.levels.of(self.graph, *id) == Some(self.level) =>
                {
                    powers.entry(base).or_default()[usize::from(exponent.is_integer())].push(*id);
                }
                _ => {}
            }
        }
        for (base, [halves, whole]) in powers {
            // √x serves whole powers where no x has one but no other.
            let together = halves.first().is_some_and(|half| !whole.is_empty() && !has_edge(self.graph, *half));
            if together || halves.len() > 1 {
                self.reciprocals.insert((base, Powers::Halves), Of::Root);
            }
            if together || whole.len() > 1 {
                self.reciprocals.insert((base, Powers::Whole), if together { Of::Root } else { Of::Base });
            }
        }
    }

    pub(super) fn power(&mut self, base: Id, exponent: Ratio) -> Operand {
        let n = exponent.numerator.unsigned_abs();
        let powers = Powers::of(exponent);
        if let (true, Some(of)) = (exponent.numerator < 0, self.reciprocals.get(&(base, powers)).copied()) {
            let x = self.operand(base);
            let x = if of == Of::Root { self.emit(Instruction::Sqrt(x)) } else { x };
            let reciprocal = self.emit(Instruction::Div(Operand::Constant(Number::ONE), x));
            return self.repeated(reciprocal, if (powers, of) == (Powers::Whole, Of::Root) { 2 * n } else { n });
        }
        let power = self.positive_power(base, exponent);
        if exponent.numerator < 0 { self.emit(Instruction::Div(Operand::Constant(Number::ONE), power)) } else { power }
    }

    /// base to the magnitude of an exponent, by squaring, with one square root for halves.
    fn positive_power(&mut self, base: Id, exponent: Ratio) -> Operand {
        let x = self.operand(base);
        let n = exponent.numerator.unsigned_abs();
        if exponent.is_integer() {
            return self.repeated(x, n);
        }
        let root = self.emit(Instruction::Sqrt(x));
        match n / 2 {
            0 => root,
            whole => {
                let power = self.repeated(x, whole);
                self.emit(Instruction::Mul(power, root))
            }
        }
    }

    /// xⁿ for n ≥ 1.
    fn repeated(&mut self, x: Operand, n: u128) -> Operand {
        if n <= 1 {
            return x;
        }
        let half = self.repeated(x, n / 2);
        let square = self.emit(Instruction::Mul(half, half));
        if n.is_multiple_of(2) { square } else { self.emit(Instruction::Mul(square, x)) }
    }
}
