//! The recurrence of every function: one exhaustive match.

use super::{Builder, Factor, Rule};
use crate::ir::of_steps;
use crate::ir::{Function, Id, Number, Ratio, Relation};

impl Builder<'_> {
    pub(super) fn call(&mut self, id: Id, function: Function, args: &[Id]) -> Rule {
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
            of_steps!() => unreachable!("of divided differences and of flows: no part of a vector field"),
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
