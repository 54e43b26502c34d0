//! Values of functions at a point: exponentials and rational functions of them, logarithms, choices, and unknowns for other functions.

use super::arguments::Term;
use super::evaluate::{Evaluation, FUNCTION, Halt};
use super::prime::Element;
use crate::ir::op::Parity;
use crate::ir::{Function, Id, Node, Number, Ratio};

impl Evaluation<'_> {
    /// The value of a function of evaluated nodes.
    pub(super) fn call(&mut self, function: Function, args: &[Id]) -> Result<Element, Halt> {
        let prime = self.prime;
        match (function, args) {
            (Function::Exp | Function::Exp2, [x]) => self.exponential(function, *x),
            (Function::ExpM1, [x]) => Ok(prime.difference(self.exponential(Function::Exp, *x)?, Element::ONE)),
            (Function::Cosh | Function::Sinh | Function::Tanh, [x]) => {
                let w = self.exponential(Function::Exp, *x)?;
                self.wave(function, w, Element::ONE)
            }
            (Function::Cos | Function::Sin | Function::Tan, [x]) => {
                let w = self.product_over_terms(*x, Function::Sin, &[], |_| Ok(None))?;
                self.wave(function, w, Element::I)
            }
            (Function::Ln, [x]) => self.logarithm(*x),
            (Function::Ln1p, [x]) => self.logarithm_of_one_plus(*x),
            // ln x/ln 2, ln x/ln 10.
            (Function::Log2 | Function::Log10, [x]) => {
                Ok(prime.product(self.unknown(FUNCTION + function as u64, &[], 0), self.logarithm(*x)?))
            }
            (Function::Abs, [x]) => {
                let x = self.number(*x)?;
                Ok(if self.is_negative(x)? { prime.negative(x) } else { x })
            }
            (Function::Signum, [x]) => {
                let is_negative = self.is_negative(self.number(*x)?)?;
                Ok(if is_negative { prime.negative(Element::ONE) } else { Element::ONE })
            }
            (Function::Min | Function::Max, [x, y]) => {
                let (x, y) = (self.number(*x)?, self.number(*y)?);
                let descends = self.is_negative(prime.difference(y, x))?;
                Ok(if descends == (function == Function::Min) { y } else { x })
            }
            (Function::Hypot, [x, y]) => {
                let (x, y) = (self.number(*x)?, self.number(*y)?);
                self.root(prime.sum(prime.product(x, x), prime.product(y, y)))
            }
            (Function::Root, [x]) => self.ratio_power(*x, Ratio::HALF),
            (Function::RecipPositive, [x]) => self.reciprocal(self.number(*x)?),
            // The other arguments are conditions.
            (Function::NotNegative, [x]) | (Function::Bounded | Function::AtMost | Function::Provided, [x, _]) => {
                self.number(*x)
            }
            (Function::Cbrt, [x]) if self.plan.arguments.power_of_root(*x, THIRD).is_some() => {
                self.ratio_power(*x, THIRD)
            }
            (Function::Powf, [x, exponent]) => match self.plan.graph.as_number(*exponent) {
                Some(Number::Exact(exponent)) => self.ratio_power(*x, exponent),
                _ => {
                    let base = self.number(*x)?;
                    let for_number = |term: &Term| Ok(term.factors.is_empty().then_some(base));
                    self.product_over_terms(*exponent, function, &[base], for_number)
                }
            },
            _ => self.unknown_function(function, args),
        }
    }

    /// An unknown for a function of these values. Odd and even functions share one unknown for ±x.
    fn unknown_function(&self, function: Function, args: &[Id]) -> Result<Element, Halt> {
        let mut values = args.iter().map(|id| self.number(*id)).collect::<Result<Vec<Element>, Halt>>()?;
        let parity = function.entry().parity;
        let (size, is_negated) = self.prime.without_sign(values[0]);
        if parity != Parity::Neither {
            values[0] = size;
        }
        if parity == Parity::Odd && size.is_zero() {
            return Ok(size);
        }
        let value = self.unknown(FUNCTION + function as u64, &values, 0);
        Ok(if parity == Parity::Odd && is_negated { self.prime.negative(value) } else { value })
    }

    /// `exp` or `exp2` of an argument.
    fn exponential(&self, function: Function, argument: Id) -> Result<Element, Halt> {
        self.product_over_terms(argument, function, &[], |term| match (function, &term.factors[..]) {
            (Function::Exp2, []) => Ok(Some(self.constant(Number::integer(2))?)),
            // e^(n ln x) = xⁿ.
            (Function::Exp, [factor]) => match self.plan.graph.node(*factor) {
                Node::Call(Function::Ln, args) => Ok(Some(self.number(args[0])?)),
                _ => Ok(None),
            },
            _ => Ok(None),
        })
    }

    /// The exponential of a sum of terms, as a product over the terms. A term with an integer coefficient n gives baseⁿ, if `base` knows its
    /// base. Every other term gives a power of an unknown that depends on `values`.
    fn product_over_terms(
        &self,
        argument: Id,
        function: Function,
        values: &[Element],
        base: impl Fn(&Term) -> Result<Option<Element>, Halt>,
    ) -> Result<Element, Halt> {
        let terms = self.plan.arguments.terms(argument);
        terms.iter().try_fold(Element::ONE, |product, term| {
            let factor = match (base(term)?, term.integer_coefficient()) {
                (Some(base), Some(n)) => self.power(base, n)?,
                _ => self.power_of_unknown(FUNCTION + function as u64, values, term)?,
            };
            Ok(self.prime.product(product, factor))
        })
    }

    /// An unknown for the factors of a term, to the power of its coefficient. The unknown for −u is the reciprocal of the one for u.
    fn power_of_unknown(&self, kind: u64, values: &[Element], term: &Term) -> Result<Element, Halt> {
        let scale = self.constant(Number::Exact(term.scale))?;
        let mut factors = term.factors.iter();
        let factors = factors.try_fold(scale, |product, id| Ok(self.prime.product(product, self.number(*id)?)))?;
        let (size, is_negated) = self.prime.without_sign(factors);
        if size.is_zero() {
            return Ok(Element::ONE);
        }
        let unknown = self.unknown(kind, &[values, &[size]].concat(), 0);
        let exponent = self.plan.arguments.times_denominator(term.coefficient).ok_or(Halt::GiveUp)?;
        self.power(unknown, if is_negated { -exponent } else { exponent })
    }

    /// (w + 1/w)/2, (w − 1/w)/(2·unit), or the quotient of the second and the first, where w = e^(unit·x).
    fn wave(&self, function: Function, w: Element, unit: Element) -> Result<Element, Halt> {
        let prime = self.prime;
        let back = self.reciprocal(w)?;
        let (sum, difference) = (prime.sum(w, back), prime.difference(w, back));
        let (value, divisor) = match function {
            Function::Cos | Function::Cosh => (sum, Element::ONE),
            Function::Sin | Function::Sinh => (difference, unit),
            _ => return Ok(prime.product(difference, self.reciprocal(prime.product(unit, sum))?)),
        };
        let half = self.constant(Number::HALF)?;
        Ok(prime.product(prime.product(value, half), self.reciprocal(divisor)?))
    }

    /// ln|x|, which equals ln x where ln x is defined, as a sum over the factors of x.
    fn logarithm(&self, x: Id) -> Result<Element, Halt> {
        let graph = self.plan.graph;
        let (coefficient, rest) = graph.coefficient(x);
        let mut sum = self.unknown_logarithm(self.constant(coefficient)?);
        for (base, exponent) in graph.factors(rest) {
            let exponent = self.constant(Number::Exact(exponent))?;
            let logarithm = match graph.node(base) {
                Node::Call(Function::Exp, args) => self.number(args[0])?,
                Node::Linear(constant, terms) => {
                    let leading = if constant.is_zero() { terms[0].0 } else { *constant };
                    let leading = self.constant(leading)?;
                    self.logarithm_of_sum(self.number(base)?, leading)?
                }
                _ => self.unknown_logarithm(self.number(base)?),
            };
            sum = self.prime.sum(sum, self.prime.product(exponent, logarithm));
        }
        Ok(sum)
    }

    /// ln|1 + x|, as the logarithm of the sum.
    fn logarithm_of_one_plus(&self, x: Id) -> Result<Element, Halt> {
        let constant = match self.plan.graph.node(x) {
            Node::Linear(constant, _) => self.constant(*constant)?,
            _ => Element::ZERO,
        };
        let sum = self.prime.sum(Element::ONE, self.number(x)?);
        let leading = self.prime.sum(Element::ONE, constant);
        self.logarithm_of_sum(sum, if leading.is_zero() { Element::ONE } else { leading })
    }

    /// ln|x| = ln|leading| + ln|x/leading|, where `leading` is the first coefficient of the sum x.
    fn logarithm_of_sum(&self, x: Element, leading: Element) -> Result<Element, Halt> {
        let normalised = self.prime.product(x, self.reciprocal(leading)?);
        Ok(self.prime.sum(self.unknown_logarithm(leading), self.unknown_logarithm(normalised)))
    }

    /// An unknown for ln|x|. The logarithm of 1 is 0.
    fn unknown_logarithm(&self, x: Element) -> Element {
        let (one, _) = self.prime.without_sign(Element::ONE);
        match self.prime.without_sign(x) {
            (size, _) if size == one => Element::ZERO,
            (size, _) => self.unknown(FUNCTION + Function::Ln as u64, &[size], 0),
        }
    }
}

const THIRD: Ratio = Ratio { numerator: 1, denominator: 3 };
