//! Divided differences of functions.

use super::ends::Slopes;
use super::power;
use crate::ir::of_steps;
use crate::ir::{Function, Graph, Id, Number, Ratio};
use std::f64::consts::{LN_2, LN_10};

impl Slopes {
    /// The slopes of `id = function(args)` with respect to its arguments.
    pub(super) fn function(&mut self, g: &mut Graph, id: Id, function: Function, args: &[Id]) -> Vec<(Id, Id)> {
        let x = args[0];
        let slope = match function {
            Function::Sin => self.about_mean(g, x, Function::Cos, Function::Sinc),
            Function::Cos => {
                let slope = self.about_mean(g, x, Function::Sin, Function::Sinc);
                g.neg(slope)
            }
            Function::Sinh => self.about_mean(g, x, Function::Cosh, Function::Sinhc),
            Function::Cosh => self.about_mean(g, x, Function::Sinh, Function::Sinhc),
            // sinc(d)/(cos a·cos b) if no pole lies between a and b.
            Function::Tan => {
                let (end, increment) = (self.end(g, x), self.increment(g, x));
                let cosines = [x, end].map(|x| g.call(Function::Cos, &[x]));
                let product = g.product(&cosines);
                let reciprocal = g.call(Function::RecipPositive, &[product]);
                let sinc = g.call(Function::Sinc, &[increment]);
                g.mul(sinc, reciprocal)
            }
            // tan((β − α)/2) = (sin β − sin α)/(cos α + cos β)
            Function::Asin | Function::Acos => {
                let roots = self.at_ends(g, x, |g, x| {
                    let square = product_of_sums(g, [1, -1], x);
                    g.sqrt(square)
                });
                let (sum, increment) = (g.sum(&roots), self.increment(g, x));
                let arc = g.call(Function::Arc, &[increment, sum]);
                g.scale(Number::integer(if function == Function::Asin { 2 } else { -2 }), arc)
            }
            // tan(β − α) = (tan β − tan α)/(1 + tan α·tan β)
            Function::Atan => {
                let (end, increment) = (self.end(g, x), self.increment(g, x));
                let product = g.mul(x, end);
                let sum = offset(g, 1, 1, product);
                g.call(Function::Arc, &[increment, sum])
            }
            // tanh((β − α)/2) = (sinh β − sinh α)/(cosh α + cosh β) = (cosh β − cosh α)/(sinh α + sinh β)
            Function::Asinh | Function::Acosh => {
                let roots = self.at_ends(g, x, |g, x| {
                    let square = match function {
                        Function::Asinh => {
                            let square = g.pow(x, Ratio::integer(2));
                            offset(g, 1, 1, square)
                        }
                        _ => product_of_sums(g, [-1, 1], x),
                    };
                    g.sqrt(square)
                });
                let sum = g.sum(&roots);
                // d·coth d is stationary at d = 0, so rounding errors of a difference of two values do not matter.
                let end = self.end(g, id);
                let angle = g.sub(end, id);
                let half = g.scale(Number::HALF, angle);
                let (cosh, sinhc) = (g.call(Function::Cosh, &[half]), g.call(Function::Sinhc, &[half]));
                let twice = g.scale(Number::integer(2), cosh);
                let product = g.mul(sinhc, sum);
                g.div(twice, product)
            }
            // ln[(1 + a)(1 − b), (1 − a)(1 + b)]. These arguments differ by twice the increment.
            Function::Atanh => {
                let [plus, minus] = [1, -1].map(|sign| self.at_ends(g, x, |g, x| offset(g, 1, sign, x)));
                let ends = [g.mul(plus[0], minus[1]), g.mul(minus[0], plus[1])];
                g.call(Function::LnSlope, &ends)
            }
            Function::Tanh => self.of_ends(g, x, Function::TanhSlope),
            Function::Exp | Function::ExpM1 => self.of_ends(g, x, Function::ExpSlope),
            Function::Exp2 => self.of_ends(g, x, Function::Exp2Slope),
            Function::Ln => self.of_ends(g, x, Function::LnSlope),
            Function::Ln1p => {
                let arg = offset(g, 1, 1, x);
                self.of_ends(g, arg, Function::LnSlope)
            }
            Function::Log2 | Function::Log10 => {
                let slope = self.of_ends(g, x, Function::LnSlope);
                g.scale(Number::float(1.0 / if function == Function::Log2 { LN_2 } else { LN_10 }), slope)
            }
            // 1/(y³)[∛a, ∛b]
            Function::Cbrt => {
                let end = self.end(g, id);
                let slope = power::slope(g, id, end, Ratio::integer(3));
                g.recip(slope)
            }
            Function::Abs => self.of_ends(g, x, Function::AbsSlope),
            // (∂/∂a + ∂/∂b) f[a, b] = f'[a, b]
            Function::Signum => {
                let end = self.end(g, x);
                let parts = [[x, end], [end, x]].map(|ends| g.call(Function::AbsSlopeDerivative, &ends));
                g.sum(&parts)
            }
            Function::Hypot | Function::Atan2 | Function::Powf | Function::Min | Function::Max => {
                return args.iter().copied().zip(self.of_two(g, id, function, x, args[1])).collect();
            }
            Function::RecipPositive | Function::NotNegative | Function::Provided | Function::Bounded | of_steps!() => {
                unreachable!("energies contain no divided differences")
            }
        };
        vec![(x, slope)]
    }

