//! Polynomials in one variable over a finite field, and their common factors.

use super::prime::{Element, Prime};

/// Coefficients from the lowest power on. Invariant: the last one is not zero. The polynomial 0 has none.
#[derive(Clone)]
pub(in super::super) struct Polynomial {
    prime: Prime,
    coefficients: Vec<Element>,
}

impl Polynomial {
    pub(in super::super) fn new(prime: Prime, mut coefficients: Vec<Element>) -> Polynomial {
        while coefficients.pop_if(|last| last.is_zero()).is_some() {}
        Polynomial { prime, coefficients }
    }

    /// Returns whether the polynomial reads its variable.
    pub(in super::super) fn has_variable(&self) -> bool {
        self.coefficients.len() > 1
    }

    fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// Returns the greatest common divisor, up to a number (Euclid).
    pub(in super::super) fn common_divisor(self, other: Polynomial) -> Polynomial {
        let (mut a, mut b) = (self, other);
        while !b.is_zero() {
            let rest = a.divided(&b).1;
            (a, b) = (b, rest);
        }
        a
    }

    /// Divides by a factor as often as possible. A factor without the variable changes nothing.
    pub(in super::super) fn without_factor(mut self, factor: &Polynomial) -> Polynomial {
        while factor.has_variable() && !self.is_zero() {
            let (quotient, rest) = self.divided(factor);
            if !rest.is_zero() {
                break;
            }
            self = quotient;
        }
        self
    }

    /// Returns the quotient and the remainder. Precondition: the divisor is not 0.
    fn divided(&self, divisor: &Polynomial) -> (Polynomial, Polynomial) {
        let prime = self.prime;
        let (mut rest, mut quotient) = (self.coefficients.clone(), vec![]);
        let reciprocal = divisor.coefficients.last().and_then(|last| prime.reciprocal(*last)).unwrap_or(Element::ZERO);
        while rest.len() >= divisor.coefficients.len() {
            let shift = rest.len() - divisor.coefficients.len();
            let Some(last) = rest.pop() else { break };
            let c = prime.product(last, reciprocal);
            quotient.push(c);
            for (rest, other) in rest[shift..].iter_mut().zip(&divisor.coefficients) {
                *rest = prime.difference(*rest, prime.product(c, *other));
            }
        }
        quotient.reverse();
        (Polynomial::new(prime, quotient), Polynomial::new(prime, rest))
    }
}
