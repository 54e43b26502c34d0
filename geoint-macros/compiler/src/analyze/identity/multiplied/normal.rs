//! Normal forms: sums of monomials with exact coefficients.

use crate::ir::Ratio;
use std::collections::BTreeMap;

/// The number of an unknown in the table of atoms.
pub(in super::super) type Atom = usize;

/// A monomial Π atomᵉ as pairs (atom, e), sorted by atom. Invariant: no exponent is zero.
pub(in super::super) type Monomial = Vec<(Atom, Ratio)>;

/// Σ coefficient·monomial. Invariant: no coefficient is zero. Atoms count as independent, so a sum is zero if it has no terms.
///
/// Arithmetic returns `None` if a number becomes too long.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in super::super) struct Normal(BTreeMap<Monomial, Ratio>);

impl Normal {
    /// The sum with one term. It is empty if the coefficient is zero.
    pub(super) fn term(monomial: Monomial, coefficient: Ratio) -> Normal {
        let mut normal = Normal::default();
        if coefficient != Ratio::ZERO {
            normal.0.insert(monomial, coefficient);
        }
        normal
    }

    pub(super) fn number(value: Ratio) -> Normal {
        Normal::term(vec![], value)
    }

    pub(super) fn atom(atom: Atom) -> Normal {
        Normal::term(vec![(atom, Ratio::ONE)], Ratio::ONE)
    }

    pub(in super::super) fn terms(&self) -> impl Iterator<Item = (&Monomial, Ratio)> {
        self.0.iter().map(|(monomial, coefficient)| (monomial, *coefficient))
    }

    /// The monomials except 1.
    pub(super) fn monomials(&self) -> impl Iterator<Item = &Monomial> {
        self.0.keys().filter(|monomial| !monomial.is_empty())
    }

    pub(super) fn coefficient(&self, monomial: &Monomial) -> Ratio {
        self.0.get(monomial).copied().unwrap_or(Ratio::ZERO)
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    pub(in super::super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The term, if the sum has exactly one.
    pub(super) fn single(&self) -> Option<(&Monomial, Ratio)> {
        self.terms().next().filter(|_| self.len() == 1)
    }

    /// The value, if the sum has no atoms.
    pub(super) fn as_number(&self) -> Option<Ratio> {
        self.monomials().next().is_none().then(|| self.coefficient(&vec![]))
    }

    /// The coefficient of the first term, or 1 if there is none.
    pub(super) fn leading(&self) -> Ratio {
        self.terms().next().map_or(Ratio::ONE, |(_, coefficient)| coefficient)
    }

    pub(super) fn add_term(&mut self, monomial: Monomial, coefficient: Ratio) -> Option<()> {
        let sum = self.coefficient(&monomial).add(coefficient)?;
        if sum == Ratio::ZERO {
            self.0.remove(&monomial);
        } else {
            self.0.insert(monomial, sum);
        }
        Some(())
    }

    /// self + factor·other.
    pub(in super::super) fn add(mut self, factor: Ratio, other: &Normal) -> Option<Normal> {
        for (monomial, coefficient) in other.terms() {
            self.add_term(monomial.clone(), coefficient.mul(factor)?)?;
        }
        Some(self)
    }

    pub(in super::super) fn scale(&self, factor: Ratio) -> Option<Normal> {
        Normal::default().add(factor, self)
    }

    /// self·factor, where powers of atoms are not reduced.
    pub(in super::super) fn times(&self, factor: &Monomial) -> Option<Normal> {
        let mut product = Normal::default();
        for (monomial, coefficient) in self.terms() {
            product.add_term(product_of_monomials(monomial, factor)?, coefficient)?;
        }
        Some(product)
    }
}

/// The product of two monomials; `None` if an exponent becomes too long.
pub(in super::super) fn product_of_monomials(a: &Monomial, b: &Monomial) -> Option<Monomial> {
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
