//! What the user asked for against what was proven.

use crate::analyze::{Damping, Flaw, Split, Structure};
use crate::diagnostics::{Diagnostics, Result};
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::lower::Place;
use crate::parse::{Energy, Requirement};
use crate::split::Pieces;
use std::collections::HashMap;

/// Reports damping that is none, and every requirement that does not hold, at the term that breaks it.
pub(crate) fn requests(
    energy: &Energy,
    structure: &Structure,
    graph: &Graph,
    places: &HashMap<Id, Place>,
    name: impl Fn(Symbol) -> String,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    let printer = Printer::new(graph, name);
    if let Some(Damping { matrix, flaw: Some(flaw), .. }) = &structure.damping {
        let entry = |i: usize, j: usize| printer.excerpt(matrix[i][j]);
        let message = match *flaw {
            Flaw::NotSymmetric(i, j) => format!(
                "damping is a symmetric matrix, but row {i}, column {j} is {} and row {j}, column {i} is {}: write both alike",
                entry(i, j),
                entry(j, i)
            ),
            Flaw::Negative(i) => format!(
                "damping takes energy away, but the coefficient of coordinate {i} is {}: write one that is not negative",
                entry(i, i)
            ),
            Flaw::Indefinite => INDEFINITE.into(),
        };
        errors.at(&energy.damping, message);
    }
    for (requirement, span) in &energy.requirements {
        if structure.damping.is_some() {
            errors.at_place((*span, *span), DAMPED);
            continue;
        }
        let witness = match (requirement, &structure.split) {
            (_, Split::Coupled(term)) => Some((*term, COUPLED)),
            (Requirement::Separable, Split::Separable(_)) => None,
            (Requirement::QuadraticKinetic, Split::Separable(parts)) => {
                parts.not_quadratic.map(|term| (term, NOT_QUADRATIC))
            }
        };
        if let Some((term, why)) = witness {
            // A term may have been put together from several that were written.
            let place = places.get(&term).copied().unwrap_or((*span, *span));
            errors.at_place(place, format!("{why}: {}", printer.excerpt(term)));
        }
    }
    errors.or(())
}

/// Reports a piece that was asked for and has no flow, and pieces that do not add up to H.
pub(crate) fn pieces(
    energy: &Energy,
    root: Id,
    pieces: &Pieces,
    graph: &Graph,
    places: &HashMap<Id, Place>,
    name: impl Fn(Symbol) -> String,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    let printer = Printer::new(graph, name);
    let _ = (energy, root, pieces, places, &printer, &mut errors);
    errors.or(())
}

pub(crate) const NO_PIECES: &str = "no flow in closed form is known for this term, so the energy cannot be split; use \
                                    `ContactMidpoint` or `ContactDiscreteGradient`";

pub(crate) const COUPLED: &str = "this term couples positions and momenta, so kick and drift do not exist; \
                                  use `ImplicitMidpoint`, `Gauss` or `DiscreteGradient`";

const INDEFINITE: &str = "damping takes energy away, but this matrix gives some at some velocity: write one that is positive \
                          semidefinite";

pub(crate) const DAMPED: &str =
    "damping is no part of a kick or a drift; use `ImplicitMidpoint`, `Gauss` or `DiscreteGradient`";

pub(crate) const NOT_QUADRATIC: &str = "this term is not quadratic in the momenta with constant coefficients, so \
                                        Runge–Kutta–Nyström tables would lose their order; use a table for every \
                                        separable energy, such as `BlanesMoan6`";
