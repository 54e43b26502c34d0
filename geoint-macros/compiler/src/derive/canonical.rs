//! What is derived from H(q, p, t).

use super::domain::{Domain, Roots};
use super::exact::kick_drift::{kick_drift, modified_energy};
use super::exact::perturbed;
use super::exact::pieces::{self, Followed};
use super::facts::Fact;
use super::implicit;
use super::jet::{self, JetKernel};
use super::system::{Implicit, Missing, System};
use crate::analyze::{Split, Structure};
use crate::diff::{self, Gradient};
use crate::ir::{Graph, Id, Partial};
use crate::legendre::Legendre;
use crate::messages::{COUPLED, COUPLED_IN_PIECES, DAMPED, FORCED, NO_CANONICAL_PIECES};
use crate::parse::Form;
use crate::schedule::{Kernel, Levels};
use crate::split::{Division, Pieces};

/// Derives everything that some method needs.
pub(crate) fn canonical(
    graph: &mut Graph,
    structure: &Structure,
    (division, pieces): (&Division, Option<&Pieces>),
    partial: &[Partial],
    degrees: u32,
    legendre: Option<&Legendre>,
) -> (System, Gradient) {
    let gradient = diff::gradient(graph, structure.energy, degrees);
    let fields = implicit::field(graph, &gradient, structure, degrees);
    let some = |entry: &Id| !graph.is_zero(*entry);
    let drag = structure.damping.as_ref().and_then(|damping| damping.matrix.iter().flatten().copied().find(some));
    let forces = structure.forces.iter().flat_map(|forces| [&forces.applied, &forces.friction]);
    let force = forces.flatten().flatten().copied().find(some);
    let drag = drag.map(|term| (term, DAMPED)).or(force.map(|term| (term, FORCED)));
    let perturbed = match drag {
        Some((term, why)) => Err(Missing { marker: "UndampedParts", term, why, pair: None }),
        None => perturbed::kernels(graph, division, degrees),
    };
    let separable = match (drag, &structure.split) {
        (Some((term, why)), _) => Err(Missing { marker: "Undamped", term, why, pair: None }),
        (None, Split::Coupled(term)) => {
            let why = if matches!(pieces, Some(Ok(_))) { COUPLED_IN_PIECES } else { COUPLED };
            Err(Missing { marker: "Uncoupled", term: *term, why, pair: None })
        }
        (None, Split::Separable(parts)) => Ok(parts),
    };
    let splitting = separable.map(|parts| kick_drift(graph, parts, (&fields.field.f, &gradient), partial));
    let modified = separable.ok().map(|parts| modified_energy(graph, structure, parts, &gradient));
    let rates = fields.field.f.clone();
    let rate = (!structure.conservative()).then(|| Kernel::new(Levels::One, rates.clone()));
    // Damping that depends on the state makes a field of a higher degree.
    let steady = structure.forces.is_none() && structure.damping.as_ref().is_none_or(|damping| !damping.reads.state());
    let facts = [
        (structure.conservative(), Fact::Conservative),
        (structure.conserves_energy(), Fact::Autonomous),
        (structure.degree.is_some_and(|degree| degree <= 3) && steady, Fact::QuadraticField),
        (matches!(pieces, Some(Ok(found)) if found.nystrom), Fact::NystromPieces),
    ];
    let forms = jet::forms(graph, structure.energy, &gradient, legendre)
        .into_iter()
        .map(|gradient| diff::equations::hamilton(graph, &gradient, structure, |_, entry| entry).concat());
    let forms: Vec<Vec<Id>> = forms.collect();
    let jet = JetKernel::canonical(graph, &forms, (structure.energy, degrees));
    let system = System {
        facts: facts.into_iter().filter(|(holds, _)| *holds).map(|(_, fact)| fact).collect(),
        value: Some(Kernel::new(Levels::One, vec![structure.energy])),
        slopes: Some(Kernel::new(Levels::One, [&gradient.q[..], &gradient.p].concat())),
        rate,
        splitting: Some(splitting),
        perturbed: Some(perturbed),
        modified,
        pieces: pieces
            .map(|pieces| pieces::kernels(graph, Followed::Canonical, (pieces, NO_CANONICAL_PIECES)))
            .into_iter()
            .collect(),
        implicit: Implicit::Field(fields.kernels(graph, structure, degrees)),
        integrals: None,
        lagrangian: None,
        jet,
        domain: Domain::of(
            graph,
            Roots::of_energy(&structure.energy),
            Form::Hamiltonian,
            partial,
            (structure.damping.as_ref(), &rates),
        ),
    };
    (system, gradient)
}
