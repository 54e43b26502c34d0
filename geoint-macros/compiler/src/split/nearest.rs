//! The family that resembles an energy without a known flow. Messages suggest it.

use super::families::FAMILIES;
use super::flow::{Family, Space};
use super::polynomial::{Polynomial, degree, is_momentum};
use crate::ir::{Function, Graph, Id, Node, Ratio, Reads, Symbol};

/// The features of an energy by which families are compared.
struct Shape {
    reads: Reads,
    /// The number of terms of a polynomial in all coordinates.
    terms: Option<usize>,
    /// The degree of a polynomial in all coordinates.
    degree: Option<Ratio>,
    /// The degree of a polynomial in the momenta.
    degree_in_momenta: Option<Ratio>,
    /// The number of momenta that the energy reads.
    momenta: usize,
    /// Whether the energy is a function or a power of an expression.
    is_function: bool,
    /// The largest denominator of the exponents with which the energy divides by positions. Lengths count as 2.
    divided_by: Option<i128>,
}

impl Shape {
    fn is_kinetic(&self) -> bool {
        self.reads.q && self.degree_in_momenta == Some(Ratio::integer(2))
    }
}

/// Returns whether an energy with these features resembles a family.
type IsNear = fn(&Shape) -> bool;

/// Names of families with their conditions. The first family whose condition holds is the nearest.
const NEAREST: &[(&str, IsNear)] = &[
    ("damped drift", |shape| shape.reads.s && !shape.reads.q),
    ("kick", |shape| !shape.reads.p),
    ("drift", |shape| !shape.reads.q),
    ("prolongation", |shape| shape.degree_in_momenta == Some(Ratio::ONE)),
    ("weighted drift", |shape| shape.reads.s && shape.degree_in_momenta == Some(Ratio::integer(2))),
    ("Kepler motion", |shape| shape.is_kinetic() && shape.momenta > 1 && shape.divided_by == Some(2)),
    ("inverse square", |shape| shape.is_kinetic() && shape.divided_by.is_some()),
    ("coupled oscillators", |shape| shape.degree.is_some_and(|degree| degree <= Ratio::integer(2))),
    ("monomial", |shape| shape.degree.is_some() && shape.terms == Some(1)),
    ("geodesic", |shape| shape.momenta == 1 && shape.degree_in_momenta == Some(Ratio::integer(2))),
    ("function of a piece", |shape| shape.is_function),
    ("forms in involution", |_| true),
];

/// Returns the family that resembles an energy most.
pub(crate) fn nearest(graph: &mut Graph, energy: Id, space: Space) -> Option<&'static Family> {
    let shape = shape(graph, energy);
    let families = NEAREST.iter().filter(|(_, is_near)| is_near(&shape)).filter_map(|(name, _)| of_name(name));
    families.into_iter().find(|family| family.action || !space.action)
}

fn of_name(name: &str) -> Option<&'static Family> {
    FAMILIES.iter().find(|family| family.name == name)
}

fn shape(graph: &mut Graph, energy: Id) -> Shape {
    let largest = |powers: &Polynomial| powers.terms().filter_map(|(monomial, _)| degree(monomial)).max();
    let all = Polynomial::of(graph, energy, &Symbol::is_coordinate);
    let in_momenta = Polynomial::of(graph, energy, &is_momentum);
    Shape {
        reads: graph.reads(energy),
        terms: all.as_ref().map(|powers| powers.terms().count()),
        degree: all.as_ref().and_then(largest),
        degree_in_momenta: in_momenta.as_ref().and_then(largest),
        momenta: graph.symbols(energy).iter().filter(|symbol| is_momentum(**symbol)).count(),
        divided_by: divided_by(graph, energy),
        is_function: matches!(graph.node(graph.coefficient(energy).1), Node::Call(..) | Node::Power(..)),
    }
}

fn divided_by(graph: &Graph, energy: Id) -> Option<i128> {
    let mut largest = None;
    for id in graph.reachable(&[energy]) {
        let Node::Power(base, exponent) = graph.node(id) else { continue };
        if exponent.numerator < 0 && graph.reads(*base).q {
            let is_length = matches!(graph.node(*base), Node::Call(Function::Hypot | Function::Abs, _));
            largest = largest.max(Some(if is_length { 2 } else { exponent.denominator }));
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_families() {
        for (name, _) in NEAREST {
            assert!(of_name(name).is_some(), "{name}");
        }
    }
}
