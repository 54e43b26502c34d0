//! Lowers sums, products and powers to operations of two operands. Their order keeps the processor busy.

use super::instruction::{Instruction, Operand};
use super::lowering::{Lowering, Of, Powers};
use crate::analyze::has_edge;
use crate::ir::{HashMap, Id, Node, Number, Ratio, Symbol};

/// A summand with its sign: a value, or a product whose last multiplication may be fused with the sum.
#[derive(Clone, Copy)]
struct Term {
    negative: bool,
    value: Operand,
    times: Option<Operand>,
}

impl<F: Fn(Symbol) -> usize> Lowering<'_, F> {
    // -------------------------------------------------------------------------------------------------------- sums

    /// Lowers a sum: a constant, and nodes with their coefficients.
    pub(super) fn linear(&mut self, constant: Number, terms: Vec<(Number, Id)>) -> Operand {
        let (constant, terms) = self.spread(constant, terms);
        // Terms of earlier levels are added there.
        let (mut now, mut early) = (vec![], vec![]);
        for (c, id) in terms {
            if self.is_now(id) { now.push((c, id)) } else { early.push((c, id)) }
        }
        let now = self.factored(now);
        // The sum can start with a term without a sign and without a product.
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
        // Terms are added in the order in which they are ready. The sum starts with a term without a sign, and without a product if possible.
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

    /// Returns c·(sum) as the sum of its multiples, if the routine needs this sum anyway: ½(2q + d) is the mean q + d/2. If c is a power
    /// of two, the bits are equal, unless a number underflows or overflows.
    pub(super) fn multiple(&mut self, c: Number, id: Id) -> (Number, Id) {
        let Node::Linear(constant, terms) = self.graph.node(id) else { return (c, id) };
        let (constant, terms) = (constant.mul(c), terms.iter().map(|(k, id)| (k.mul(c), *id)).collect());
        let sum = self.graph.linear(constant, terms);
        if self.uses.contains(sum) { (Number::ONE, sum) } else { (c, id) }
    }

    /// Returns whether a node is computed at this level.
    pub(super) fn is_now(&mut self, id: Id) -> bool {
        matches!(self.levels.of(self.graph, id), Some(level) if level == self.level)
    }

    /// Lowers a term to a value.
    fn single(&mut self, term: Term) -> Operand {
        let value = match term.times {
            Some(other) => self.emit(Instruction::Mul(term.value, other)),
            None => term.value,
        };
        if term.negative { self.emit(Instruction::Neg(value)) } else { value }
    }

    // ---------------------------------------------------------------------------------------------------- products

    /// Lowers a product.
    pub(super) fn product(&mut self, id: Id) -> Operand {
        let term = self.summand(Number::ONE, id);
        self.single(term)
    }

    /// Lowers c·node without its last multiplication. Factors of earlier levels are multiplied there, together with c.
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
        // Factors are multiplied in the order in which they are ready.
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

    /// Collects the factors of a node. A product with other uses is a single factor.
    pub(super) fn flat_factors(&self, id: Id, factors: &mut Vec<Id>) {
        match self.graph.node(id) {
            Node::Product(_) if self.is_single(id) => self.divided_factors(id, factors),
            _ => factors.push(id),
        }
    }

    /// Collects the factors of a node. A product is divided, even if it has other uses.
    pub(super) fn divided_factors(&self, id: Id, factors: &mut Vec<Id>) {
        match self.graph.node(id) {
            Node::Product(ids) => ids.iter().for_each(|id| self.flat_factors(*id, factors)),
            _ => factors.push(id),
        }
    }

    /// Returns whether a node has a single use and no value yet.
    pub(super) fn is_single(&self, id: Id) -> bool {
        self.uses.get(id).is_none_or(|uses| uses <= 1) && self.known(id).is_none()
    }

    // ------------------------------------------------------------------------------------------------------ powers

    /// Finds the bases of several negative powers. One division serves them all.
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
            // 1/√x may also serve whole powers, unless x is negative somewhere: 1/x exists there, but √x does not.
            let together = halves.first().is_some_and(|half| !whole.is_empty() && !has_edge(self.graph, *half));
            if together || halves.len() > 1 {
                self.reciprocals.insert((base, Powers::Halves), Of::Root);
            }
            if together || whole.len() > 1 {
                self.reciprocals.insert((base, Powers::Whole), if together { Of::Root } else { Of::Base });
            }
        }
    }

    /// Lowers a power.
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

    /// Lowers the base to the magnitude of an exponent: by squaring, and one square root for half-integer exponents.
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

    /// Lowers xⁿ for n ≥ 1.
    fn repeated(&mut self, x: Operand, n: u128) -> Operand {
        if n <= 1 {
            return x;
        }
        let half = self.repeated(x, n / 2);
        let square = self.emit(Instruction::Mul(half, half));
        if n.is_multiple_of(2) { square } else { self.emit(Instruction::Mul(square, x)) }
    }
}
