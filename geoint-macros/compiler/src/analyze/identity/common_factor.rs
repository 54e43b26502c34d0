//! Common factors of two expressions that are hidden in sums, as x − y in x² − y² and x² − 2xy + y².
//!
//! Both are multiplied out. All atoms but one get random values of a finite field, and Euclid's algorithm finds the common divisor of the two polynomials in the
//! remaining atom. Relations between atoms, such as sin² + cos² = 1, are not used, so factors that only they reveal are not found. Neither are
//! factors of expressions that are too long. An accident of the random values, with a probability near 1e-17, reports a factor that is none.

use super::multiplied::{Atom, Normal, Sums};
use super::residues::{Element, PRIMES, Polynomial, Prime, pseudorandom};
use super::surface::moves;
use crate::ir::{Graph, Id, Ratio};
use std::collections::BTreeSet;

const PRIME: Prime = PRIMES[0];

/// The largest number of products of two terms that are formed to multiply out the expressions.
const PRODUCTS: usize = 2_000;

/// The largest degree of a polynomial, and the largest common denominator of its exponents.
const HIGHEST: i128 = 64;

/// Returns whether two nodes have a common factor that may change during a run, after division by the factors in `known`, which the caller has examined.
pub(super) fn has_hidden_factor(graph: &mut Graph, nodes: [Id; 2], known: &[Id]) -> bool {
    let roots = [&nodes[..], known].concat();
    let Some(sums) = Sums::of(graph, &roots, PRODUCTS) else { return false };
    let Some(denominator) = common_denominator(roots.iter().map(|root| sums.normal(*root))) else { return false };
    let polynomial = |normal: &Normal, atom| polynomial(normal, atom, denominator);
    let normals = nodes.map(|node| sums.normal(node));
    let atoms = |normal: &Normal| -> BTreeSet<Atom> {
        normal.terms().flat_map(|(monomial, _)| monomial.iter().map(|(atom, _)| *atom)).collect()
    };
    let common: Vec<Atom> = atoms(normals[0]).intersection(&atoms(normals[1])).copied().collect();
    common.into_iter().any(|atom| {
        let node = sums.term(graph, &vec![(atom, Ratio::ONE)], Ratio::ONE);
        if !graph.symbols(node).into_iter().any(moves) {
            return false;
        }
        let [Some(a), Some(b)] = normals.map(|normal| polynomial(normal, atom)) else { return false };
        let known = known.iter().filter_map(|factor| polynomial(sums.normal(*factor), atom));
        known.fold(a.common_divisor(b), |left, factor| left.without_factor(&factor)).has_variable()
    })
}

/// Returns the common denominator of all exponents. `None` if it is too large.
fn common_denominator<'a>(normals: impl Iterator<Item = &'a Normal>) -> Option<i128> {
    let monomials = normals.flat_map(|normal| normal.terms().map(|(monomial, _)| monomial));
    let denominators: BTreeSet<i128> = monomials.flatten().map(|(_, exponent)| exponent.denominator).collect();
    (1..=HIGHEST).find(|all| denominators.iter().all(|denominator| all % denominator == 0))
}

/// Returns a sum as a polynomial in x, where `atom` = xᵈ and all other atoms are d-th powers of random numbers. `None` if the degree is too high.
fn polynomial(normal: &Normal, atom: Atom, denominator: i128) -> Option<Polynomial> {
    let whole = |exponent: Ratio| exponent.numerator * (denominator / exponent.denominator);
    let mut terms = vec![];
    for (monomial, coefficient) in normal.terms() {
        let (mut power, mut value) = (0, PRIME.ratio(coefficient)?);
        for (other, exponent) in monomial {
            let exponent = whole(*exponent);
            if *other == atom {
                power = exponent;
            } else {
                let random = PRIME.unknown(pseudorandom(*other as u64));
                value = PRIME.product(value, PRIME.power(random, i64::try_from(exponent).ok()?)?);
            }
        }
        terms.push((power, value));
    }
    // A power of the atom as a divisor does not change the other factors.
    let lowest = terms.iter().map(|(power, _)| *power).min()?.min(0);
    let degree = terms.iter().map(|(power, _)| power - lowest).max().filter(|degree| *degree <= HIGHEST)?;
    let mut coefficients = vec![Element::ZERO; degree as usize + 1];
    for (power, value) in terms {
        let entry = &mut coefficients[(power - lowest) as usize];
        *entry = PRIME.sum(*entry, value);
    }
    Some(Polynomial::new(PRIME, coefficients))
}
