//! The pieces of x' = S(x) ∇H: by the terms of H, and by planes.

use crate::analyze::{self, claims, search};
use crate::derive::flow::Flow;
use crate::derive::implicit;
use crate::derive::proof::coordinates;
use crate::derive::system::{FlowKernel, Missing, PieceKernel, PiecesOf};
use crate::ir::{Graph, Id, Symbol};
use crate::messages::{DAMPED_FLOW, NO_STRUCTURE, NOT_PLANAR, NOT_POISSON};
use crate::schedule::{Kernel, Levels};
use crate::split::{self, Clock, Motion, NoPart, Part};

/// S of x' = S(x) ∇I.
#[derive(Clone, Debug)]
pub(crate) struct Parted {
    /// I.
    pub(crate) integral: Id,
    pub(crate) matrix: Vec<Vec<Id>>,
    /// Whether it is known to make a Poisson bracket.
    pub(crate) poisson: bool,
    /// Of an S that was searched for, whether it is the only one of its kind.
    pub(crate) unique: Option<bool>,
}

impl Parted {
    /// Of an S that is known.
    pub(crate) fn of_structure(integral: Id, matrix: &[Vec<Id>], poisson: bool) -> Parted {
        Parted { integral, matrix: matrix.to_vec(), poisson, unique: None }
    }

    /// Of the first function that a field keeps: the field is J ∇I, or S is searched for.
    pub(crate) fn of_field(graph: &mut Graph, flow: &Flow) -> Option<Parted> {
        let x = coordinates(flow.field.len());
        let kept = flow.kept.iter().map(|named| &named.conserved).find(|conserved| conserved.but.is_none());
        let integral = kept.map(|conserved| conserved.value).or(flow.energy.as_ref().map(|(energy, _)| *energy))?;
        if let Some((_, matrix)) = &flow.energy
            && claims::is_gradient_form(graph, &x, matrix, integral, &flow.field).is_ok()
        {
            return Some(Parted { integral, matrix: matrix.clone(), poisson: true, unique: None });
        }
        let search::Structure { matrix, unique } = search::structure(graph, &x, &flow.field, integral)?;
        let poisson = claims::is_poisson(graph, &x, &matrix).is_ok();
        Some(Parted { integral, matrix, poisson, unique: Some(unique) })
    }
}

/// The pieces of every splitting of a flow.
pub(crate) fn parts(graph: &mut Graph, flow: &Flow, parted: Option<&Parted>, damped: bool) -> Vec<PiecesOf<Kernel>> {
    let both = |poisson, autonomous, [by_terms, by_planes]: [Result<_, Missing>; 2]| {
        let pieces = |splitting, pieces, symplectic, conserves_energy| PiecesOf {
            cost: 0,
            rejected: vec![],
            splitting,
            pieces,
            symplectic,
            conserves_energy,
        };
        vec![
            pieces("PoissonSplitting", by_terms, poisson, false),
            pieces("PlanarSplitting", by_planes, false, autonomous),
        ]
    };
    let missing = |term, why| [TERMS, PLANES].map(|marker| Err(Missing { marker, term, why, pair: None }));
    let Some(Parted { integral, matrix, poisson, .. }) = parted else {
        // Without anything that is kept there is nothing to split by.
        let first = flow.kept.first();
        return first.map_or_else(Vec::new, |first| both(false, true, missing(first.conserved.value, NO_STRUCTURE)));
    };
    let autonomous = !analyze::reads(graph, *integral).t;
    if damped {
        return both(*poisson, autonomous, missing(*integral, DAMPED_FLOW));
    }
    let by_terms = split::parts(graph, *integral, matrix);
    let by_planes = split::planes(graph, *integral, matrix);
    let by_terms = kernels(graph, by_terms, (TERMS, NOT_POISSON, "are not in involution"));
    let by_planes = kernels(graph, by_planes, (PLANES, NOT_PLANAR, "span the plane"));
    both(*poisson, autonomous, [by_terms, by_planes])
}

/// What nothing implements where pieces are missing.
const TERMS: &str = "InTerms";
const PLANES: &str = "InPlanes";

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
