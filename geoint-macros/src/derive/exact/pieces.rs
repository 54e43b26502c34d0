//! The pieces of an energy in kernels.

use crate::derive::system::{FlowKernel, Missing, PieceKernel, PiecesOf};
use crate::ir::{Graph, Id, Symbol};
use crate::schedule::Kernel;
use crate::split::{self, Pieces};

/// The flows of pieces, of a splitting with its name, or what is said of the term that is in none; `rest` if momenta are not followed.
pub(in crate::derive) fn kernels(
    graph: &mut Graph,
    splitting: &'static str,
    (found, why): (&Pieces, &'static str),
    rest: bool,
) -> PiecesOf<Kernel> {
    let pieces = match found {
        Ok(found) => {
            let canonical = splitting == "PieceSplitting";
            Ok(found.pieces.iter().map(|piece| kernel(graph, piece, rest, canonical)).collect())
        }
        Err(term) => Err(Missing { marker: "Splits", term: *term, why, pair: None }),
    };
    let split::Partition { cost, linear, rejected, .. } = found.clone().unwrap_or_default();
    PiecesOf { splitting, pieces, cost, linear, rejected, symplectic: true, conserves_energy: false }
}

fn kernel(graph: &mut Graph, piece: &split::Piece, rest: bool, canonical: bool) -> PieceKernel<Kernel> {
    let mut changed = piece.flow.changed(graph);
    changed.retain(|(symbol, _)| !(rest && matches!(symbol, Symbol::P(_))));
    let ends: Vec<Id> = changed.iter().map(|(_, end)| *end).collect();
    let may_end = split::may_end(graph, piece.energy, &ends);
    // Friction lets areas shrink anyway.
    let changed = if canonical { split::steady(graph, changed) } else { changed };
    let flow = FlowKernel::with_increments(graph, piece.levels(), changed);
    let split::Family { name, energies, source, .. } = piece.family;
    let known = vec![format!("{name}: {energies} ({source})")];
    PieceKernel { energy: piece.energy, solved: false, may_end, known, clock: piece.clock, flow }
}
