//! Routines of H(q, p, t).

use super::domain::{Domain, Formulas};
use super::exact::kick_drift::{kick_drift, modified_energy};
use super::exact::perturbed;
use super::exact::pieces::{self, Followed};
use super::facts::Fact;
use super::implicit;
use super::jet::{self, JetKernel};
use super::system::{Kernels, Missing, System};
use crate::analyze::{Split, Structure};
use crate::compilation::Compilation;
use crate::diff::{Gradient, equations};
use crate::ir::{Id, UndefinedAt};
use crate::legendre::Legendre;
use crate::messages::{COUPLED, COUPLED_IN_PIECES, DAMPED, FORCED, NO_CANONICAL_PIECES};
use crate::schedule::{Routine, phase};
use crate::split::{Division, Pieces};

/// Decompositions of H into parts with exact flows.
pub(crate) struct Decompositions<'a> {
    /// A part with an exact flow, and the rest.
    pub(crate) division: &'a Division,
    /// Flows in closed form beside kick and drift.
    pub(crate) pieces: Option<&'a Pieces>,
}

/// Derives the routines of every method.
pub(crate) fn canonical(
    compilation: &mut Compilation<'_>,
    structure: &Structure,
    gradient: &Gradient,
    Decompositions { division, pieces }: Decompositions<'_>,
    partial: &[UndefinedAt],
    legendre: Option<&Legendre>,
) -> System {
    let (degrees, positions, graph) = (compilation.degrees(), compilation.positions(), &mut compilation.graph);
    let fields = implicit::fields(graph, gradient, structure, degrees);
    let some = |entry: &Id| !graph.is_zero(*entry);
    let drag = structure.damping.as_ref().and_then(|damping| damping.matrix.iter().flatten().copied().find(some));
    let forces = structure.forces.iter().flat_map(|forces| [&forces.applied, &forces.friction]);
    let force = forces.flatten().flatten().copied().find(some);
    let drag = drag.map(|term| (term, DAMPED)).or(force.map(|term| (term, FORCED)));
    let perturbed = match drag {
        Some((term, why)) => Err(Missing::new("UndampedParts", term, why)),
        None => perturbed::kernels(graph, division, degrees),
    };
    let separable = match (drag, &structure.split) {
        (Some((term, why)), _) => Err(Missing::new("Undamped", term, why)),
        (None, Split::Coupled(term)) => {
            let why = if matches!(pieces, Some(Ok(_))) { COUPLED_IN_PIECES } else { COUPLED };
            Err(Missing::new("Uncoupled", *term, why))
        }
        (None, Split::Separable(parts)) => Ok(parts),
    };
    let splitting = separable.map(|parts| kick_drift(graph, parts, &fields.field.f, gradient, partial));
    let modified = separable.ok().map(|parts| modified_energy(graph, structure, parts, gradient));
    let rates = fields.field.f.clone();
    let slopes = |name, nodes| Routine::array(name, "slopes", &phase(&positions), nodes);
    let rate = (!structure.conservative()).then(|| slopes("rate", rates.clone()));
    // Damping that depends on the state increases the degree of the field.
    let steady = structure.forces.is_none() && structure.damping.as_ref().is_none_or(|damping| !damping.reads.state());
    let facts = [
        (structure.conservative(), Fact::Conservative),
        (structure.conserves_energy(), Fact::Autonomous),
        (structure.degree.is_some_and(|degree| degree <= 3) && steady, Fact::QuadraticField),
        (matches!(pieces, Some(Ok(found)) if found.nystrom), Fact::NystromPieces),
    ];
    let forms: Vec<Vec<Id>> = jet::forms(graph, structure.energy, gradient, legendre)
        .into_iter()
        .map(|gradient| equations::hamilton(graph, &gradient, structure, |_, entry| entry).concat())
        .collect();
    let jet = JetKernel::canonical(graph, &forms, structure.energy, degrees);
    let pieces = pieces.map(|pieces| pieces::kernels(graph, Followed::Canonical, pieces, NO_CANONICAL_PIECES));
    let kernels = Kernels::Field(Box::new(fields.kernels(graph, structure, &positions)));
    let formulas = &[structure.energy];
    let formulas = Formulas { damping: structure.damping.as_ref(), rates: &rates, ..Formulas::new(formulas, partial) };
    System {
        facts: facts.into_iter().filter(|(holds, _)| *holds).map(|(_, fact)| fact).collect(),
        value: Some(Routine::number("hamiltonian", structure.energy)),
        gradient: Some(slopes("gradient", [&gradient.q[..], &gradient.p].concat())),
        rate,
        splitting: Some(splitting),
        perturbed: Some(perturbed),
        modified,
        pieces: pieces.into_iter().collect(),
        jet,
        ..System::new(kernels, Domain::of(graph, compilation.form, formulas))
    }
}
