//! Normal forms of functions. Relatives of roots, powers and exponentials are rewritten. Other functions are independent unknowns.

use super::atoms::Kind;
use super::expand::{Expansion, Stop};
use super::normal::{Monomial, Normal};
use super::powers::magnitude;
use crate::ir::op::Parity;
use crate::ir::{Function, Ratio};
use std::rc::Rc;

impl Expansion<'_> {
    /// The normal form of a function of normal forms.
    pub(super) fn call(&mut self, function: Function, args: &[Rc<Normal>]) -> Result<Normal, Stop> {
        let (one, half, minus) = (Normal::number(Ratio::ONE), Ratio::HALF, Ratio::integer(-1));
        let x = &*args[0];
        match (function, args) {
            (Function::Hypot, [x, y]) => {
                let (square, other) = (self.product(x, x)?, self.product(y, y)?);
                let sum = self.sum(square, Ratio::ONE, &other)?;
                self.power(&sum, half)
            }
            (Function::Abs, _) => {
                let square = self.product(x, x)?;
                self.power(&square, half)
            }
            // (x + y ∓ |x − y|)/2.
            (Function::Min | Function::Max, [x, y]) => {
                let sum = self.sum((**x).clone(), Ratio::ONE, y)?;
                let difference = self.sum((**x).clone(), minus, y)?;
                let distance = self.call(Function::Abs, &[Rc::new(difference)])?;
                let sign = if function == Function::Min { minus } else { Ratio::ONE };
                self.sum(sum, sign, &distance)?.scale(half).ok_or(Stop::TooLong)
            }
            (Function::Powf, [x, exponent]) => match exponent.as_number() {
                Some(exponent) => self.power(x, exponent),
                None => Ok(self.unknown(function, args)),
            },
            (Function::Cbrt, _) if !x.is_empty() => Ok(Normal::atom(self.atoms.of(Kind::Cbrt(x.clone())))),
            (Function::Exp | Function::Exp2, _) => Ok(self.exponential(function, x)),
            (Function::ExpM1, _) => {
                let exponential = self.exponential(Function::Exp, x);
                self.sum(exponential, minus, &one)
            }
            (Function::Cosh, _) => self.hyperbolic(x, Ratio::ONE),
            (Function::Sinh, _) => self.hyperbolic(x, minus),
            (Function::Tanh, _) => {
                let (sinh, cosh) = (self.hyperbolic(x, minus)?, self.hyperbolic(x, Ratio::ONE)?);
                let reciprocal = self.power(&cosh, minus)?;
                self.product(&sinh, &reciprocal)
            }
            (Function::Tan, _) => {
                let (sin, cos) = (self.call(Function::Sin, args)?, self.call(Function::Cos, args)?);
                let reciprocal = self.power(&cos, minus)?;
                self.product(&sin, &reciprocal)
            }
            (Function::RecipPositive, _) => self.power(x, minus),
            (Function::Root, _) => self.power(x, half),
            // The other arguments are conditions.
            (Function::NotNegative | Function::Bounded | Function::AtMost | Function::Provided, _) => Ok(x.clone()),
            (Function::Ln1p, _) => {
                let sum = self.sum(x.clone(), Ratio::ONE, &one)?;
                self.call(Function::Ln, &[Rc::new(sum)])
            }
            _ => Ok(self.unknown(function, args)),
        }
    }

    /// e^Σcₖmₖ as the product of the powers (e^mₖ)^cₖ, so that exponentials of sums and powers of exponentials share atoms.
    fn exponential(&mut self, function: Function, x: &Normal) -> Normal {
        let mut powers: Monomial = vec![];
        for (monomial, coefficient) in x.terms() {
            let atom = self.atoms.of(Kind::Exponential(function, Normal::term(monomial.clone(), Ratio::ONE)));
            powers.push((atom, coefficient));
        }
        powers.sort_by_key(|(atom, _)| *atom);
        Normal::term(powers, Ratio::ONE)
    }

    /// (eˣ + sign·e⁻ˣ)/2.
    fn hyperbolic(&mut self, x: &Normal, sign: Ratio) -> Result<Normal, Stop> {
        let back = x.scale(Ratio::integer(-1)).ok_or(Stop::TooLong)?;
        let (up, down) = (self.exponential(Function::Exp, x), self.exponential(Function::Exp, &back));
        self.sum(up, sign, &down)?.scale(Ratio::HALF).ok_or(Stop::TooLong)
    }

    /// An independent unknown for the function with these arguments. Odd and even functions share one unknown for ±x.
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
