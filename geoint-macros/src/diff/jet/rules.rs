//! The recurrence of every operation: one exhaustive match for nodes.
//!
//! R. E. Moore, *Interval Analysis* (1966) ch. 11; A. Griewank & A. Walther, *Evaluating Derivatives* (2008) tables 13.1 and 13.2;
//! À. Jorba & M. Zou, Exp. Math. 14 (2005) 99.

use super::{Builder, Factor, Rule};
use crate::ir::{Function, Id, Node, Number, Ratio, Symbol};

impl Builder<'_> {
    /// The rule of a node; of a number of the step, which a simplification may have made, all coefficients are zero.
    pub(super) fn rule(&mut self, id: Id) -> Rule {
        if self.is_constant(id) {
            return Rule::Linear(vec![]);
        }
        if let Some(slope) = self.slope(id) {
            return Rule::Affine(self.value(slope));
        }
        match self.graph.node(id).clone() {
            Node::Symbol(symbol) => Rule::State(symbol),
            Node::Linear(_, terms) => {
                let terms = self.factored(terms).into_iter();
                let terms = terms.filter_map(|(c, term)| Some((Factor::Number(c), self.source(term)?)));
                let mut terms: Vec<_> = terms.collect();
                // What is known last is added last.
                terms.sort_by_key(|(_, source)| {
                    let id = self.jet.values[self.jet.series[*source].value];
                    self.depth(id)
                });
                Rule::Linear(terms)
            }
            Node::Product(factors) => self.product(&factors),
            Node::Power(base, exponent) => self.power(base, exponent),
            Node::Call(function, args) => self.call(id, function, &args),
            Node::Select(condition, first, second) => self.select(condition, first, second),
            Node::Number(_) | Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_) | Node::Truth(_) => {
                unreachable!("numbers and conditions have no series")
            }
        }
    }

    /// The derivative by time of a function a + b·t.
    pub(super) fn slope(&mut self, id: Id) -> Option<Id> {
        let reads = self.graph.reads(id);
        if reads.state() {
            return None;
        }
        match self.graph.node(id).clone() {
            Node::Symbol(Symbol::T) => Some(self.graph.integer(1)),
            Node::Linear(_, terms) => {
                let mut sum = self.graph.zero();
                for (c, term) in terms.into_iter().filter(|(_, term)| self.graph.reads(*term).t).collect::<Vec<_>>() {
                    let slope = self.slope(term)?;
                    let slope = self.graph.scale(c, slope);
                    sum = self.graph.add(sum, slope);
                }
                Some(sum)
            }
            Node::Product(factors) => {
                let (moving, constant): (Vec<Id>, Vec<Id>) =
                    factors.into_iter().partition(|factor| !self.is_constant(*factor));
                let [moving] = moving[..] else { return None };
                let slope = self.slope(moving)?;
                let constant = self.graph.product(&constant);
                Some(self.graph.mul(constant, slope))
            }
            _ => None,
        }
    }

    fn product(&mut self, factors: &[Id]) -> Rule {
        let (constant, mut moving): (Vec<Id>, Vec<Id>) = factors.iter().partition(|factor| self.is_constant(**factor));
        if !constant.is_empty() {
            let constant = self.graph.product(&constant);
            let moving = self.graph.product(&moving);
            let (c, moving) = self.graph.coefficient(moving);
            let constant = self.graph.scale(c, constant);
            return self.scaled(constant, moving);
        }
        // What is constant in a step alone.
        let sign = moving.iter().position(|factor| matches!(self.graph.node(*factor), Node::Call(Function::Signum, _)));
        if let (Some(sign), true) = (sign, moving.len() > 1) {
            let sign = moving.remove(sign);
            self.series(sign);
            let rest = self.graph.product(&moving);
            return self.scaled(sign, rest);
        }
        // A reciprocal that nothing else reads is divided by.
        let single = moving.iter().position(|factor| {
            matches!(self.graph.node(*factor), Node::Power(_, Ratio { numerator: -1, denominator: 1 }))
                && self.uses.get(factor) == Some(&1)
        });
        if let Some(place) = single {
            let Node::Power(base, _) = *self.graph.node(moving.remove(place)) else { unreachable!() };
            let numerator = self.graph.product(&moving);
            if let Some(rule) = self.source(numerator).map(|numerator| Rule::Quotient(numerator, self.series(base))) {
                return rule;
            }
        }
        moving.sort_by_key(|factor| self.depth(*factor));
        let last = moving.pop().unwrap_or(factors[0]);
        let first = self.graph.product(&moving);
        self.times(first, last)
    }

    /// a·b for series a and b, where b is known last.
    fn times(&mut self, a: Id, b: Id) -> Rule {
        if a == b {
            return Rule::Square(self.series(a));
        }
        for (affine, other) in [(a, b), (b, a)] {
            if let Some(slope) = self.slope(affine) {
                let (start, slope) = (self.value(affine), self.value(slope));
                return Rule::Shift { start, slope, of: self.series(other) };
            }
        }
        Rule::Product(self.series(a), self.series(b))
    }

    /// factor·u for a number of the step.
    pub(super) fn scaled(&mut self, factor: Id, u: Id) -> Rule {
        let factor = self.factor(factor);
        Rule::Linear(self.source(u).map(|source| (factor, source)).into_iter().collect())
    }

    pub(super) fn factor(&mut self, id: Id) -> Factor {
        match self.graph.as_number(id) {
            Some(number) => Factor::Number(number),
            None => Factor::Value(self.value(id)),
        }
    }

    fn power(&mut self, base: Id, exponent: Ratio) -> Rule {
        // The square of a reciprocal stands beside other squares; the power rule has a sum of its own kind.
        if exponent == Ratio::integer(-2) {
            let reciprocal = self.graph.recip(base);
            return Rule::Square(self.series(reciprocal));
        }
        if !exponent.is_integer() || exponent.numerator < 0 {
            let u = self.series(base);
            return match exponent {
                Ratio { numerator: -1, denominator: 1 } => Rule::Reciprocal(u),
                Ratio { numerator: 1, denominator: 2 } => Rule::Root(u),
                _ => Rule::Power(u, Factor::Number(Number::Exact(exponent))),
            };
        }
        // The power rule divides by the base, which may be zero.
        let half = Ratio::integer(exponent.numerator / 2);
        let rest = Ratio::integer(exponent.numerator - half.numerator);
        let [half, rest] = [half, rest].map(|exponent| self.graph.pow(base, exponent));
        self.times(half, rest)
    }

    pub(super) fn select(&mut self, condition: Id, first: Id, second: Id) -> Rule {
        self.switch(condition);
        let value = self.value(condition);
        if !self.jet.conditions.contains(&value) {
            self.jet.conditions.push(value);
        }
        Rule::Select(value, self.source(first), self.source(second))
    }

    /// What decides a condition.
    fn switch(&mut self, condition: Id) {
        match *self.graph.node(condition) {
            Node::Compare(_, a, b) => {
                let difference = self.graph.sub(a, b);
                self.decides(difference);
            }
            Node::And(a, b) | Node::Or(a, b) => {
                self.switch(a);
                self.switch(b);
            }
            Node::Not(a) => self.switch(a),
            _ => {}
        }
    }

    /// A number whose sign decides.
    pub(super) fn decides(&mut self, id: Id) {
        if self.is_constant(id) {
            return;
        }
        let switch = (self.value(id), self.source(id));
        if !self.jet.switches.contains(&switch) {
            self.jet.switches.push(switch);
        }
    }
}
