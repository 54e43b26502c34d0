//! The recurrences of functions, in one exhaustive match.

use super::{Builder, Factor, Rule};
use crate::ir::of_steps;
use crate::ir::{Function, Id, Number, Ratio, Relation};

impl Builder<'_> {
    /// The rule of `id = function(args)`.
    pub(super) fn call(&mut self, id: Id, function: Function, args: &[Id]) -> Rule {
        let (x, y) = (args[0], *args.get(1).unwrap_or(&args[0]));
        let one = self.graph.integer(1);
        let minus = Number::MINUS_ONE;
        match function {
            Function::Sin => self.integral(Function::Cos, Number::ONE, x),
            Function::Cos => self.integral(Function::Sin, minus, x),
            Function::Sinh => self.integral(Function::Cosh, Number::ONE, x),
            Function::Cosh => self.integral(Function::Sinh, Number::ONE, x),
            Function::Tan | Function::Tanh => {
                let square = self.graph.pow(id, Ratio::integer(2));
                let is_tan = function == Function::Tan;
                let by = if is_tan { self.graph.add(one, square) } else { self.graph.sub(one, square) };
                self.integral_by(by, Number::ONE, x)
            }
            Function::Exp => self.integral_by(id, Number::ONE, x),
            Function::Exp2 => self.integral_by(id, Number::float(std::f64::consts::LN_2), x),
            Function::ExpM1 => self.multiple_of(Function::Exp, x, Number::ONE),
            Function::Ln => Rule::Quadrature { factor: Number::ONE, of: self.series(x), over: self.series(x) },
            Function::Log2 => self.multiple_of(Function::Ln, x, Number::float(1.0 / std::f64::consts::LN_2)),
            Function::Log10 => self.multiple_of(Function::Ln, x, Number::float(1.0 / std::f64::consts::LN_10)),
            Function::Ln1p => {
                let sum = self.graph.add(one, x);
                Rule::Quadrature { factor: Number::ONE, of: self.series(x), over: self.series(sum) }
            }
            Function::Asin | Function::Acos | Function::Atanh | Function::Acosh => {
                let (a, b) = if function == Function::Acosh { (x, one) } else { (one, x) };
                let (less, more) = (self.graph.sub(a, b), self.graph.add(a, b));
                let mut over = self.graph.mul(less, more);
                if function != Function::Atanh {
                    over = self.graph.sqrt(over);
                }
                self.quadrature(if function == Function::Acos { minus } else { Number::ONE }, x, over)
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
                self.add_switch(x);
                let sign = self.graph.call(Function::Signum, &[x]);
                self.scaled(sign, x)
            }
            Function::Min | Function::Max => {
                let [low, high] = if function == Function::Min { [x, y] } else { [y, x] };
                let first = self.graph.compare(Relation::LessEqual, low, high);
                self.select(first, x, y)
            }
            Function::RecipPositive => Rule::Reciprocal(self.series(x)),
            // The value at the start is NaN if the condition fails. Coefficients need not check it again.
            Function::NotNegative | Function::Bounded | Function::Provided => self.scaled(one, x),
            Function::Signum => {
                self.add_switch(x);
                Rule::Linear(vec![])
            }
            of_steps!() => unreachable!("vector fields contain no divided differences and no flows"),
        }
    }

    /// y' = k·d(u)·u'.
    fn integral(&mut self, by: Function, factor: Number, u: Id) -> Rule {
        let by = self.graph.call(by, &[u]);
        self.integral_by(by, factor, u)
    }

    /// y' = k·d·u'.
    fn integral_by(&mut self, by: Id, factor: Number, u: Id) -> Rule {
        // The graph may have taken a sign out of d.
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

    /// c·f(u) for orders n ≥ 1. The value may differ.
    fn multiple_of(&mut self, function: Function, u: Id, c: Number) -> Rule {
        let value = self.graph.call(function, &[u]);
        self.scaled_by(c, value)
    }

    /// The angle of the point (x, y).
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

    /// r²·y' = ±c·u', the angle of a point with one constant coordinate c.
    fn angle_of_one(&mut self, u: Id, c: Id, sign: Number, square: Id) -> Rule {
        let by = self.graph.div(c, square);
        self.integral_by(by, sign, u)
    }
}
