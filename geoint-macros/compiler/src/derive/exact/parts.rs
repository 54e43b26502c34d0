//! Kernels of the pieces of x' = S(x) ∇H, for four splittings:
//!
//! - by terms of H, whose flows are known,
//! - by planes, in each of which two coordinates move and the flow is known,
//! - by planes in which an implicit equation is solved, with discrete gradients or with increments (Itoh–Abe).
//!
//! `split` finds the pieces. This file turns them into kernels, or states why there are none.

use crate::analyze::{Damping, claims, search};
use crate::derive::implicit::{self, Scaled};
use crate::derive::proof::flow::{Flow, coordinates};
use crate::derive::system::{FlowKernel, Missing, Pair, PieceKernel, PiecesOf};
use crate::ir::{Graph, Id, Symbol};
use crate::messages::{
    AT_REST, CHANGED, DAMPED_FLOW, FRICTION_FLOW, NO_STRUCTURE, NOT_PLANAR, NOT_POISSON, NOT_SOLVED,
};
use crate::schedule::{Kernel, Levels, Output, Routine, Space};
use crate::split::{self, Clock, Motion, NoPart, Part};

/// The antisymmetric matrix S and the integral I of x' = S(x) ∇I.
#[derive(Clone, Debug)]
pub(crate) struct Parted {
    /// I.
    pub(crate) integral: Id,
    pub(crate) matrix: Vec<Vec<Id>>,
    /// True if S is proven to satisfy the Jacobi identity, so that {f, g} = ∇f·S∇g is a Poisson bracket.
    pub(crate) poisson: bool,
    /// Present if S was found by a search. True if no other S of this form exists.
    pub(crate) unique: Option<bool>,
}

impl Parted {
    /// Uses the matrix that the user has written.
    pub(crate) fn of_structure(integral: Id, matrix: &[Vec<Id>], poisson: bool) -> Parted {
        Parted { integral, matrix: matrix.to_vec(), poisson, unique: None }
    }

    /// Finds a matrix for the first integral of a field, named or found.
    ///
    /// Some fields have an energy with a constant matrix (`flow.energy`), which is a Poisson matrix. If it does not belong to the named integral, S is
    /// searched for.
    pub(crate) fn of_field(graph: &mut Graph, flow: &Flow) -> Option<Parted> {
        let x = coordinates(flow.field.len());
        let kept = flow.first().map(|named| named.conserved.value);
        let integral = kept.or(flow.energy.as_ref().map(|(energy, _)| *energy))?;
        if let Some((_, matrix)) = &flow.energy
            && claims::is_gradient_form(graph, &x, matrix, integral, &flow.field).is_ok()
        {
            return Some(Parted { integral, matrix: matrix.clone(), poisson: true, unique: None });
        }
        // An integral in other units, I/c, is kept, too. The search may succeed for one of both only.
        let (_, unit) = claims::in_units(graph, integral);
        let (integral, search::Structure { matrix, unique }) = [integral, unit].into_iter().find_map(|integral| {
            let found = search::structure(graph, &x, &flow.field, integral)?;
            Some((integral, found))
        })?;
        let poisson = claims::is_poisson(graph, &x, &matrix, &flow.field).is_ok();
        Some(Parted { integral, matrix, poisson, unique: Some(unique) })
    }
}

/// A splitting of x' = S(x) ∇I.
struct Splitting {
    name: &'static str,
    /// The trait that stays unimplemented if there are no pieces, so that rustc prints the message.
    marker: &'static str,
    /// The message if there are no pieces.
    why: &'static str,
    /// The verb of the message if two coordinates are the reason.
    pair: &'static str,
}

const BY_TERMS: Splitting =
    Splitting { name: "PoissonSplitting", marker: "InTerms", why: NOT_POISSON, pair: "are not in involution" };
const BY_PLANES: Splitting =
    Splitting { name: "PlanarSplitting", marker: "InPlanes", why: NOT_PLANAR, pair: "span the plane" };
const BY_GRADIENTS: Splitting =
    Splitting { name: "PlanarDiscreteGradient", marker: "InGradients", why: NOT_SOLVED, pair: "span the plane" };
const BY_INCREMENTS: Splitting =
    Splitting { name: "PlanarItohAbe", marker: "InIncrements", why: NOT_SOLVED, pair: "span the plane" };

