//! Functions at a point: exponentials and what is rational in them, logarithms, choices, and unknowns for the rest.

use super::arguments::Term;
use super::evaluate::{Evaluation, FUNCTION, Halt};
use super::prime::Element;
use crate::ir::op::Parity;
use crate::ir::{Function, Id, Node, Number, Ratio};

impl Evaluation<'_> {
    pub(super) fn call(&mut self, function: Function, args: &[Id]) -> Result<Element, Halt> {
        let prime = self.prime;
        match (function, args) {
            (Function::Exp | Function::Exp2, [x]) => self.exponential(function, *x),
            (Function::ExpM1, [x]) => Ok(prime.difference(self.exponential(Function::Exp, *x)?, Element::ONE)),
            (Function::Cosh | Function::Sinh | Function::Tanh, [x]) => self.wave(function, *x, Element::ONE),
            // cos x = (eⁱˣ + e⁻ⁱˣ)/2, i sin x = (eⁱˣ − e⁻ⁱˣ)/2.
            (Function::Cos | Function::Sin | Function::Tan, [x]) => self.wave(function, *x, Element::I),
            (Function::Ln, [x]) => self.logarithm(*x),
            (Function::Ln1p, [x]) => self.logarithm_of_more(*x),
            // ln x/ln 2, ln x/ln 10.
            (Function::Log2 | Function::Log10, [x]) => {
                Ok(prime.product(self.unknown(FUNCTION + function as u64, &[], 0), self.logarithm(*x)?))
            }
            (Function::Abs, [x]) => {
                let x = self.number(*x)?;
                Ok(if self.is_negative(x)? { prime.negative(x) } else { x })
            }
            (Function::Signum, [x]) => {
                let x = self.number(*x)?;
                Ok(if self.is_negative(x)? { prime.negative(Element::ONE) } else { Element::ONE })
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
            // Their other arguments are conditions.
            (Function::NotNegative, [x]) | (Function::Bounded | Function::AtMost | Function::Provided, [x, _]) => {
                self.number(*x)
            }
            (Function::Cbrt, [x]) if self.plan.arguments.power_of_root(*x, THIRD).is_some() => {
                self.ratio_power(*x, THIRD)
            }
            (Function::Powf, [x, exponent]) => match self.plan.graph.as_number(*exponent) {
                Some(Number::Exact(exponent)) => self.ratio_power(*x, exponent),
                _ => self.general_power(*x, *exponent),
            },
            _ => self.unlike(function, args),
        }
    }

    /// A function of which nothing is known but the sign of one that is odd or even.
    fn unlike(&self, function: Function, args: &[Id]) -> Result<Element, Halt> {
        let mut values = args.iter().map(|id| self.number(*id)).collect::<Result<Vec<Element>, Halt>>()?;
        let parity = function.entry().parity;
        let (size, negative) = self.prime.without_sign(values[0]);
        if parity != Parity::Neither {
            values[0] = size;
        }
        if parity == Parity::Odd && size.is_zero() {
            return Ok(size);
        }
        let value = self.unknown(FUNCTION + function as u64, &values, 0);
        Ok(if parity == Parity::Odd && negative { self.prime.negative(value) } else { value })
    }

    // ----------------------------------------------------------------------------------------------- exponentials

    /// The product of the factors of a term, and its scale.
    fn factors(&self, term: &Term) -> Result<Element, Halt> {
        let product = |product, id: &Id| Ok(self.prime.product(product, self.number(*id)?));
        let scale = self.constant(Number::Exact(term.scale))?;
        term.factors.iter().try_fold(scale, product)
    }

    /// An unknown for each value, to the power of the coefficient; that of −u is the reciprocal of that of u.
    fn factor(&self, kind: u64, base: &[Element], term: &Term) -> Result<Element, Halt> {
        let (size, negative) = self.prime.without_sign(self.factors(term)?);
        if size.is_zero() {
            return Ok(Element::ONE);
        }
        let unknown = self.unknown(kind, &[base, &[size]].concat(), 0);
        let exponent = self.plan.arguments.whole(term.coefficient).ok_or(Halt::GiveUp)?;
        self.power(unknown, if negative { -exponent } else { exponent })
    }

    fn exponential(&mut self, function: Function, argument: Id) -> Result<Element, Halt> {
        let plan = self.plan;
        let mut product = Element::ONE;
        for term in plan.arguments.terms(argument) {
            let factor = match (&term.factors[..], term.whole()) {
                ([], Some(n)) if function == Function::Exp2 => self.power(self.constant(Number::integer(2))?, n)?,
                // e^(n ln x) = xⁿ.
                ([ln], Some(n)) if function == Function::Exp && logarithm_of(plan.graph.node(*ln)).is_some() => {
                    let x = logarithm_of(plan.graph.node(*ln)).unwrap_or(*ln);
                    self.power(self.number(x)?, n)?
                }
                _ => self.factor(FUNCTION + function as u64, &[], term)?,
            };
            product = self.prime.product(product, factor);
        }
        Ok(product)
    }

    /// (w + 1/w)/2, (w − 1/w)/(2 unit), and their quotient, where w is e^(unit·x).
    fn wave(&mut self, function: Function, argument: Id, unit: Element) -> Result<Element, Halt> {
        let prime = self.prime;
        let trigonometric = unit == Element::I;
        let w = if trigonometric { self.circle(argument)? } else { self.exponential(Function::Exp, argument)? };
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

    /// e^(ix): an unknown for each term.
    fn circle(&self, argument: Id) -> Result<Element, Halt> {
        let mut product = Element::ONE;
        for term in self.plan.arguments.terms(argument) {
            product = self.prime.product(product, self.factor(FUNCTION + Function::Sin as u64, &[], term)?);
        }
        Ok(product)
    }

    /// xʸ: whole numbers in the exponent are powers, other terms unknowns.
    fn general_power(&mut self, x: Id, exponent: Id) -> Result<Element, Halt> {
        let (plan, base) = (self.plan, self.number(x)?);
        let mut product = Element::ONE;
        for term in plan.arguments.terms(exponent) {
            let factor = match (&term.factors[..], term.whole()) {
                ([], Some(n)) => self.power(base, n)?,
                _ => self.factor(FUNCTION + Function::Powf as u64, &[base], term)?,
            };
            product = self.prime.product(product, factor);
        }
        Ok(product)
    }

    // ------------------------------------------------------------------------------------------------- logarithms

    /// ln|x|, which is ln x where that is defined: the sum over the factors of x.
    fn logarithm(&mut self, x: Id) -> Result<Element, Halt> {
        let plan = self.plan;
        let (coefficient, rest) = plan.graph.coefficient(x);
        let mut sum = self.unit_logarithm(self.constant(coefficient)?);
        for (base, exponent) in plan.graph.factors(rest) {
            let exponent = self.constant(Number::Exact(exponent))?;
            let logarithm = match plan.graph.node(base) {
                Node::Call(Function::Exp, args) => self.number(args[0])?,
                Node::Linear(constant, terms) => {
                    let leading = if constant.is_zero() { terms[0].0 } else { *constant };
                    let leading = self.constant(leading)?;
                    self.normalised_logarithm(self.number(base)?, leading)?
                }
                _ => self.unit_logarithm(self.number(base)?),
            };
            sum = self.prime.sum(sum, self.prime.product(exponent, logarithm));
        }
        Ok(sum)
    }

    /// ln|1 + x|, as the logarithm of the sum.
    fn logarithm_of_more(&mut self, x: Id) -> Result<Element, Halt> {
        let constant = match self.plan.graph.node(x) {
            Node::Linear(constant, _) => self.constant(*constant)?,
            _ => Element::ZERO,
        };
        let sum = self.prime.sum(Element::ONE, self.number(x)?);
        let leading = self.prime.sum(Element::ONE, constant);
        self.normalised_logarithm(sum, if leading.is_zero() { Element::ONE } else { leading })
    }

    /// ln|x| = ln|leading| + ln|x/leading|.
    fn normalised_logarithm(&self, x: Element, leading: Element) -> Result<Element, Halt> {
        let normal = self.prime.product(x, self.reciprocal(leading)?);
        Ok(self.prime.sum(self.unit_logarithm(leading), self.unit_logarithm(normal)))
    }

    /// An unknown for each number but for its sign; 0 for 1.
    fn unit_logarithm(&self, x: Element) -> Element {
        let one = self.prime.without_sign(Element::ONE).0;
        match self.prime.without_sign(x).0 {
            size if size == one => Element::ZERO,
            size => self.unknown(FUNCTION + Function::Ln as u64, &[size], 0),
        }
    }
}

/// The argument, if a node is a logarithm.
fn logarithm_of(node: &Node) -> Option<Id> {
    match node {
        Node::Call(Function::Ln, args) => Some(args[0]),
        _ => None,
    }
}

const THIRD: Ratio = Ratio { numerator: 1, denominator: 3 };
