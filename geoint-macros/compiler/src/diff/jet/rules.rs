//! The recurrences of operations, in one exhaustive match over nodes.
//!
//! R. E. Moore, *Interval Analysis* (1966) ch. 11; A. Griewank & A. Walther, *Evaluating Derivatives* (2008) tables 13.1 and 13.2;
//! À. Jorba & M. Zou, Exp. Math. 14 (2005) 99.

use super::{Builder, Factor, Rule};
use crate::ir::{Function, Id, Node, Number, Ratio, Symbol};

impl Builder<'_> {
    /// The rule of a node. All coefficients are zero if a simplification has made the node constant.
    pub(super) fn rule(&mut self, id: Id) -> Rule {
        if self.is_constant(id) {
            return Rule::Linear(vec![]);
        }
        if let Some(slope) = self.slope(id) {
            return Rule::Affine(self.value(slope));
        }
        match self.graph.node(id).clone() {
            Node::Symbol(symbol) => Rule::State(symbol),
            Node::Linear(_, terms) => match self.with_other_sign(id) {
                Some(other) => self.scaled_by(Number::MINUS_ONE, other),
                None => self.linear(terms),
            },
            Node::Product(_) => self.product(id),
            Node::Power(base, exponent) => {
                let (constant, moving) = self.parted(id);
                if moving == id { self.power(base, exponent) } else { self.scaled(constant, moving) }
            }
            Node::Call(function, args) => self.call(id, function, &args),
            Node::Select(condition, first, second) => self.select(condition, first, second),
            Node::Number(_) | Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_) | Node::Truth(_) => {
                unreachable!("numbers and conditions have no series")
            }
        }
    }

    /// The slope b of a function a + b·t of time. Returns `None` for other nodes.
    pub(super) fn slope(&mut self, id: Id) -> Option<Id> {
        let reads = self.graph.reads(id);
        if reads.state() {
            return None;
        }
        match self.graph.node(id).clone() {
            Node::Symbol(Symbol::Time) => Some(self.graph.integer(1)),
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

    /// The negative of a sum, if it has the sign that the graph gives to bases of squares, and is read.
    fn with_other_sign(&mut self, id: Id) -> Option<Id> {
        if !self.graph.leads_negative(id) || self.graph.coefficient(id).1 != id {
            return None;
        }
        let other = self.graph.negated_sum(id);
        self.uses.contains_key(&other).then_some(other)
    }

    /// A sum of terms, factored and with like terms joined.
    fn linear(&mut self, terms: Vec<(Number, Id)>) -> Rule {
        let mut parts: Vec<(Id, Id)> = vec![];
        for (c, term) in self.factored(terms) {
            if self.is_constant(term) {
                continue;
            }
            let (constant, moving) = self.parted(term);
            let factor = self.graph.scale(c, constant);
            let (factor, moving) = self.of_one_term(factor, moving);
            match parts.iter_mut().find(|(_, other)| *other == moving) {
                Some((sum, _)) => *sum = self.graph.add(*sum, factor),
                None => parts.push((factor, moving)),
            }
        }
        let mut parts = self.with_squares_together(parts);
        if let [(factor, moving)] = parts[..]
            && self.graph.as_number(factor) == Some(Number::ONE)
            && let Some(bases) = self.own_squares(moving)
        {
            return Rule::Squares(bases.into_iter().map(|base| self.series(base)).collect());
        }
        // The terms that are computed last are added last.
        parts.sort_by_key(|(_, moving)| self.depth(*moving));
        let terms = parts.into_iter().filter_map(|(factor, moving)| {
            let source = self.source(moving)?;
            Some((self.factor(factor), source))
        });
        Rule::Linear(terms.collect())
    }

    /// Splits a moving node into a constant factor and the moving rest. Constants are taken out of nested products, so that a series is scaled once
    /// and equal products of series share one series.
    pub(super) fn parted(&mut self, id: Id) -> (Id, Id) {
        let (c, inner) = self.graph.coefficient(id);
        let mut constant = self.graph.number(c);
        let factors = match self.graph.node(inner).clone() {
            Node::Product(factors) => factors,
            Node::Power(base, exponent) if exponent.is_integer() && !self.is_constant(base) => {
                let (number, rest) = self.parted(base);
                let [number, rest] = [number, rest].map(|base| self.graph.pow(base, exponent));
                return (self.graph.mul(constant, number), rest);
            }
            _ => return (constant, inner),
        };
        let mut moving = vec![];
        for factor in factors {
            if self.is_constant(factor) {
                constant = self.graph.mul(constant, factor);
                continue;
            }
            let (number, rest) = self.parted(factor);
            constant = self.graph.mul(constant, number);
            moving.push(rest);
        }
        let moving = self.graph.product(&moving);
        let (c, moving) = self.graph.coefficient(moving);
        (self.graph.scale(c, constant), moving)
    }

    /// Replaces a sum with one moving term by that term. Only the value of order 0 differs.
    fn of_one_term(&mut self, mut factor: Id, mut moving: Id) -> (Id, Id) {
        while let Node::Linear(_, terms) = self.graph.node(moving) {
            let mut terms = terms.iter().copied().filter(|(_, term)| !self.is_constant(*term));
            let (Some((c, term)), None) = (terms.next(), terms.next()) else { break };
            let (constant, inner) = self.parted(term);
            let constant = self.graph.scale(c, constant);
            (factor, moving) = (self.graph.mul(factor, constant), inner);
        }
        (factor, moving)
    }

    /// A product of two series, after constants are taken out.
    fn product(&mut self, id: Id) -> Rule {
        let (constant, moving) = self.parted(id);
        if self.graph.as_number(constant) != Some(Number::ONE) {
            return self.scaled(constant, moving);
        }
        let Node::Product(mut moving) = self.graph.node(moving).clone() else {
            return self.scaled(constant, moving);
        };
        // A sign is constant between its switches, so it scales the rest. Its series registers the switch.
        let sign = moving.iter().position(|factor| matches!(self.graph.node(*factor), Node::Call(Function::Signum, _)));
        if let (Some(sign), true) = (sign, moving.len() > 1) {
            let sign = moving.remove(sign);
            self.series(sign);
            let rest = self.graph.product(&moving);
            return self.scaled(sign, rest);
        }
        // Divide by a reciprocal that is read in products only. It then needs no series.
        let single = moving.iter().position(|factor| {
            matches!(self.graph.node(*factor), Node::Power(_, Ratio { numerator: -2..=-1, denominator: 1 }))
                && !self.alone.contains(factor)
        });
        if let Some(place) = single {
            let by = moving.remove(place);
            let (numerator, by) = (self.graph.product(&moving), self.graph.recip(by));
            if let Some(rule) = self.source(numerator).map(|numerator| Rule::Quotient(numerator, self.series(by))) {
                return rule;
            }
        }
        moving.sort_by_key(|factor| self.depth(*factor));
        let last = moving.pop().unwrap_or(id);
        let first = self.graph.product(&moving);
        self.times(first, last)
    }

    /// a·b for two series, of which b is computed last.
    fn times(&mut self, a: Id, b: Id) -> Rule {
        if a == b {
            return Rule::Squares(vec![self.series(a)]);
        }
        for (affine, other) in [(a, b), (b, a)] {
            if let Some(slope) = self.slope(affine) {
                let (start, slope) = (self.value(affine), self.value(slope));
                return Rule::Shift { start, slope, of: self.series(other) };
            }
        }
        Rule::Product(self.series(a), self.series(b))
    }

    /// c·u.
    pub(super) fn scaled_by(&mut self, c: Number, u: Id) -> Rule {
        Rule::Linear(vec![(Factor::Number(c), self.series(u))])
    }

    /// factor·u for a constant factor.
    pub(super) fn scaled(&mut self, factor: Id, u: Id) -> Rule {
        let (factor, u) = self.of_one_term(factor, u);
        let factor = self.factor(factor);
        Rule::Linear(self.source(u).map(|source| (factor, source)).into_iter().collect())
    }

    /// A constant as a factor.
    pub(super) fn factor(&mut self, id: Id) -> Factor {
        match self.graph.as_number(id) {
            Some(number) => Factor::Number(number),
            None => Factor::Value(self.value(id)),
        }
    }

    /// baseⁿ.
    fn power(&mut self, base: Id, exponent: Ratio) -> Rule {
        // The square of a reciprocal can be packed with other squares. The power rule has a sum of another kind.
        if exponent == Ratio::integer(-2) {
            let reciprocal = self.graph.recip(base);
            return Rule::Squares(vec![self.series(reciprocal)]);
        }
        if !exponent.is_integer() || exponent.numerator < 0 && !self.has_lower(base, exponent) {
            if let Some(lower) = self.lower(base, exponent) {
                return self.times(base, lower);
            }
            let u = self.series(base);
            return match exponent {
                Ratio { numerator: -1, denominator: 1 } => Rule::Reciprocal(u),
                Ratio { numerator: 1, denominator: 2 } => Rule::Root(u),
                _ => Rule::Power(u, Factor::Number(Number::Exact(exponent))),
            };
        }
        // Use a product: the power rule divides by the base, which may be zero, and takes twice the multiplications.
        let half = Ratio::integer(exponent.numerator / 2);
        let rest = Ratio::integer(exponent.numerator - half.numerator);
        let [half, rest] = [half, rest].map(|exponent| self.graph.pow(base, exponent));
        self.times(half, rest)
    }

    /// The power with an exponent smaller by 1, for a fractional exponent, if it is read. The power then is its product with the base.
    fn lower(&mut self, base: Id, exponent: Ratio) -> Option<Id> {
        if exponent.is_integer() || exponent == (Ratio { numerator: 1, denominator: 2 }) {
            return None;
        }
        let lower = self.graph.pow(base, exponent.add(Ratio::integer(-1))?);
        self.uses.contains_key(&lower).then_some(lower)
    }

    /// Returns whether the reciprocal or its square is read, so that a lower negative power is a product.
    fn has_lower(&mut self, base: Id, exponent: Ratio) -> bool {
        let mut is_read = |exponent| {
            let power = self.graph.pow(base, Ratio::integer(exponent));
            self.uses.contains_key(&power)
        };
        exponent.numerator < -2 && (is_read(-1) || is_read(-2))
    }

    /// One of two branches by a condition.
    pub(super) fn select(&mut self, condition: Id, first: Id, second: Id) -> Rule {
        self.add_switches(condition);
        let value = self.value(condition);
        if !self.jet.conditions.contains(&value) {
            self.jet.conditions.push(value);
        }
        Rule::Select(value, self.source(first), self.source(second))
    }

    /// Adds the numbers whose signs decide a condition.
    fn add_switches(&mut self, condition: Id) {
        match *self.graph.node(condition) {
            Node::Compare(_, a, b) => {
                let difference = self.graph.sub(a, b);
                self.add_switch(difference);
            }
            Node::And(a, b) | Node::Or(a, b) => {
                self.add_switches(a);
                self.add_switches(b);
            }
            Node::Not(a) => self.add_switches(a),
            _ => {}
        }
    }

    /// Adds a number whose sign decides.
    pub(super) fn add_switch(&mut self, id: Id) {
        if self.is_constant(id) {
            return;
        }
        let switch = (self.value(id), self.source(id));
        if !self.jet.switches.contains(&switch) {
            self.jet.switches.push(switch);
        }
    }
}
