//! Functions: what they have in common with roots, powers and exponentials; unknowns of their own for the rest.

use super::atoms::Kind;
use super::expand::{Expansion, Stop};
use super::normal::Normal;
use super::powers::magnitude;
use crate::ir::op::Parity;
use crate::ir::{Function, Ratio};
use std::rc::Rc;

impl Expansion<'_> {
    /// A function of normal forms.
    pub(super) fn call(&mut self, function: Function, args: &[Rc<Normal>]) -> Result<Normal, Stop> {
        let (one, half) = (Normal::number(Ratio::ONE), Ratio::HALF);
        let x = &*args[0];
        match (function, args) {
            (Function::Hypot, [x, y]) => {
                let squares = [self.product(x, x)?, self.product(y, y)?];
                let sum = self.sum(squares[0].clone(), Ratio::ONE, &squares[1])?;
                self.power(&sum, half)
            }
            (Function::Abs, _) => {
                let square = self.product(x, x)?;
                self.power(&square, half)
            }
            // (x + y ∓ |x − y|)/2.
            (Function::Min | Function::Max, [x, y]) => {
                let (sum, difference) =
                    (self.sum((**x).clone(), Ratio::ONE, y)?, self.sum((**x).clone(), Ratio::integer(-1), y)?);
                let distance = self.call(Function::Abs, &[Rc::new(difference)])?;
                let sign = Ratio::integer(if function == Function::Min { -1 } else { 1 });
                let twice = self.sum(sum, sign, &distance)?;
                twice.scale(half).ok_or(Stop::TooLong)
            }
            (Function::Powf, [x, exponent]) => match exponent.as_number() {
                Some(exponent) => self.power(x, exponent),
                None => Ok(self.unknown(function, args)),
            },
            (Function::Cbrt, _) if !x.is_empty() => {
                let atom = self.atoms.of(Kind::Cbrt(x.clone()));
                Ok(Normal::atom(atom))
            }
            (Function::Exp | Function::Exp2, _) => self.exponential(function, x),
            (Function::ExpM1, _) => {
                let exponential = self.exponential(Function::Exp, x)?;
                self.sum(exponential, Ratio::integer(-1), &one)
            }
            (Function::Cosh, _) => self.hyperbolic(x, Ratio::ONE),
            (Function::Sinh, _) => self.hyperbolic(x, Ratio::integer(-1)),
            (Function::Tanh, _) => {
                let (sinh, cosh) = (self.hyperbolic(x, Ratio::integer(-1))?, self.hyperbolic(x, Ratio::ONE)?);
                let reciprocal = self.power(&cosh, Ratio::integer(-1))?;
                self.product(&sinh, &reciprocal)
            }
            (Function::Tan, _) => {
                let (sin, cos) = (self.call(Function::Sin, args)?, self.call(Function::Cos, args)?);
                let reciprocal = self.power(&cos, Ratio::integer(-1))?;
                self.product(&sin, &reciprocal)
            }
            // Where it is defined.
            (Function::RecipPositive, _) => self.power(x, Ratio::integer(-1)),
            (Function::Root, _) => self.power(x, half),
            // Their other arguments are conditions.
            (Function::NotNegative | Function::Bounded | Function::AtMost | Function::Provided, _) => Ok(x.clone()),
            (Function::Ln1p, _) => {
                let sum = self.sum(x.clone(), Ratio::ONE, &one)?;
                self.call(Function::Ln, &[Rc::new(sum)])
            }
            _ => Ok(self.unknown(function, args)),
        }
    }

    /// e^Σ is a product: a power of e^m for each monomial m, so that exponentials of sums, and their powers, meet.
    fn exponential(&mut self, function: Function, x: &Normal) -> Result<Normal, Stop> {
        let mut powers = vec![];
        for (monomial, coefficient) in x.terms() {
            let atom = self.atoms.of(Kind::Exponential(function, Normal::term(monomial.clone(), Ratio::ONE)));
            powers.push((atom, coefficient));
        }
        powers.sort_by_key(|(atom, _)| *atom);
        Ok(Normal::term(powers, Ratio::ONE))
    }

    /// (eˣ + sign·e⁻ˣ)/2.
    fn hyperbolic(&mut self, x: &Normal, sign: Ratio) -> Result<Normal, Stop> {
        let back = x.scale(Ratio::integer(-1)).ok_or(Stop::TooLong)?;
        let (up, down) = (self.exponential(Function::Exp, x)?, self.exponential(Function::Exp, &back)?);
        self.sum(up, sign, &down)?.scale(Ratio::HALF).ok_or(Stop::TooLong)
    }

    /// A function that is known by its arguments alone, but for the sign of one that is odd or even.
    fn unknown(&mut self, function: Function, args: &[Rc<Normal>]) -> Normal {
        let mut args: Vec<Normal> = args.iter().map(|arg| (**arg).clone()).collect();
        let (parity, leading) = (function.entry().parity, args[0].leading());
        if parity == Parity::Odd && args[0].is_empty() {
            return Normal::default();
        }
        let mut sign = Ratio::ONE;
        if parity != Parity::Neither && leading != magnitude(leading) {
            args[0] = args[0].scale(Ratio::integer(-1)).unwrap_or_default();
            sign = if parity == Parity::Odd { Ratio::integer(-1) } else { Ratio::ONE };
        }
        Normal::term(vec![(self.atoms.of(Kind::Call(function, args)), Ratio::ONE)], sign)
    }
}
