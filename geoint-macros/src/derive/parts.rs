//! The pieces of x' = S(x) ∇H: by the terms of H, and by planes.

use super::flow::Flow;
use super::implicit;
use super::system::{FlowKernel, Missing, PieceKernel, PiecesOf};
use crate::analyze;
use crate::ir::{Graph, Symbol};
use crate::messages::{DAMPED_FLOW, NO_STRUCTURE, NOT_PLANAR, NOT_POISSON};
use crate::schedule::{Kernel, Levels};
use crate::split::{self, Clock, Motion, NoPart, Part};

/// The pieces of every splitting. `structure` is S, and whether its bracket is known to be a Poisson bracket.
pub(crate) fn parts(
    graph: &mut Graph,
    flow: &Flow,
    structure: Option<(&[Vec<crate::ir::Id>], bool)>,
    damped: bool,
) -> Vec<PiecesOf<Kernel>> {
    let pieces =
        |splitting, pieces, symplectic, conserves_energy| PiecesOf { splitting, pieces, symplectic, conserves_energy };
    let Some((structure, poisson)) = structure else {
        let Some(first) = flow.kept.first() else { return vec![] };
        let term = first.conserved.value;
        let missing = Missing { marker: "InPlanes", term, why: NO_STRUCTURE, pair: None };
        return vec![pieces("PlanarSplitting", Err(missing), false, true)];
    };
    let Some((energy, _)) = flow.energy else { return vec![] };
    let autonomous = !analyze::reads(graph, energy).t;
    if damped {
        let missing = |marker| Missing { marker, term: energy, why: DAMPED_FLOW, pair: None };
        return vec![
            pieces("PoissonSplitting", Err(missing("InTerms")), poisson, false),
            pieces("PlanarSplitting", Err(missing("InPlanes")), false, autonomous),
        ];
    }
    let by_terms = split::parts(graph, energy, structure);
    let by_planes = split::planes(graph, energy, structure);
    let by_terms = kernels(graph, by_terms, ("InTerms", NOT_POISSON, "are not in involution"));
    let by_planes = kernels(graph, by_planes, ("InPlanes", NOT_PLANAR, "span the plane"));
    vec![pieces("PoissonSplitting", by_terms, poisson, false), pieces("PlanarSplitting", by_planes, false, autonomous)]
}

fn kernels(
    graph: &mut Graph,
    found: Result<Vec<Part>, NoPart>,
    (marker, why, word): (&'static str, &'static str, &'static str),
) -> Result<Vec<PieceKernel<Kernel>>, Missing> {
    let missing = |NoPart { formula, pair }| Missing {
        marker,
        term: formula,
        why,
        pair: pair.map(|pair: [Symbol; 2]| (pair, word)),
    };
    Ok(found.map_err(missing)?.into_iter().map(|part| kernel(graph, part)).collect())
}

fn kernel(graph: &mut Graph, part: Part) -> PieceKernel<Kernel> {
    let levels = match part.clock {
        Clock::Own => Levels::Unfrozen,
        Clock::Stage => Levels::Frozen,
    };
    let known = part.rules.iter().map(|rule| format!("{}: {}", rule.name, rule.fields)).collect();
    let (solved, flow) = match part.motion {
        Motion::Closed(ends) => (false, FlowKernel::with_increments(graph, levels, ends)),
        Motion::Solved(pair, field) => {
            let h = graph.symbol(Symbol::H);
            let equation = implicit::image(graph, &field, h);
            (true, FlowKernel { changes: pair.to_vec(), kernel: Kernel::new(levels, equation) })
        }
    };
    PieceKernel { energy: part.formula, solved, known, clock: part.clock, flow }
}
