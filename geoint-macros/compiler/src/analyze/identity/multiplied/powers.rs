//! Powers of what is multiplied out: whole ones are products, roots and reciprocals unknowns.

use super::atoms::Kind;
use super::expand::{Expansion, Stop};
use super::normal::{Atom, Normal, Powers};
use crate::ir::{Number, Ratio};

/// A power that would have more terms than this stays one unknown.
const MAX_POWER_TERMS: usize = 500;

impl Expansion<'_> {
    /// baseᵉ.
    pub(super) fn power(&mut self, base: &Normal, exponent: Ratio) -> Result<Normal, Stop> {
        if exponent == Ratio::ZERO {
            return Ok(Normal::number(Ratio::ONE));
        }
        if let Some((powers, coefficient)) = base.single() {
            return self.power_of_term(powers, coefficient, exponent);
        }
        match exponent.to_integer() {
            // A power of what is zero in this case: not defined, unless it is zero as well.
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
                // But for its first coefficient, so that 1/(2a + 2b) is 1/(a + b) as well.
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

    /// (c·Π atomᵏ)ᵉ. A broken power applies to each factor that is positive; what may be negative stays together.
    fn power_of_term(&mut self, powers: &Powers, c: Ratio, exponent: Ratio) -> Result<Normal, Stop> {
        let raised = |(atom, power): &(Atom, Ratio)| Some((*atom, power.mul(exponent)?));
        if exponent.is_integer() {
            let powers: Option<Powers> = powers.iter().map(raised).collect();
            let (powers, c) = (powers.ok_or(Stop::TooLong)?, exact_power(c, exponent).ok_or(Stop::TooLong)?);
            return self.product(&Normal::number(c), &Normal::term(powers, Ratio::ONE));
        }
        let positive =
            |(atom, power): &(Atom, Ratio)| self.atoms.is_positive(*atom) || !power.is_integer() && !self.is_odd(*atom);
        let (positive, open): (Powers, Powers) = powers.iter().partition(|factor| positive(factor));
        let factors: Powers = positive.iter().map(raised).collect::<Option<_>>().ok_or(Stop::TooLong)?;
        let (mut number, mut inside) = (Ratio::ONE, c);
        if let Some(root) = exact_power(magnitude(c), exponent) {
            (number, inside) = (root, if c < Ratio::ZERO { Ratio::integer(-1) } else { Ratio::ONE });
        }
        let rest = match open[..] {
            [] if inside == Ratio::ONE => vec![],
            [] if inside > Ratio::ZERO => vec![(self.atoms.of(Kind::Ratio(inside)), exponent)],
            [(atom, Ratio::ONE)] if inside == Ratio::ONE => vec![(atom, exponent)],
            _ => vec![(self.atoms.of(Kind::Sum(Normal::term(open, inside))), exponent)],
        };
        self.product(&Normal::term(factors, number), &Normal::term(rest, Ratio::ONE))
    }

    /// Whether broken powers of an atom do not say that it is positive.
    fn is_odd(&self, atom: Atom) -> bool {
        matches!(self.atoms.kind(atom), Kind::Cbrt(_))
    }
}

/// How many terms the n-th power of a sum has at most.
fn terms_of_power(terms: usize, n: i64) -> usize {
    (1..terms).fold(1_usize, |count, k| count.saturating_mul(n as usize + k) / k)
}

pub(super) fn magnitude(x: Ratio) -> Ratio {
    if x < Ratio::ZERO { x.neg() } else { x }
}

/// xᵉ, if that is a ratio.
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
