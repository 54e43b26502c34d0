//! Functions that are constant along given fields, by linear algebra: combinations of monomials of degree one and two and of
//! logarithms of coordinates, with numbers and products of parameters as coefficients.
//!
//! Along one field they are its first integrals, along the rows of a skew matrix its Casimirs. The equations say that what is multiplied
//! out vanishes, with roots, functions and reciprocals of sums as unknowns: all that is listed is proven, but not all is listed.

mod multiplier;
mod span;
mod structure;

use super::multiplied::{Atom, Normal, Powers, Sums, product_of_powers};
use crate::analyze::equations::{Equations, Row};
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};
pub(crate) use multiplier::multiplier;
use span::Span;
use std::collections::{BTreeMap, BTreeSet};
pub(crate) use structure::{Structure, structure};

/// A function that is constant along all fields.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Kept {
    pub(crate) value: Id,
    /// Whether it is linear: every Runge–Kutta method keeps it then.
    pub(crate) linear: bool,
}

/// What combinations are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Candidate {
    Linear(usize),
    Logarithm(usize),
    Square(usize, usize),
}

/// So many products of two terms for multiplying out.
const PRODUCTS: usize = 5_000;

/// So many coefficients are sought at once.
const UNKNOWNS: usize = 600;

/// All independent combinations that are constant along each of `fields`, whose components are in the order of `x`; linear ones first,
/// products of those left out. `None` if the fields are too long, or have conditions.
pub(crate) fn kept_along(graph: &mut Graph, x: &[Symbol], fields: &[Vec<Id>]) -> Option<Vec<Kept>> {
    let coordinates: Vec<Id> = x.iter().map(|symbol| graph.symbol(*symbol)).collect();
    let mut sums = Sums::of(graph, &fields.concat(), PRODUCTS)?;
    let atoms: Vec<Atom> = coordinates.iter().map(|id| sums.symbol(*id)).collect();
    // The logarithm of a coordinate that stands still is a function of it.
    let moves = |i: usize| sums.sums.chunks(x.len()).any(|field| !field[i].is_empty());
    let candidates = candidates(x.len(), moves);
    let slopes: Option<Vec<Vec<Normal>>> =
        candidates.iter().map(|candidate| slopes(*candidate, &sums.sums, &atoms)).collect();
    let slopes = slopes?;
    let parameters = parameters(graph, &sums, x);
    let mut span = Span::default();
    let mut found = vec![];
    for degree in 0..=2 {
        // Linear ones, then all: products of linear ones are known by then.
        for linear in [true, false] {
            let unknowns = unknowns(&candidates, &parameters, degree, linear);
            if unknowns.len() > UNKNOWNS {
                continue;
            }
            for solution in solutions(&slopes, &unknowns)? {
                let terms: Vec<(usize, &Powers, Ratio)> =
                    solution.iter().map(|(u, c)| (unknowns[*u].candidate, &unknowns[*u].weight, *c)).collect();
                if span.add(&terms, &candidates) {
                    let value = node(graph, &coordinates, &candidates, &sums, &terms);
                    found.push(Kept { value, linear });
                }
            }
        }
        if parameters.is_empty() {
            break;
        }
    }
    found.sort_by_key(|kept| !kept.linear);
    Some(found)
}

fn candidates(n: usize, moves: impl Fn(usize) -> bool) -> Vec<Candidate> {
    let linear = (0..n).map(Candidate::Linear);
    let logarithms = (0..n).filter(|i| moves(*i)).map(Candidate::Logarithm);
    let squares = (0..n).flat_map(|i| (i..n).map(move |j| Candidate::Square(i, j)));
    linear.chain(logarithms).chain(squares).collect()
}

/// The derivative of a candidate along each of the fields, whose components are one after the other.
fn slopes(candidate: Candidate, components: &[Normal], x: &[Atom]) -> Option<Vec<Normal>> {
    let slope = |field: &[Normal]| match candidate {
        Candidate::Linear(i) => Some(field[i].clone()),
        Candidate::Logarithm(i) => times(&field[i], x[i], -1),
        Candidate::Square(i, j) => times(&field[i], x[j], 1)?.add(Ratio::ONE, &times(&field[j], x[i], 1)?),
    };
    components.chunks(x.len()).map(slope).collect()
}