/// Derives the pieces of every splitting of a flow.
pub(crate) fn parts(
    graph: &mut Graph,
    flow: &Flow,
    parted: Option<&Parted>,
    damping: Option<&Damping>,
) -> Vec<PiecesOf> {
    let Some(Parted { integral, matrix, poisson, .. }) = parted else {
        // Without S there is nothing to split. The message depends on whether an integral is kept, is changed by the field, or is not named at all.
        return match (flow.first(), flow.kept.first()) {
            (Some(first), _) => none(first.conserved.value, NO_STRUCTURE),
            (None, Some(changed)) => none(changed.conserved.value, CHANGED),
            (None, None) => vec![],
        };
    };
    if damping.is_some() {
        return none(*integral, if flow.entropy.is_some() { FRICTION_FLOW } else { DAMPED_FLOW });
    }
    let autonomous = !graph.reads(*integral).t;
    let by_terms = split::parts(graph, *integral, matrix);
    let by_planes = split::planes(graph, *integral, matrix);
    let [gradients, increments] = split::solved_planes(graph, *integral, matrix);
    let found = [(BY_TERMS, by_terms), (BY_PLANES, by_planes), (BY_GRADIENTS, gradients), (BY_INCREMENTS, increments)];
    let pieces = |(splitting, found): (Splitting, Result<Vec<Part>, NoPart>)| {
        let Splitting { name, marker, why, pair } = splitting;
        let missing = |NoPart { formula, pair: found }| Missing {
            marker,
            term: formula,
            why,
            pair: found.map(|coordinates: [Symbol; 2]| Pair { coordinates, verb: pair }),
        };
        let kernels = match found {
            Ok(parts) if parts.is_empty() => Err(Missing::new(marker, *integral, AT_REST)),
            Ok(parts) => Ok(parts.into_iter().map(|part| kernel(graph, part)).collect()),
            Err(none) => Err(missing(none)),
        };
        // Each piece by terms is a Hamiltonian flow. Each piece by planes keeps the integral, unless it reads time.
        let by_terms = name == BY_TERMS.name;
        PiecesOf {
            symplectic: by_terms && *poisson,
            conserves_energy: !by_terms && autonomous,
            ..pieces_of(name, kernels)
        }
    };
    found.into_iter().map(pieces).collect()
}

/// Returns the reason why there are no pieces, for every splitting.
fn none(term: Id, why: &'static str) -> Vec<PiecesOf> {
    let none = |Splitting { name, marker, .. }| pieces_of(name, Err(Missing::new(marker, term, why)));
    [BY_TERMS, BY_PLANES, BY_GRADIENTS, BY_INCREMENTS].map(none).into()
}

/// Creates the pieces of a splitting that preserves nothing.
fn pieces_of(splitting: &'static str, pieces: Result<Vec<PieceKernel>, Missing>) -> PiecesOf {
    PiecesOf { splitting, pieces, cost: 0, linear: false, rejected: vec![], symplectic: false, conserves_energy: false }
}

/// Creates the kernel of one piece.
fn kernel(graph: &mut Graph, part: Part) -> PieceKernel {
    let levels = match part.clock {
        Clock::Own => Levels::Unfrozen,
        Clock::Stage => Levels::Frozen,
    };
    let known = part.rules.iter().map(|rule| format!("{}: {}", rule.name, rule.fields)).collect();
    let (solved, may_end, flow) = match part.motion {
        Motion::Closed(changed) => {
            let ends: Vec<Id> = changed.iter().map(|(_, end)| *end).collect();
            let may_end = split::may_end(graph, part.formula, &ends);
            let changed = split::steady(graph, changed);
            (false, may_end, FlowKernel::with_increments(graph, levels, changed))
        }
        Motion::Solved(pair, field) => {
            let h = graph.symbol(Symbol::StepLength);
            let Scaled { image, matrix } = implicit::scaled(graph, &field, h);
            let moved = pair.map(|symbol| match symbol {
                Symbol::Position(i) => Symbol::PositionIncrement(i),
                other => other,
            });
            let moved = Space { symbols: moved.to_vec(), extents: vec![2] };
            let outputs = vec![Output::row("image", image), Output::square("matrix", &[2], &matrix)];
            let equation = Routine::new("equation", outputs).reading("increment", &moved);
            (true, true, FlowKernel { changes: pair.to_vec(), kernel: Kernel::new(levels, vec![equation]) })
        }
    };
    PieceKernel { energy: part.formula, solved, may_end, known, clock: part.clock, flow }
}
