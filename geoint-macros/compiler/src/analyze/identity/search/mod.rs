//! Functions that are constant along given fields, by linear algebra. They are combinations of coordinates, products of two coordinates and
//! logarithms of coordinates. The coefficients are numbers and products of parameters.
//!
//! Functions that are constant along one field are its first integrals. Functions that are constant along the rows of a skew matrix are its
//! Casimirs. The equations state that the multiplied-out derivatives vanish, with roots, functions and reciprocals of sums as unknowns. Every
//! listed function is proven to be constant, but the list may be incomplete.

mod multiplier;
mod span;
mod structure;

use super::multiplied::{Atom, Monomial, Normal, Sums, product_of_monomials};
use crate::analyze::equations::{Equations, Row, add_multiple};
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};
pub(crate) use multiplier::multiplier;
use span::Span;
use std::collections::{BTreeMap, BTreeSet};
pub(crate) use structure::{Structure, structure};

/// A function that is constant along all fields.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Kept {
    pub(crate) value: Id,
    /// Every Runge–Kutta method keeps a linear function.
    pub(crate) linear: bool,
}

/// A function of coordinates, given by their indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Candidate {
    Linear(usize),
    Logarithm(usize),
    /// The product of two coordinates.
    Square(usize, usize),
}

/// The largest number of products of two terms that are formed to multiply out the fields.
const PRODUCTS: usize = 5_000;

/// The largest number of coefficients that are sought at once.
const UNKNOWNS: usize = 600;

