//! A skew matrix S with S∇I = f, by linear algebra: which products its entries may be made of follows from the terms of f and ∇I.
//!
//! S_ij ∂_jI has to give the terms of f_i, so that entries are quotients of both; and what it gives beside them has to cancel, which
//! asks for more entries. Where several S do, coordinates next to each other are preferred. If there is none, and I is linear in some x_r,
//! S_ir = f_i/∂_rI.

use super::super::claims;
use super::super::multiplied::{Normal, Powers, Sums, product_of_powers};
use super::PRODUCTS;
use crate::analyze::equations::{Equations, Row};
use crate::diff;
use crate::ir::{Graph, Id, Node, Ratio, Symbol};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// S, and whether it is the only one that is made of such products.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Structure {
    pub(crate) matrix: Vec<Vec<Id>>,
    pub(crate) unique: bool,
}

/// So many products are tried at once.
const UNKNOWNS: usize = 400;

/// So often entries are added for what others leave.
const ROUNDS: usize = 3;

/// An entry S_ij with i < j, and a product in it. Entries of coordinates next to each other are the last ones: those are solved for.
type Entry = (Reverse<usize>, usize, Powers);

/// S with S∇I = f, proven.
pub(crate) fn structure(graph: &mut Graph, x: &[Symbol], field: &[Id], integral: Id) -> Option<Structure> {
    let gradient = diff::jacobian(graph, &[integral], x).remove(0);
    let proven = |graph: &mut Graph, found: Option<Structure>| {
        found.filter(|found| claims::is_gradient_form(graph, x, &found.matrix, integral, field).is_ok())
    };
    let found = by_terms(graph, x, field, &gradient);
    proven(graph, found).or_else(|| {
        let found = hub(graph, field, &gradient);
        proven(graph, found)
    })
}

fn by_terms(graph: &mut Graph, x: &[Symbol], field: &[Id], gradient: &[Id]) -> Option<Structure> {
    let n = x.len();
    let sums = Sums::of(graph, &[field, gradient].concat(), PRODUCTS)?;
    let (f, slopes) = sums.sums.split_at(n);
    let mut asked: Vec<BTreeSet<Powers>> =
        f.iter().map(|f| f.terms().map(|(powers, _)| powers.clone()).collect()).collect();
    let mut entries: BTreeSet<Entry> = BTreeSet::new();
    for _ in 0..ROUNDS {
        let before = entries.len();
        for i in 0..n {
            for j in i + 1..n {
                let (near, far) = ((&asked[i], &slopes[j]), (&asked[j], &slopes[i]));
                for (asked, slope) in [near, far] {
                    let quotients =
                        asked.iter().flat_map(|asked| slope.terms().map(move |(powers, _)| (asked, powers)));
                    for (asked, powers) in quotients {
                        let Some(entry) = quotient(graph, &sums, asked, powers) else { continue };
                        entries.insert((Reverse(j - i), i, entry));
                        if entries.len() > UNKNOWNS {
                            return None;
                        }
                    }
                }
            }
        }
        if entries.len() == before {
            return None;
        }
        let all: Vec<Entry> = entries.iter().cloned().collect();
        if let Some((solution, unique)) = solved(&all, f, slopes)? {
            let mut matrix = vec![vec![graph.zero(); n]; n];
            for (entry, coefficient) in solution.into_iter().filter(|(entry, _)| *entry > 0) {
                let (Reverse(distance), i, powers) = &all[entry - 1];
                let (i, j) = (*i, i + distance);
                let product = sums.product(graph, powers, coefficient);
                matrix[i][j] = graph.add(matrix[i][j], product);
                matrix[j][i] = graph.neg(matrix[i][j]);
            }
            return Some(Structure { matrix, unique });
        }
        for (Reverse(distance), i, powers) in &entries {
            for (i, j) in [(*i, i + distance), (i + distance, *i)] {
                for (slope, _) in slopes[j].terms() {
                    asked[i].insert(product_of_powers(powers, slope)?);
                }
            }
        }
    }
    None
}

/// a/b, unless that divides by what a does not divide by; parameters are not asked.
fn quotient(graph: &Graph, sums: &Sums, a: &Powers, b: &Powers) -> Option<Powers> {
    let reciprocal = b.iter().map(|(atom, exponent)| Some((*atom, exponent.mul(Ratio::integer(-1))?)));
    let quotient = product_of_powers(a, &reciprocal.collect::<Option<_>>()?)?;
    let allowed = quotient.iter().all(|(atom, exponent)| {
        let symbol = sums.as_symbol(*atom).map(|id| graph.node(id));
        let had = a.iter().find(|(other, _)| other == atom).map_or(Ratio::ZERO, |(_, exponent)| *exponent);
        *exponent > Ratio::ZERO || *exponent >= had || matches!(symbol, Some(Node::Symbol(Symbol::Parameter(_))))
    });
    allowed.then_some(quotient)
}

/// The coefficients of entries, after that of f, which is 1; and whether there are no others. `None` if numbers are too long.
fn solved(entries: &[Entry], f: &[Normal], slopes: &[Normal]) -> Option<Option<(Row, bool)>> {
    let mut rows: BTreeMap<(usize, Powers), Row> = BTreeMap::new();
    let mut include = |i: usize, powers: Powers, unknown: usize, coefficient: Ratio| {
        let row = rows.entry((i, powers)).or_default();
        let sum = row.get(&unknown).copied().unwrap_or(Ratio::ZERO).add(coefficient)?;
        if sum == Ratio::ZERO {
            row.remove(&unknown)
        } else {
            row.insert(unknown, sum)
        };
        Some(())
    };
    let minus = Ratio::integer(-1);
    for (i, f) in f.iter().enumerate() {
        for (powers, coefficient) in f.terms() {
            include(i, powers.clone(), 0, coefficient.mul(minus)?)?;
        }
    }
    for (k, (Reverse(distance), i, entry)) in entries.iter().enumerate() {
        for (i, j, sign) in [(*i, i + distance, Ratio::ONE), (i + distance, *i, minus)] {
            for (powers, coefficient) in slopes[j].terms() {
                include(i, product_of_powers(entry, powers)?, k + 1, coefficient.mul(sign)?)?;
            }
        }
    }
    let mut equations = Equations::new(entries.len() + 1);
    for row in rows.into_values() {
        equations.add(row)?;
    }
    let solutions = equations.solutions()?;
    let unique = solutions.len() == 1;
    Some(solutions.into_iter().find(|solution| solution.contains_key(&0)).map(|solution| (solution, unique)))
}

/// S_ir = f_i/∂_rI for a coordinate in which I is linear, with a number for its slope.
fn hub(graph: &mut Graph, field: &[Id], gradient: &[Id]) -> Option<Structure> {
    let n = field.len();
    let number = |id: &Id| graph.as_number(*id).is_some_and(|number| !number.is_zero());
    let r = gradient.iter().position(number)?;
    let mut matrix = vec![vec![graph.zero(); n]; n];
    for i in (0..n).filter(|i| *i != r) {
        matrix[i][r] = graph.div(field[i], gradient[r]);
        matrix[r][i] = graph.neg(matrix[i][r]);
    }
    Some(Structure { matrix, unique: false })
}