/// A sum times a power of an atom.
fn times(sum: &Normal, atom: Atom, power: i128) -> Option<Normal> {
    let mut product = Normal::default();
    for (powers, coefficient) in sum.terms() {
        product.add_term(product_of_powers(powers, &vec![(atom, Ratio::integer(power))])?, coefficient)?;
    }
    Some(product)
}

/// The parameters that the fields read, and their reciprocals if the fields are divided by them.
fn parameters(graph: &Graph, sums: &Sums, x: &[Symbol]) -> Vec<(Atom, Ratio)> {
    let factors = sums.sums.iter().flat_map(|sum| sum.terms().flat_map(|(powers, _)| powers.iter().copied()));
    let parameter = |(atom, _): &(Atom, Ratio)| match sums.as_symbol(*atom).map(|id| graph.node(id)) {
        Some(Node::Symbol(symbol)) => *symbol != Symbol::Time && !x.contains(symbol),
        _ => false,
    };
    let sign = |exponent: Ratio| Ratio::integer(if exponent < Ratio::ZERO { -1 } else { 1 });
    let parameters = factors.filter(parameter).map(|(atom, exponent)| (atom, sign(exponent)));
    parameters.collect::<BTreeSet<_>>().into_iter().collect()
}

/// A coefficient that is sought: a number times a product of parameters times a candidate.
struct Unknown {
    candidate: usize,
    weight: Powers,
}

/// Products of at most so many parameters before each candidate.
fn unknowns(candidates: &[Candidate], parameters: &[(Atom, Ratio)], degree: usize, linear: bool) -> Vec<Unknown> {
    let mut weights: Vec<Powers> = vec![vec![]];
    for _ in 0..degree {
        let products = weights
            .iter()
            .flat_map(|weight| parameters.iter().filter_map(|parameter| product_of_powers(weight, &vec![*parameter])));
        let new: BTreeSet<Powers> = products.filter(|product| !weights.contains(product)).collect();
        weights.extend(new);
    }
    let chosen = |candidate: &Candidate| !linear || matches!(candidate, Candidate::Linear(_));
    let of = |k: usize| weights.iter().map(move |weight| Unknown { candidate: k, weight: weight.clone() });
    let all = candidates.iter().enumerate().filter(|(_, candidate)| chosen(candidate));
    all.flat_map(|(k, _)| of(k).collect::<Vec<_>>()).collect()
}

/// A basis of the coefficients for which all derivatives vanish.
fn solutions(slopes: &[Vec<Normal>], unknowns: &[Unknown]) -> Option<Vec<Row>> {
    let mut rows: BTreeMap<(usize, Powers), Row> = BTreeMap::new();
    for (u, Unknown { candidate, weight }) in unknowns.iter().enumerate() {
        for (field, slope) in slopes[*candidate].iter().enumerate() {
            for (powers, coefficient) in slope.terms() {
                let powers = product_of_powers(powers, weight)?;
                rows.entry((field, powers)).or_default().insert(u, coefficient);
            }
        }
    }
    let mut equations = Equations::new(unknowns.len());
    for row in rows.into_values() {
        equations.add(row)?;
    }
    equations.solutions()
}

/// A combination as a node.
fn node(
    graph: &mut Graph,
    coordinates: &[Id],
    candidates: &[Candidate],
    sums: &Sums,
    terms: &[(usize, &Powers, Ratio)],
) -> Id {
    let mut parts = vec![];
    for (candidate, weight, coefficient) in terms {
        let mut product = match candidates[*candidate] {
            Candidate::Linear(i) => coordinates[i],
            Candidate::Logarithm(i) => graph.call(Function::Ln, &[coordinates[i]]),
            Candidate::Square(i, j) => graph.mul(coordinates[i], coordinates[j]),
        };
        for (atom, exponent) in weight.iter() {
            let Some(symbol) = sums.as_symbol(*atom) else { continue };
            let power = graph.pow(symbol, *exponent);
            product = graph.mul(power, product);
        }
        parts.push(graph.scale(Number::Exact(*coefficient), product));
    }
    graph.sum(&parts)
}
