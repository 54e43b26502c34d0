//! The modified energy, which a composition of flows keeps to a higher order than H.

use super::flow::Piece;
use super::time::Clock;
use crate::diff::modified;
use crate::ir::{Graph, Id};

/// Returns the modified energy of a composition of pieces up to h⁴. In dissipative systems it decays.
pub(crate) fn modified_energy(graph: &mut Graph, pieces: &[Piece], degrees: u32) -> Id {
    let frozen = modified::TimeCoordinate(0);
    // Frozen time advances before and after all flows.
    let mut parts = vec![modified::Part { energy: graph.zero(), advances: Some(frozen) }];
    for (i, piece) in (1..).zip(pieces) {
        let (reads, advances) = match piece.clock {
            Clock::Own => (modified::TimeCoordinate(i), Some(modified::TimeCoordinate(i))),
            Clock::Stage => (frozen, None),
        };
        parts.push(modified::Part { energy: reads.read(graph, piece.energy), advances });
    }
    modified::modified_energy(graph, &parts, degrees)
}
