//! The recurrence of every operation. One exhaustive match for nodes, one for functions.
//!
//! R. E. Moore, *Interval Analysis* (1966) ch. 11; A. Griewank & A. Walther, *Evaluating Derivatives* (2008) tables 13.1 and 13.2;
//! À. Jorba & M. Zou, Exp. Math. 14 (2005) 99.

use super::{Builder, Factor, Rule};
use crate::ir::{Function, Id, Node, Number, Ratio, Relation, Symbol};

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
    fn slope(&mut self, id: Id) -> Option<Id> {
        let reads = self.reads(id);
        if reads.state() {
            return None;
        }
        match self.graph.node(id).clone() {
            Node::Symbol(Symbol::T) => Some(self.graph.integer(1)),
            Node::Linear(_, terms) => {
                let mut sum = self.graph.zero();
                for (c, term) in
                    terms.into_iter().filter(|(_, term)| self.known.reads[term.index()].t).collect::<Vec<_>>()
                {
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
    fn scaled(&mut self, factor: Id, u: Id) -> Rule {
        let factor = self.factor(factor);
        Rule::Linear(self.source(u).map(|source| (factor, source)).into_iter().collect())
    }

    fn factor(&mut self, id: Id) -> Factor {
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

    fn select(&mut self, condition: Id, first: Id, second: Id) -> Rule {
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
    fn decides(&mut self, id: Id) {
        if self.is_constant(id) {
            return;
        }
        let switch = (self.value(id), self.source(id));
        if !self.jet.switches.contains(&switch) {
            self.jet.switches.push(switch);
        }
    }

    fn call(&mut self, id: Id, function: Function, args: &[Id]) -> Rule {
        let (x, y) = (args[0], *args.get(1).unwrap_or(&args[0]));
        let one = self.graph.integer(1);
        let minus = Number::MINUS_ONE;
        match function {
            Function::Sin => self.integral(Function::Cos, Number::ONE, x),
            Function::Cos => self.integral(Function::Sin, minus, x),
            Function::Sinh => self.integral(Function::Cosh, Number::ONE, x),
            Function::Cosh => self.integral(Function::Sinh, Number::ONE, x),
            Function::Tan => {
                let square = self.graph.pow(id, Ratio::integer(2));
                let by = self.graph.add(one, square);
                self.integral_by(by, Number::ONE, x)
            }
            Function::Tanh => {
                let square = self.graph.pow(id, Ratio::integer(2));
                let by = self.graph.sub(one, square);
                self.integral_by(by, Number::ONE, x)
            }
            Function::Exp => self.integral_by(id, Number::ONE, x),
            Function::Exp2 => self.integral_by(id, Number::float(std::f64::consts::LN_2), x),
            Function::ExpM1 => self.same_as(Function::Exp, x, Number::ONE),
            Function::Ln => Rule::Quadrature { factor: Number::ONE, of: self.series(x), over: self.series(x) },
            Function::Log2 => self.same_as(Function::Ln, x, Number::float(1.0 / std::f64::consts::LN_2)),
            Function::Log10 => self.same_as(Function::Ln, x, Number::float(1.0 / std::f64::consts::LN_10)),
            Function::Ln1p => {
                let sum = self.graph.add(one, x);
                Rule::Quadrature { factor: Number::ONE, of: self.series(x), over: self.series(sum) }
            }
            Function::Asin | Function::Acos | Function::Atanh => {
                let (less, more) = (self.graph.sub(one, x), self.graph.add(one, x));
                let mut over = self.graph.mul(less, more);
                if function != Function::Atanh {
                    over = self.graph.sqrt(over);
                }
                self.quadrature(if function == Function::Acos { minus } else { Number::ONE }, x, over)
            }
            Function::Acosh => {
                let (less, more) = (self.graph.sub(x, one), self.graph.add(x, one));
                let product = self.graph.mul(less, more);
                let over = self.graph.sqrt(product);
                self.quadrature(Number::ONE, x, over)
            }
            Function::Atan | Function::Asinh => {
                let square = self.graph.pow(x, Ratio::integer(2));
                let mut over = self.graph.add(one, square);
                if function == Function::Asinh {
                    over = self.graph.sqrt(over);
                }
                self.quadrature(Number::ONE, x, over)
            }
            Function::Atan2 => self.angle(x, y),
            Function::Hypot => {
                let squares = [x, y].map(|x| self.graph.pow(x, Ratio::integer(2)));
                let sum = self.graph.sum(&squares);
                Rule::Root(self.series(sum))
            }
            Function::Cbrt => {
                let third = Ratio::new(1, 3).map_or(Number::float(1.0 / 3.0), Number::Exact);
                Rule::Power(self.series(x), Factor::Number(third))
            }
            Function::Powf if self.is_constant(y) => {
                let exponent = self.factor(y);
                Rule::Power(self.series(x), exponent)
            }
            Function::Powf => {
                let ln = self.graph.call(Function::Ln, &[x]);
                let exponent = self.graph.mul(y, ln);
                self.integral_by(id, Number::ONE, exponent)
            }
            Function::Abs => {
                self.decides(x);
                let sign = self.graph.call(Function::Signum, &[x]);
                self.scaled(sign, x)
            }
            Function::Min | Function::Max => {
                let [low, high] = if function == Function::Min { [x, y] } else { [y, x] };
                let first = self.graph.compare(Relation::LessEqual, low, high);
                self.select(first, x, y)
            }
            Function::RecipPositive => Rule::Reciprocal(self.series(x)),
            // Conditions, not terms: at the start they are not a number where they do not hold.
            Function::NotNegative | Function::Bounded | Function::Provided => self.scaled(one, x),
            Function::Signum => {
                self.decides(x);
                Rule::Linear(vec![])
            }
            Function::RecipAbove
            | Function::Root
            | Function::Sinc
            | Function::SincDerivative
            | Function::Sinhc
            | Function::SinhcDerivative
            | Function::Arc
            | Function::ArcDerivative
            | Function::ExpSlope
            | Function::ExpSlopeDerivative
            | Function::Exp2Slope
            | Function::LnSlope
            | Function::LnSlopeDerivative
            | Function::TanhSlope
            | Function::TanhSlopeDerivative
            | Function::PowfSlope
            | Function::PowfSlopeDerivative
            | Function::AbsSlope
            | Function::AbsSlopeDerivative
            | Function::Phi1
            | Function::Phi1Derivative
            | Function::StumpffC0
            | Function::StumpffC1
            | Function::StumpffC1Derivative
            | Function::DecayMean
            | Function::AtMost
            | Function::Grown
            | Function::SineAt
            | Function::SineSlope
            | Function::CosineAt
            | Function::CosineSlope
            | Function::FlowMatrix
            | Function::FlowChange
            | Function::KeplerF
            | Function::KeplerG
            | Function::KeplerFRate
            | Function::KeplerGRate => unreachable!("of divided differences and of flows: no part of a vector field"),
        }
    }

    /// y' = k·d(u)·u'.
    fn integral(&mut self, by: Function, factor: Number, u: Id) -> Rule {
        let by = self.graph.call(by, &[u]);
        self.integral_by(by, factor, u)
    }

    /// y' = k·d·u'.
    fn integral_by(&mut self, by: Id, factor: Number, u: Id) -> Rule {
        // A sign that was drawn out of d.
        let (c, by) = self.graph.coefficient(by);
        let (factor, by) = (factor.mul(c), self.series(by));
        match self.slope(u) {
            Some(slope) => Rule::Wave { factor, slope: self.value(slope), by },
            None => Rule::Integral { factor, by, of: self.series(u) },
        }
    }

    /// y'·d = k·u'.
    fn quadrature(&mut self, factor: Number, u: Id, over: Id) -> Rule {
        Rule::Quadrature { factor, of: self.series(u), over: self.series(over) }
    }

    /// c·f(u), but for the value.
    fn same_as(&mut self, function: Function, u: Id, c: Number) -> Rule {
        let same = self.graph.call(function, &[u]);
        Rule::Linear(vec![(Factor::Number(c), self.series(same))])
    }

    fn angle(&mut self, y: Id, x: Id) -> Rule {
        let squares = [x, y].map(|x| self.graph.pow(x, Ratio::integer(2)));
        let square = self.graph.sum(&squares);
        match [y, x].map(|id| self.source(id)) {
            [Some(y), Some(x)] => Rule::Angle { y, x, square: self.series(square) },
            [Some(_), None] => self.angle_of_one(y, x, Number::ONE, square),
            [None, Some(_)] => self.angle_of_one(x, y, Number::MINUS_ONE, square),
            [None, None] => Rule::Linear(vec![]),
        }
    }

    /// r²·y' = ±c·u' where the other coordinate is the number c.
    fn angle_of_one(&mut self, u: Id, c: Id, sign: Number, square: Id) -> Rule {
        let by = self.graph.div(c, square);
        self.integral_by(by, sign, u)
    }
}
