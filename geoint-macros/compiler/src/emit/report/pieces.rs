//! Reports pieces with known flows.

use super::Report;
use crate::check::wording::commas;
use crate::derive::{Pair, PieceKernel, PiecesOf, System};
use crate::split::{Clock, Rejected, tried};

/// Reports the pieces of an energy, and the rejected partitions.
pub(super) fn of_energy(report: &mut Report<'_>, found: &PiecesOf) {
    let pieces = match &found.pieces {
        Ok(pieces) => pieces,
        Err(missing) => {
            writeln!(report, "- none: no rule knows the flow of {}", report.excerpt(missing.term));
            let families = tried(report.compilation.form.has_action()).map(|(_, family)| family.name.into());
            return writeln!(report, "- families that were tried: {}", commas(families));
        }
    };
    for piece in pieces {
        writeln!(report, "- {}", report.excerpt(piece.energy));
        flow(report, piece);
    }
    if found.linear {
        writeln!(report, "- linear motion is one piece, beside which errors are as small as the rest is");
    }
    for Rejected { energies, cost } in &found.rejected {
        let energies: Vec<String> = energies.iter().map(|energy| report.excerpt(*energy)).collect();
        let (energies, chosen) = (energies.join(" | "), found.cost);
        writeln!(report, "- rejected, at a cost of {cost} a step where these have {chosen}: {energies}");
    }
}

/// Writes the rules, time dependence and cost of the flow of a piece.
fn flow(report: &mut Report<'_>, piece: &PieceKernel) {
    for known in &piece.known {
        writeln!(report, "  {known}");
    }
    let clock = match piece.clock {
        Clock::Own => "exact in time",
        Clock::Stage => "time frozen in the middle of a step",
    };
    let each = if piece.solved { " an iteration" } else { "" };
    writeln!(report, "  {clock}; {}{each}", piece.flow.kernel.operations())
}

/// Reports the pieces of all splittings of a flow x' = S ∇I. `integral` is the name of I.
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
                    let moved = match &piece.flow.changes[..] {
                        [] => "nothing".into(),
                        changes => commas(changes.iter().map(|symbol| report.named(*symbol))),
                    };
                    match by_planes {
                        true => writeln!(report, "- the plane of {moved}"),
                        false => writeln!(report, "- {}, moves {moved}", report.excerpt(piece.energy)),
                    }
                    flow(report, piece);
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