/// Returns independent combinations that are constant along each of `fields`. Linear ones come first, and their products are left out. `None` if
/// the fields are too long, or have conditions.
pub(crate) fn kept_along(graph: &mut Graph, x: &[Symbol], fields: &[Vec<Id>]) -> Option<Vec<Kept>> {
    let coordinates: Vec<Id> = x.iter().map(|symbol| graph.symbol(*symbol)).collect();
    let mut sums = Sums::of(graph, &fields.concat(), PRODUCTS)?;
    let atoms: Vec<Atom> = coordinates.iter().map(|id| sums.atom_of_symbol(*id)).collect();
    let normals = |field: &Vec<Id>| field.iter().map(|id| sums.normal(*id)).collect();
    let fields: Vec<Vec<&Normal>> = fields.iter().map(normals).collect();
    // The logarithm of a constant coordinate depends on the coordinate, so it is left out.
    let candidates = candidates(x.len(), |i| fields.iter().any(|field| !field[i].is_empty()));
    let slopes = |candidate: &Candidate| fields.iter().map(|field| slope(*candidate, field, &atoms)).collect();
    let slopes: Vec<Vec<Normal>> = candidates.iter().map(slopes).collect::<Option<_>>()?;
    let parameters = parameters(graph, &sums, &fields, x);
    let mut span = Span::new();
    let mut found = vec![];
    for degree in 0..=2 {
        // Linear functions come first, because their products are left out.
        for linear in [true, false] {
            let unknowns = unknowns(&candidates, &parameters, degree, linear);
            if unknowns.len() > UNKNOWNS {
                continue;
            }
            for solution in solutions(&slopes, &unknowns)? {
                let combination: Vec<(&Unknown, Ratio)> = solution.iter().map(|(u, c)| (&unknowns[*u], *c)).collect();
                if span.add(&combination, &candidates) {
                    let value = node(graph, &coordinates, &candidates, &sums, &combination);
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

/// The derivative of a candidate along a field.
fn slope(candidate: Candidate, field: &[&Normal], x: &[Atom]) -> Option<Normal> {
    let times_power = |f: &Normal, atom, exponent| f.times(&vec![(atom, Ratio::integer(exponent))]);
    match candidate {
        Candidate::Linear(i) => Some(field[i].clone()),
        Candidate::Logarithm(i) => times_power(field[i], x[i], -1),
        Candidate::Square(i, j) => times_power(field[i], x[j], 1)?.add(Ratio::ONE, &times_power(field[j], x[i], 1)?),
    }
}

/// Pairs (p, 1) for parameters p that occur in numerators of the fields, and (p, −1) for those in denominators.
fn parameters(graph: &Graph, sums: &Sums, fields: &[Vec<&Normal>], x: &[Symbol]) -> BTreeSet<(Atom, Ratio)> {
    let is_parameter = |atom: Atom| match sums.as_symbol(atom).map(|id| graph.node(id)) {
        Some(Node::Symbol(symbol)) => *symbol != Symbol::Time && !x.contains(symbol),
        _ => false,
    };
    let sign = |exponent: Ratio| Ratio::integer(if exponent < Ratio::ZERO { -1 } else { 1 });
    let monomials = fields.iter().flatten().flat_map(|sum| sum.terms().map(|(monomial, _)| monomial));
    let parameters = monomials.flatten().filter(|(atom, _)| is_parameter(*atom));
    parameters.map(|(atom, exponent)| (*atom, sign(*exponent))).collect()
}

/// The unknown coefficient of weight·candidate, where the weight is a product of parameters.
struct Unknown {
    candidate: usize,
    weight: Monomial,
}

/// The unknowns with products of at most `degree` parameters.
fn unknowns(
    candidates: &[Candidate],
    parameters: &BTreeSet<(Atom, Ratio)>,
    degree: usize,
    only_linear: bool,
) -> Vec<Unknown> {
    let mut weights: Vec<Monomial> = vec![vec![]];
    for _ in 0..degree {
        let products = weights.iter().flat_map(|weight| {
            parameters.iter().filter_map(|parameter| product_of_monomials(weight, &vec![*parameter]))
        });
        let new: BTreeSet<Monomial> = products.filter(|product| !weights.contains(product)).collect();
        weights.extend(new);
    }
    let is_chosen = |k: &usize| !only_linear || matches!(candidates[*k], Candidate::Linear(_));
    let weights = &weights;
    let of = |candidate| weights.iter().map(move |weight| Unknown { candidate, weight: weight.clone() });
    (0..candidates.len()).filter(is_chosen).flat_map(of).collect()
}

/// A basis of the coefficients for which the derivatives along all fields vanish. `slopes` has those of each candidate.
fn solutions(slopes: &[Vec<Normal>], unknowns: &[Unknown]) -> Option<Vec<Row>> {
    let mut equations = Vanishing::default();
    for (u, Unknown { candidate, weight }) in unknowns.iter().enumerate() {
        for (field, slope) in slopes[*candidate].iter().enumerate() {
            equations.add(field, u, &slope.times(weight)?)?;
        }
    }
    equations.solutions(unknowns.len())
}

/// The condition that sums Σ unknown·normal vanish. Every monomial of a sum gives a linear equation.
#[derive(Default)]
struct Vanishing(BTreeMap<(usize, Monomial), Row>);

impl Vanishing {
    /// Adds unknown·normal to one of the sums. `None` if a number becomes too long.
    fn add(&mut self, sum: usize, unknown: usize, normal: &Normal) -> Option<()> {
        for (monomial, coefficient) in normal.terms() {
            let equation = self.0.entry((sum, monomial.clone())).or_default();
            add_multiple(equation, Ratio::ONE, [(unknown, coefficient)])?;
        }
        Some(())
    }

    /// A basis of the solutions. `None` if a number becomes too long.
    fn solutions(self, unknowns: usize) -> Option<Vec<Row>> {
        let mut equations = Equations::new(unknowns);
        for equation in self.0.into_values() {
            equations.add(equation)?;
        }
        equations.solutions()
    }
}

/// A combination as a node.
fn node(
    graph: &mut Graph,
    coordinates: &[Id],
    candidates: &[Candidate],
    sums: &Sums,
    combination: &[(&Unknown, Ratio)],
) -> Id {
    let mut parts = vec![];
    for (unknown, coefficient) in combination {
        let mut product = match candidates[unknown.candidate] {
            Candidate::Linear(i) => coordinates[i],
            Candidate::Logarithm(i) => graph.call(Function::Ln, &[coordinates[i]]),
            Candidate::Square(i, j) => graph.mul(coordinates[i], coordinates[j]),
        };
        for (atom, exponent) in &unknown.weight {
            let Some(symbol) = sums.as_symbol(*atom) else { continue };
            let power = graph.pow(symbol, *exponent);
            product = graph.mul(power, product);
        }
        parts.push(graph.scale(Number::Exact(*coefficient), product));
    }
    graph.sum(&parts)
}
