//! Powers of normal forms. Positive integer powers are multiplied out; bases of roots and reciprocals are atoms.

use super::atoms::Kind;
use super::expand::{Expansion, Stop};
use super::normal::{Atom, Monomial, Normal};
use crate::ir::{Number, Ratio};

/// A power with more terms than this becomes one atom.
const MAX_POWER_TERMS: usize = 500;

impl Expansion<'_> {
    /// The normal form of baseᵉ.
    pub(super) fn power(&mut self, base: &Normal, exponent: Ratio) -> Result<Normal, Stop> {
        if exponent == Ratio::ZERO {
            return Ok(Normal::number(Ratio::ONE));
        }
        if let Some((monomial, coefficient)) = base.single() {
            return self.power_of_term(monomial, coefficient, exponent);
        }
        match exponent.to_i64() {
            // A division by zero. No form, because the node is not defined in this case.
            _ if base.is_empty() && exponent < Ratio::ZERO => Err(Stop::TooLong),
            _ if base.is_empty() => Ok(Normal::default()),
            Some(n) if n > 0 && terms_of_power(base.len(), n) > MAX_POWER_TERMS => {
                Ok(Normal::atom(self.atoms.of(Kind::Power(base.clone(), n))))
            }
            Some(n) if n > 0 => {
                let mut product = Normal::number(Ratio::ONE);
                for _ in 0..n {
                    product = self.product(&product, base)?;
                }
                Ok(product)
            }
            Some(_) => {
                // The leading coefficient is taken out, so that 1/(2a + 2b) and 1/(a + b) share an atom.
                let leading = base.leading();
                let scaled = base.scale(leading.recip().ok_or(Stop::TooLong)?).ok_or(Stop::TooLong)?;
                let coefficient = exact_power(leading, exponent).ok_or(Stop::TooLong)?;
                Ok(Normal::term(vec![(self.atoms.of(Kind::Sum(scaled)), exponent)], coefficient))
            }
            None => {
                let size = magnitude(base.leading());
                let (root, scaled) = match exact_power(size, exponent) {
                    Some(root) => (root, base.scale(size.recip().ok_or(Stop::TooLong)?).ok_or(Stop::TooLong)?),
                    None => (Ratio::ONE, base.clone()),
                };
                let power = vec![(self.atoms.of(Kind::Sum(scaled)), exponent)];
                self.product(&Normal::number(root), &Normal::term(power, Ratio::ONE))
            }
        }
    }

    /// (c·Π atomᵏ)ᵉ. A fractional exponent applies to each positive factor; the factors that may be negative stay together under the root.
    fn power_of_term(&mut self, monomial: &Monomial, c: Ratio, exponent: Ratio) -> Result<Normal, Stop> {
        let raised = |factors: &Monomial| -> Result<Monomial, Stop> {
            let raised = factors.iter().map(|(atom, power)| Some((*atom, power.mul(exponent)?)));
            raised.collect::<Option<_>>().ok_or(Stop::TooLong)
        };
        if exponent.is_integer() {
            let (powers, c) = (raised(monomial)?, exact_power(c, exponent).ok_or(Stop::TooLong)?);
            return self.product(&Normal::number(c), &Normal::term(powers, Ratio::ONE));
        }
        // A root of an atom is positive, except a cube root.
        let is_positive = |(atom, power): &&(Atom, Ratio)| {
            let is_root = !power.is_integer() && !matches!(self.atoms.kind(*atom), Kind::Cbrt(_));
            is_root || self.atoms.is_positive(*atom)
        };
        let (positive, open): (Monomial, Monomial) = monomial.iter().partition(is_positive);
        let factors = raised(&positive)?;
        let (number, inside) = match exact_power(magnitude(c), exponent) {
            Some(root) => (root, if c < Ratio::ZERO { Ratio::integer(-1) } else { Ratio::ONE }),
            None => (Ratio::ONE, c),
        };
        let rest = match open[..] {
            [] if inside == Ratio::ONE => vec![],
            [] if inside > Ratio::ZERO => vec![(self.atoms.of(Kind::Ratio(inside)), exponent)],
            [(atom, Ratio::ONE)] if inside == Ratio::ONE => vec![(atom, exponent)],
            _ => vec![(self.atoms.of(Kind::Sum(Normal::term(open, inside))), exponent)],
        };
        self.product(&Normal::term(factors, number), &Normal::term(rest, Ratio::ONE))
    }
}

/// An upper bound of the number of terms of the n-th power of a sum.
fn terms_of_power(terms: usize, n: i64) -> usize {
    (1..terms).fold(1_usize, |count, k| count.saturating_mul(n as usize + k) / k)
}

pub(super) fn magnitude(x: Ratio) -> Ratio {
    if x < Ratio::ZERO { x.neg() } else { x }
}

/// xᵉ, if the value is a ratio.
fn exact_power(x: Ratio, exponent: Ratio) -> Option<Ratio> {
    match Number::Exact(root(x, exponent.denominator)?).pow(Ratio::integer(exponent.numerator))? {
        Number::Exact(power) => Some(power),
        Number::Root(..) | Number::Float(_) => None,
    }
}

/// The n-th root, if it is a ratio.
fn root(x: Ratio, n: i128) -> Option<Ratio> {
    if n == 1 {
        return Some(x);
    }
    let of = |x: i128| {
        let root = (x as f64).powf(1.0 / n as f64).round() as i128;
        (root.checked_pow(u32::try_from(n).ok()?)? == x).then_some(root)
    };
    if x < Ratio::ZERO { None } else { Ratio::new(of(x.numerator)?, of(x.denominator)?) }
}
