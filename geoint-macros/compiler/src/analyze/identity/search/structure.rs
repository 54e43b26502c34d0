//! A skew matrix S with S∇I = f, by linear algebra.
//!
//! The sum Σ S_ij ∂_jI has to give the terms of f_i, so entries are made of quotients of terms of f and ∇I. The remaining terms of the sum have
//! to cancel, which asks for more entries. If several S are possible, entries of neighbouring coordinates are preferred. If none is found, and I
//! is linear in some x_r, then S_ir = f_i/∂_rI.

use super::super::claims;
use super::super::multiplied::{Monomial, Normal, Sums, product_of_monomials};
use super::{PRODUCTS, Vanishing};
use crate::analyze::equations::Row;
use crate::diff;
use crate::ir::{Graph, Id, Node, Ratio, Symbol};
use std::cmp::Reverse;
use std::collections::BTreeSet;

/// A skew matrix S.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Structure {
    pub(crate) matrix: Vec<Vec<Id>>,
    /// No other S is made of products of these kinds.
    pub(crate) unique: bool,
}

/// The largest number of products in entries.
const UNKNOWNS: usize = 400;

/// The number of rounds in which entries are added to cancel remaining terms.
const ROUNDS: usize = 3;

/// A product with an unknown coefficient in an entry S_ij, i < j. In this order neighbouring coordinates are last; their coefficients are solved
/// for first.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Entry {
    /// j − i.
    distance: Reverse<usize>,
    row: usize,
    product: Monomial,
}

impl Entry {
    /// The places (i, j) and (j, i) of the entry, with its signs there.
    fn places(&self) -> [(usize, usize, Ratio); 2] {
        let (i, j) = (self.row, self.row + self.distance.0);
        [(i, j, Ratio::ONE), (j, i, Ratio::integer(-1))]
    }
}

/// Returns S, proven to satisfy S∇I = f.
pub(crate) fn structure(graph: &mut Graph, x: &[Symbol], field: &[Id], integral: Id) -> Option<Structure> {
    let gradient = diff::jacobian(graph, &[integral], x).remove(0);
    let proven = |graph: &mut Graph, found: Option<Structure>| {
        found.filter(|found| claims::is_gradient_form(graph, x, &found.matrix, integral, field).is_ok())
    };
    let found = by_terms(graph, field, &gradient);
    proven(graph, found).or_else(|| {
        let found = by_linear_coordinate(graph, field, &gradient);
        proven(graph, found)
    })
}

fn by_terms(graph: &mut Graph, field: &[Id], gradient: &[Id]) -> Option<Structure> {
    let n = field.len();
    let sums = Sums::of(graph, &[field, gradient].concat(), PRODUCTS)?;
    let [f, slopes] = [field, gradient].map(|ids| ids.iter().map(|id| sums.normal(*id)).collect::<Vec<&Normal>>());
    let monomials = |sum: &&Normal| sum.terms().map(|(monomial, _)| monomial.clone()).collect();
    // The terms of each component that entries have to give or to cancel.
    let mut asked: Vec<BTreeSet<Monomial>> = f.iter().map(monomials).collect();
    let mut entries: BTreeSet<Entry> = BTreeSet::new();
    for _ in 0..ROUNDS {
        let before = entries.len();
        for (i, asked) in asked.iter().enumerate() {
            for (j, slope) in slopes.iter().enumerate().filter(|(j, _)| *j != i) {
                let pairs = asked.iter().flat_map(|asked| slope.terms().map(move |(divisor, _)| (asked, divisor)));
                let products = pairs.filter_map(|(asked, divisor)| quotient(graph, &sums, asked, divisor));
                let entry = |product| Entry { distance: Reverse(i.abs_diff(j)), row: i.min(j), product };
                entries.extend(products.map(entry));
                if entries.len() > UNKNOWNS {
                    return None;
                }
            }
        }
        if entries.len() == before {
            return None;
        }
        let solutions = solutions(&entries, &f, &slopes)?;
        if let Some(solution) = solutions.iter().find(|solution| solution.contains_key(&0)) {
            let mut matrix = vec![vec![graph.zero(); n]; n];
            for (k, entry) in entries.iter().enumerate() {
                let Some(coefficient) = solution.get(&(k + 1)) else { continue };
                let [(i, j, _), _] = entry.places();
                let product = sums.term(graph, &entry.product, *coefficient);
                matrix[i][j] = graph.add(matrix[i][j], product);
                matrix[j][i] = graph.neg(matrix[i][j]);
            }
            return Some(Structure { matrix, unique: solutions.len() == 1 });
        }
        for entry in &entries {
            for (i, j, _) in entry.places() {
                for (slope, _) in slopes[j].terms() {
                    asked[i].insert(product_of_monomials(&entry.product, slope)?);
                }
            }
        }
    }
    None
}

/// The quotient a/b. `None` if it divides by an atom that a does not divide by. Parameters may be divided by.
fn quotient(graph: &Graph, sums: &Sums, a: &Monomial, b: &Monomial) -> Option<Monomial> {
    let reciprocal = b.iter().map(|(atom, exponent)| (*atom, exponent.neg())).collect();
    let quotient = product_of_monomials(a, &reciprocal)?;
    let is_allowed = quotient.iter().all(|(atom, exponent)| {
        let symbol = sums.as_symbol(*atom).map(|id| graph.node(id));
        let had = a.iter().find(|(other, _)| other == atom).map_or(Ratio::ZERO, |(_, exponent)| *exponent);
        *exponent > Ratio::ZERO || *exponent >= had || matches!(symbol, Some(Node::Symbol(Symbol::Parameter(_))))
    });
    is_allowed.then_some(quotient)
}

/// A basis of the solutions of S∇I = c·f. The unknown 0 is c, and the unknown k + 1 the coefficient of the k-th entry. `None` if numbers are too
/// long.
fn solutions(entries: &BTreeSet<Entry>, f: &[&Normal], slopes: &[&Normal]) -> Option<Vec<Row>> {
    let mut equations = Vanishing::default();
    for (i, f) in f.iter().enumerate() {
        equations.add(i, 0, &f.scale(Ratio::integer(-1))?)?;
    }
    for (k, entry) in entries.iter().enumerate() {
        for (i, j, sign) in entry.places() {
            equations.add(i, k + 1, &slopes[j].times(&entry.product)?.scale(sign)?)?;
        }
    }
    equations.solutions(entries.len() + 1)
}

/// S_ir = f_i/∂_rI for a coordinate x_r in which I is linear with a constant slope.
fn by_linear_coordinate(graph: &mut Graph, field: &[Id], gradient: &[Id]) -> Option<Structure> {
    let n = field.len();
    let is_constant = |id: &Id| graph.as_number(*id).is_some_and(|number| !number.is_zero());
    let r = gradient.iter().position(is_constant)?;
    let mut matrix = vec![vec![graph.zero(); n]; n];
    for i in (0..n).filter(|i| *i != r) {
        matrix[i][r] = graph.div(field[i], gradient[r]);
        matrix[r][i] = graph.neg(matrix[i][r]);
    }
    Some(Structure { matrix, unique: false })
}
