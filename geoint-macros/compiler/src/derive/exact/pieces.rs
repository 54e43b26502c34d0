//! Kernels of the pieces of an energy.

use crate::derive::system::{FlowKernel, Missing, PieceKernel, PiecesOf};
use crate::ir::{Graph, Id, Symbol};
use crate::split::{self, Pieces};

/// The coordinates that the flows of pieces change.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::derive) enum Followed {
    /// q and p. Flows preserve areas, so they are rewritten if their rounding errors would change areas with one sign.
    Canonical,
    /// q, p and s. Friction contracts areas, so rounding does not matter.
    Contact,
    /// q and s. The momenta of a lift are not followed.
    Lift,
}

impl Followed {
    /// Returns the name of the splitting.
    fn splitting(self) -> &'static str {
        if self == Followed::Canonical { "PieceSplitting" } else { "ContactSplitting" }
    }
}

/// Creates the kernels of all pieces. If a term is in no piece, `why` is the message.
pub(in crate::derive) fn kernels(graph: &mut Graph, followed: Followed, found: &Pieces, why: &'static str) -> PiecesOf {
    let pieces = match found {
        Ok(found) => Ok(found.pieces.iter().map(|piece| kernel(graph, piece, followed)).collect()),
        Err(term) => Err(Missing::new("Splits", *term, why)),
    };
    let split::Partition { cost, linear, rejected, .. } = found.clone().unwrap_or_default();
    PiecesOf {
        splitting: followed.splitting(),
        pieces,
        cost,
        linear,
        rejected,
        symplectic: true,
        conserves_energy: false,
    }
}

/// Creates the kernel of one piece.
fn kernel(graph: &mut Graph, piece: &split::Piece, followed: Followed) -> PieceKernel {
    let mut changed = piece.flow.changed(graph);
    changed.retain(|(symbol, _)| !(followed == Followed::Lift && matches!(symbol, Symbol::Momentum(_))));
    let ends: Vec<Id> = changed.iter().map(|(_, end)| *end).collect();
    let may_end = split::may_end(graph, piece.energy, &ends);
    let changed = if followed == Followed::Canonical { split::steady(graph, changed) } else { changed };
    let flow = FlowKernel::with_increments(graph, piece.levels(), changed);
    let split::Family { name, energies, source, .. } = piece.family;
    let known = vec![format!("{name}: {energies} ({source})")];
    PieceKernel { energy: piece.energy, solved: false, may_end, known, clock: piece.clock, flow }
}