    /// The slopes of `id = function(x, y)`.
    fn of_two(&mut self, g: &mut Graph, id: Id, function: Function, x: Id, y: Id) -> [Id; 2] {
        match function {
            // Both slopes are mean(x)/mean(r).
            Function::Hypot => {
                let radius = self.mean(g, id);
                [x, y].map(|side| {
                    let mean = self.mean(g, side);
                    g.div(mean, radius)
                })
            }
            // The angle between both ends from their cross and dot products. The arguments are (y, x).
            Function::Atan2 => {
                let (y, x) = (x, y);
                let [(x_mean, dx), (y_mean, dy)] = [x, y].map(|x| (self.mean(g, x), self.increment(g, x)));
                let products = [g.mul(x_mean, dy), g.mul(y_mean, dx)];
                let cross = g.sub(products[0], products[1]);
                let squares = [x, y].map(|x| {
                    let end = self.end(g, x);
                    g.mul(x, end)
                });
                let dot = g.sum(&squares);
                let arc = g.call(Function::Arc, &[cross, dot]);
                let by_x = g.mul(y_mean, arc);
                [g.mul(x_mean, arc), g.neg(by_x)]
            }
            Function::Powf if self.is_constant(g, y) => {
                let end = self.end(g, x);
                [g.call(Function::PowfSlope, &[x, end, y]), g.zero()]
            }
            // exp(y ln x)
            Function::Powf => {
                let ln = g.call(Function::Ln, &[x]);
                let exponent = g.mul(y, ln);
                let outer = self.of_ends(g, exponent, Function::ExpSlope);
                let inner = self.of_ends(g, x, Function::LnSlope);
                let (ln, y) = (self.mean(g, ln), self.mean(g, y));
                [g.product(&[outer, y, inner]), g.mul(outer, ln)]
            }
            // (x + y ± |x − y|)/2
            _ => {
                let (first, second) = if function == Function::Max { (x, y) } else { (y, x) };
                let difference = g.sub(first, second);
                let slope = self.of_ends(g, difference, Function::AbsSlope);
                let one = g.integer(1);
                let sides = [g.add(one, slope), g.sub(one, slope)];
                sides.map(|side| g.scale(Number::HALF, side))
            }
        }
    }

    /// function(mean)·quotient(increment/2), by a sum-to-product identity.
    fn about_mean(&mut self, g: &mut Graph, x: Id, function: Function, quotient: Function) -> Id {
        let (mean, increment) = (self.mean(g, x), self.increment(g, x));
        let half = g.scale(Number::HALF, increment);
        let quotient = g.call(quotient, &[half]);
        let value = g.call(function, &[mean]);
        g.mul(value, quotient)
    }

    /// helper(start, end)
    fn of_ends(&mut self, g: &mut Graph, x: Id, helper: Function) -> Id {
        let end = self.end(g, x);
        g.call(helper, &[x, end])
    }

    /// [f(start), f(end)]
    fn at_ends(&mut self, g: &mut Graph, x: Id, f: impl Fn(&mut Graph, Id) -> Id) -> [Id; 2] {
        let end = self.end(g, x);
        [f(g, x), f(g, end)]
    }
}

/// constant + coefficient·x
fn offset(g: &mut Graph, constant: i128, coefficient: i128, x: Id) -> Id {
    let (constant, term) = (g.integer(constant), g.scale(Number::integer(coefficient), x));
    g.add(constant, term)
}

/// (constant + coefficient·x)(1 + x)
fn product_of_sums(g: &mut Graph, [constant, coefficient]: [i128; 2], x: Id) -> Id {
    let (first, second) = (offset(g, constant, coefficient, x), offset(g, 1, 1, x));
    g.mul(first, second)
}
