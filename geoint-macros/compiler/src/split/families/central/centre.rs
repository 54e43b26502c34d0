//! Centres: terms of a potential that are powers of a length.

use super::super::super::polynomial::{Polynomial, is_free};
use super::super::super::products::{ScaledPower, times_factors};
use crate::analyze;
use crate::ir::{Function, Graph, Id, Node, Ratio, Symbol};

/// A linear form in the positions, y = a·q + c, with its weight κ in |y|².
pub(super) struct Form {
    pub(super) coefficients: Vec<Id>,
    pub(super) constant: Id,
    pub(super) weight: Id,
}

/// A term g·|y|ⁿ of the potential.
pub(super) struct Centre {
    /// g.
    pub(super) strength: Id,
    pub(super) length: Length,
}

/// The length of a vector y of forms.
pub(super) struct Length {
    pub(super) forms: Vec<Form>,
    /// |y|² = Σ κₘ yₘ².
    pub(super) square: Id,
}

impl Form {
    /// Returns a sum of positions with constant coefficients as a form.
    fn of(graph: &mut Graph, id: Id, weight: Id, degrees: u32) -> Option<Form> {
        let powers = Polynomial::of(graph, id, &Symbol::is_coordinate).filter(Polynomial::is_affine)?;
        let is_position = |symbol: &Symbol| matches!(symbol, Symbol::Position(_));
        let reads_positions = powers.has_only(|monomial| monomial.keys().all(is_position));
        let moves = powers.terms().any(|(monomial, _)| !monomial.is_empty());
        (reads_positions && moves).then(|| Form {
            coefficients: (0..degrees).map(|i| powers.coefficient(graph, &[(Symbol::Position(i), 1)])).collect(),
            constant: powers.coefficient(graph, &[]),
            weight,
        })
    }

    /// Returns y.
    pub(super) fn value(&self, graph: &mut Graph, q: &[Id]) -> Id {
        let along = graph.dot(&self.coefficients, q);
        graph.add(along, self.constant)
    }
}

impl Centre {
    /// Returns a term as g·|y|ⁿ with n = `power`.
    pub(super) fn of(graph: &mut Graph, term: Id, power: Ratio, degrees: u32) -> Option<Centre> {
        let ScaledPower { coefficient, base, exponent } = ScaledPower::of(graph, term, &Symbol::is_coordinate)?;
        let length = if exponent == power {
            Length::of_components(graph, base, degrees)?
        } else if exponent.mul(Ratio::integer(2))? == power {
            Length::of_square(graph, base, degrees)?
        } else {
            return None;
        };
        Some(Centre { strength: coefficient, length })
    }
}

impl Length {
    /// Returns the length of a form, or the length that a call of `hypot` computes.
    fn of_components(graph: &mut Graph, id: Id, degrees: u32) -> Option<Length> {
        let one = graph.integer(1);
        let components = match graph.node(id).clone() {
            Node::Call(Function::Hypot, args) => args,
            _ => vec![id],
        };
        let squares: Vec<Id> = components.iter().map(|y| graph.pow(*y, Ratio::integer(2))).collect();
        let square = graph.sum(&squares);
        let forms: Option<Vec<Form>> = components.into_iter().map(|y| Form::of(graph, y, one, degrees)).collect();
        Some(Length { forms: forms?, square })
    }

    /// Returns the length whose square is a sum of weighted squares of forms.
    fn of_square(graph: &mut Graph, square: Id, degrees: u32) -> Option<Length> {
        let mut forms = vec![];
        for term in analyze::single_terms(graph, square) {
            let (c, rest) = graph.coefficient(term);
            let (free, reading): (Vec<_>, Vec<_>) =
                graph.factors(rest).into_iter().partition(|(base, _)| is_free(graph, *base, &Symbol::is_coordinate));
            let [(form, exponent)] = reading[..] else { return None };
            if exponent != Ratio::integer(2) {
                return None;
            }
            let c = graph.number(c);
            let weight = times_factors(graph, c, free);
            forms.push(Form::of(graph, form, weight, degrees)?);
        }
        Some(Length { forms, square })
    }
}
