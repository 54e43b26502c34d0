//! Which family is most like an energy whose flow no rule knows: for messages.

use super::families::FAMILIES;
use super::flow::{Family, Space};
use super::polynomial::{Monomial, Polynomial, degree as sum_of_powers, is_momentum};
use crate::ir::{Function, Graph, Id, Node, Ratio, Reads, Symbol};

/// What families are told apart by.
struct Shape {
    reads: Reads,
    /// How many terms there are in powers of all coordinates, and the largest sum of powers of one.
    powers: Option<(usize, Ratio)>,
    /// The largest power of momenta in a term, if H is a polynomial in them.
    of_momenta: Option<Ratio>,
    /// How many momenta are read.
    momenta: usize,
    /// Whether the whole is a function, or a power, of something.
    of_one: bool,
    /// The largest denominator of the powers of positions by which it is divided, 2 of lengths.
    divided_by: Option<i128>,
}

impl Shape {
    fn is_kinetic(&self) -> bool {
        self.reads.q && self.of_momenta == Some(Ratio::integer(2))
    }
}

/// Whether energies of a shape are near to those of a family.
type IsNear = fn(&Shape) -> bool;

/// Names of families, each with the energies that it is nearest to unless one before it is.
const NEAREST: &[(&str, IsNear)] = &[
    ("damped drift", |shape| shape.reads.s && !shape.reads.q),
    ("kick", |shape| !shape.reads.p),
    ("drift", |shape| !shape.reads.q),
    ("prolongation", |shape| shape.of_momenta == Some(Ratio::ONE)),
    ("weighted drift", |shape| shape.reads.s && shape.of_momenta == Some(Ratio::integer(2))),
    ("Kepler motion", |shape| shape.is_kinetic() && shape.momenta > 1 && shape.divided_by == Some(2)),
    ("inverse square", |shape| shape.is_kinetic() && shape.divided_by.is_some()),
    ("coupled oscillators", |shape| shape.powers.is_some_and(|(_, degree)| degree <= Ratio::integer(2))),
    ("monomial", |shape| shape.powers.is_some_and(|(terms, _)| terms == 1)),
    ("geodesic", |shape| shape.momenta == 1 && shape.of_momenta == Some(Ratio::integer(2))),
    ("function of a piece", |shape| shape.of_one),
    ("forms in involution", |_| true),
];

/// The family whose energies are most like this one.
pub(crate) fn nearest(graph: &mut Graph, energy: Id, space: Space) -> Option<&'static Family> {
    let shape = shape(graph, energy);
    let families = NEAREST.iter().filter(|(_, is_near)| is_near(&shape)).filter_map(|(name, _)| of_name(name));
    families.into_iter().find(|family| family.action || !space.action)
}

fn of_name(name: &str) -> Option<&'static Family> {
    FAMILIES.iter().find(|family| family.name == name)
}

fn shape(graph: &mut Graph, energy: Id) -> Shape {
    let degree = |monomial: &Monomial, counts: &dyn Fn(Symbol) -> bool| {
        sum_of_powers(monomial.iter().filter(|(symbol, _)| counts(**symbol)).map(|(_, power)| *power))
    };
    let largest = |powers: &Polynomial, counts: &dyn Fn(Symbol) -> bool| {
        powers.terms().filter_map(|(monomial, _)| degree(monomial, counts)).max()
    };
    let all = Polynomial::of(graph, energy, &Symbol::is_coordinate);
    let of_momenta = Polynomial::of(graph, energy, &is_momentum);
    Shape {
        reads: graph.reads(energy),
        powers: all.and_then(|powers| Some((powers.terms().count(), largest(&powers, &Symbol::is_coordinate)?))),
        of_momenta: of_momenta.and_then(|powers| largest(&powers, &is_momentum)),
        momenta: graph.symbols(energy).iter().filter(|symbol| is_momentum(**symbol)).count(),
        divided_by: divided_by(graph, energy),
        of_one: matches!(graph.node(graph.coefficient(energy).1), Node::Call(..) | Node::Power(..)),
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
