//! What was found of pieces, in words.

use super::{Report, counted};
use crate::derive::{Pair, PieceKernel, PiecesOf, System};
use crate::split::{Clock, Rejected, tried};

/// The coordinates of the pieces.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Alphabet {
    /// q and p.
    Canonical,
    /// q, p and s.
    Contact,
}

/// The pieces of an energy, and what else was found.
pub(super) fn of_energy(report: &mut Report<'_>, found: &PiecesOf, alphabet: Alphabet) {
    let pieces = match &found.pieces {
        Ok(pieces) => pieces,
        Err(missing) => {
            writeln!(report, "- none: no rule knows the flow of {}", report.excerpt(missing.term));
            let names: Vec<&str> = tried(alphabet == Alphabet::Contact).map(|(_, family)| family.name).collect();
            writeln!(report, "- families that were tried: {}", names.join(", "));
            return;
        }
    };
    pieces.iter().for_each(|each| piece(report, each));
    if found.linear {
        writeln!(report, "- linear motion is one piece, beside which errors are as small as the rest is");
    }
    for Rejected { energies, cost } in &found.rejected {
        let energies: Vec<String> = energies.iter().map(|energy| report.excerpt(*energy)).collect();
        writeln!(
            report,
            "- rejected, at a cost of {cost} a step where these have {}: {}",
            found.cost,
            energies.join(" | ")
        );
    }
}

/// A piece, and how its flow is known.
fn piece(report: &mut Report<'_>, piece: &PieceKernel) {
    writeln!(report, "- {}", report.excerpt(piece.energy));
    of_piece(report, piece)
}

fn of_piece(report: &mut Report<'_>, piece: &PieceKernel) {
    for known in &piece.known {
        writeln!(report, "  {known}");
    }
    let clock = match piece.clock {
        Clock::Own => "exact in time",
        Clock::Stage => "time frozen in the middle of a step",
    };
    let each = if piece.solved { " an iteration" } else { "" };
    writeln!(report, "  {clock}; {}{each}", counted(piece.flow.kernel.operations()))
}

/// The pieces of all splittings of a flow, and what becomes of `integral`, by whose gradient it is split.
pub(super) fn of_flow(report: &mut Report<'_>, system: &System, integral: &str) {
    for PiecesOf { splitting, pieces, symplectic, conserves_energy, .. } in &system.pieces {
        let by_planes = *splitting != "PoissonSplitting";
        if by_planes && *splitting != "PlanarSplitting" {
            if let Ok(pieces) = pieces {
                let equations = if let [_] = pieces[..] { "equation" } else { "equations" };
                writeln!(report, "- `{splitting}`: {} {equations} of two unknowns", pieces.len());
            }
            continue;
        }
        writeln!(report, "\nPieces of `{splitting}`, in the order of half a step");
        match pieces {
            Ok(pieces) => {
                for piece in pieces {
                    let moved: Vec<String> = piece.flow.changes.iter().map(|symbol| report.named(*symbol)).collect();
                    let moved = if moved.is_empty() { "nothing".into() } else { moved.join(", ") };
                    match by_planes {
                        true => writeln!(report, "- the plane of {moved}"),
                        false => writeln!(report, "- {}, moves {moved}", report.excerpt(piece.energy)),
                    }
                    of_piece(report, piece);
                }
                match (symplectic, conserves_energy) {
                    (true, _) => {
                        writeln!(report, "- a Poisson map: Casimirs are kept to rounding, {integral} to the order");
                    }
                    (_, true) => writeln!(report, "- {integral} is kept to rounding, Casimirs to the order"),
                    _ => writeln!(report, "- no structure is kept"),
                }
            }
            Err(missing) => {
                let pair = missing.pair.map_or_else(String::new, |Pair { coordinates: [a, b], verb }| {
                    format!("; {} and {} {verb}", report.named(a), report.named(b))
                });
                writeln!(report, "- none, because of {}{pair}", report.excerpt(missing.term));
            }
        }
    }
}
