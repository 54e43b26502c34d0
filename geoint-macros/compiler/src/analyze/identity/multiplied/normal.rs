//! Sums of monomials with exact coefficients, multiplied out.

use crate::ir::Ratio;
use std::collections::BTreeMap;

/// An unknown, by its number in the table of atoms.
pub(in super::super) type Atom = usize;

/// Π atomᵉ, in order of the atoms; no exponent is zero.
pub(in super::super) type Powers = Vec<(Atom, Ratio)>;

/// Σ coefficient·Π atomᵉ; no coefficient is zero. Different atoms are independent, so that a sum is zero if it is empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in super::super) struct Normal(BTreeMap<Powers, Ratio>);

impl Normal {
    pub(super) fn term(powers: Powers, coefficient: Ratio) -> Normal {
        let mut normal = Normal::default();
        if coefficient != Ratio::ZERO {
            normal.0.insert(powers, coefficient);
        }
        normal
    }

    pub(super) fn number(value: Ratio) -> Normal {
        Normal::term(vec![], value)
    }

    pub(super) fn atom(atom: Atom) -> Normal {
        Normal::term(vec![(atom, Ratio::ONE)], Ratio::ONE)
    }

    pub(in super::super) fn terms(&self) -> impl Iterator<Item = (&Powers, Ratio)> {
        self.0.iter().map(|(powers, coefficient)| (powers, *coefficient))
    }

    /// The products of atoms, without that of none.
    pub(super) fn monomials(&self) -> impl Iterator<Item = &Powers> {
        self.0.keys().filter(|powers| !powers.is_empty())
    }

    pub(super) fn coefficient(&self, monomial: &Powers) -> Ratio {
        self.0.get(monomial).copied().unwrap_or(Ratio::ZERO)
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    pub(in super::super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The only term.
    pub(super) fn single(&self) -> Option<(&Powers, Ratio)> {
        self.terms().next().filter(|_| self.len() == 1)
    }

    /// The value, if it has no atoms.
    pub(super) fn as_number(&self) -> Option<Ratio> {
        match self.single() {
            None if self.is_empty() => Some(Ratio::ZERO),
            Some((powers, value)) if powers.is_empty() => Some(value),
            _ => None,
        }
    }

    /// The coefficient of the first term.
    pub(super) fn leading(&self) -> Ratio {
        self.terms().next().map_or(Ratio::ONE, |(_, coefficient)| coefficient)
    }

    /// Adds a term; `None` if a coefficient becomes too long, as below.
    pub(in super::super) fn add_term(&mut self, powers: Powers, coefficient: Ratio) -> Option<()> {
        let sum = self.0.get(&powers).map_or(Some(coefficient), |own| own.add(coefficient))?;
        if sum == Ratio::ZERO {
            self.0.remove(&powers);
        } else {
            self.0.insert(powers, sum);
        }
        Some(())
    }

    /// self + factor·other.
    pub(in super::super) fn add(mut self, factor: Ratio, other: &Normal) -> Option<Normal> {
        for (powers, coefficient) in other.terms() {
            self.add_term(powers.clone(), coefficient.mul(factor)?)?;
        }
        Some(self)
    }

    pub(super) fn scale(&self, factor: Ratio) -> Option<Normal> {
        Normal::default().add(factor, self)
    }

    /// The number in it, and the rest.
    pub(super) fn parted(&self) -> (Ratio, Normal) {
        let mut rest = self.clone();
        let constant = rest.0.remove(&vec![]).unwrap_or(Ratio::ZERO);
        (constant, rest)
    }
}

/// The product of two monomials.
pub(in super::super) fn multiplied(a: &Powers, b: &Powers) -> Option<Powers> {
    let mut product = a.clone();
    for (atom, exponent) in b {
        match product.binary_search_by_key(atom, |(atom, _)| *atom) {
            Ok(i) => product[i].1 = product[i].1.add(*exponent)?,
            Err(i) => product.insert(i, (*atom, *exponent)),
        }
    }
    product.retain(|(_, exponent)| *exponent != Ratio::ZERO);
    Some(product)
}
