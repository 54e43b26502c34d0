//! What is a centre? A term of a potential that is a power of a length.

use super::super::super::polynomial::{Polynomial, factors, is_free};
use crate::analyze;
use crate::ir::{Function, Graph, Id, Node, Ratio, Symbol};

/// A form in the positions: its coefficients, its constant, and its weight in |y|².
pub(super) struct Form {
    pub(super) coefficients: Vec<Id>,
    pub(super) constant: Id,
    pub(super) weight: Id,
}

/// A term g·|y|ⁿ of the potential.
pub(super) struct Centre {
    pub(super) strength: Id,
    pub(super) forms: Vec<Form>,
    pub(super) square: Id,
}

impl Form {
    /// A sum of positions with constant coefficients.
    fn of(graph: &mut Graph, id: Id, weight: Id, degrees: u32) -> Option<Form> {
        let powers = Polynomial::of(graph, id, &Symbol::is_coordinate)?;
        let position = |symbol: &Symbol| matches!(symbol, Symbol::Position(_));
        let linear = powers.has_only(|monomial| {
            monomial.is_empty() || monomial.keys().all(position) && monomial.values().eq([&Ratio::ONE])
        });
        let moves = powers.terms().any(|(monomial, _)| !monomial.is_empty());
        (linear && moves).then(|| Form {
            coefficients: (0..degrees).map(|i| powers.coefficient(graph, &[(Symbol::Position(i), 1)])).collect(),
            constant: powers.coefficient(graph, &[]),
            weight,
        })
    }

    pub(super) fn value(&self, graph: &mut Graph, q: &[Id]) -> Id {
        let along = graph.dot(&self.coefficients, q);
        graph.add(along, self.constant)
    }
}

/// g and y of g·|y|ⁿ, if a term is that.
pub(super) fn centre(graph: &mut Graph, term: Id, power: Ratio, degrees: u32) -> Option<Centre> {
    let (c, rest) = graph.coefficient(term);
    let (mut strength, mut found) = (graph.number(c), None);
    for (base, exponent) in factors(graph, rest) {
        if is_free(graph, base, &Symbol::is_coordinate) {
            let factor = graph.pow(base, exponent);
            strength = graph.mul(strength, factor);
        } else {
            found = Some(length(graph, base, exponent, power, degrees)?).filter(|_| found.is_none());
            found.as_ref()?;
        }
    }
    let (forms, square) = found?;
    Some(Centre { strength, forms, square })
}

/// y and |y|² of a base whose power is |y|ⁿ: a form, the length of two, or a sum of squares.
fn length(graph: &mut Graph, base: Id, exponent: Ratio, power: Ratio, degrees: u32) -> Option<(Vec<Form>, Id)> {
    let one = graph.integer(1);
    let two = Ratio::integer(2);
    if exponent == power {
        let components = match graph.node(base).clone() {
            Node::Call(Function::Hypot, args) => args,
            _ => vec![base],
        };
        let squares: Vec<Id> = components.iter().map(|y| graph.pow(*y, two)).collect();
        let square = graph.sum(&squares);
        let forms: Option<Vec<Form>> = components.into_iter().map(|y| Form::of(graph, y, one, degrees)).collect();
        return forms.map(|forms| (forms, square));
    }
    if exponent.mul(two)? != power {
        return None;
    }
    let mut forms = vec![];
    for term in analyze::single_terms(graph, base) {
        let (c, rest) = graph.coefficient(term);
        let (mut weight, mut form) = (graph.number(c), None);
        for (base, exponent) in graph.factors(rest) {
            if is_free(graph, base, &Symbol::is_coordinate) {
                let factor = graph.pow(base, exponent);
                weight = graph.mul(weight, factor);
            } else {
                form = Some(base).filter(|_| form.is_none() && exponent == two);
                form?;
            }
        }
        forms.push(Form::of(graph, form?, weight, degrees)?);
    }
    Some((forms, base))
}
