//! What was found of pieces, in words.

use super::counted;
use crate::derive::{PieceKernel, PiecesOf, System};
use crate::ir::print::Printer;
use crate::schedule::Plan;
use crate::split::{Clock, Rejected, tried};
use std::fmt::{Result as Written, Write};

/// The pieces of an energy, and what else was found.
pub(super) fn of_energy(text: &mut String, printer: &Printer<'_>, (found, action): (&PiecesOf<Plan>, bool)) -> Written {
    let pieces = match &found.pieces {
        Ok(pieces) => pieces,
        Err(missing) => {
            writeln!(text, "- none: no rule knows the flow of {}", printer.excerpt(missing.term))?;
            let names: Vec<&str> = tried(action).map(|(_, family)| family.name).collect();
            return writeln!(text, "- families that were tried: {}", names.join(", "));
        }
    };
    pieces.iter().try_for_each(|each| piece(text, printer, each))?;
    if found.linear {
        writeln!(text, "- linear motion is one piece, beside which errors are as small as the rest is")?;
    }
    for Rejected { energies, cost } in &found.rejected {
        let energies: Vec<String> = energies.iter().map(|energy| printer.excerpt(*energy)).collect();
        writeln!(
            text,
            "- rejected, at a cost of {cost} a step where these have {}: {}",
            found.cost,
            energies.join(" | ")
        )?;
    }
    Ok(())
}

/// A piece, and how its flow is known.
fn piece(text: &mut String, printer: &Printer<'_>, piece: &PieceKernel<Plan>) -> Written {
    writeln!(text, "- {}", printer.excerpt(piece.energy))?;
    of_piece(text, piece)
}

fn of_piece(text: &mut String, piece: &PieceKernel<Plan>) -> Written {
    piece.known.iter().try_for_each(|known| writeln!(text, "  {known}"))?;
    let clock = match piece.clock {
        Clock::Own => "exact in time",
        Clock::Stage => "time frozen in the middle of a step",
    };
    let each = if piece.solved { " an iteration" } else { "" };
    writeln!(text, "  {clock}; {}{each}", counted(piece.flow.kernel.operations()))
}

/// The pieces of all splittings of a flow, and what becomes of `integral`, by whose gradient it is split.
pub(super) fn of_flow(text: &mut String, printer: &Printer<'_>, (system, integral): (&System<Plan>, &str)) -> Written {
    for PiecesOf { splitting, pieces, symplectic, conserves_energy, .. } in &system.pieces {
        let by_planes = *splitting != "PoissonSplitting";
        if by_planes && *splitting != "PlanarSplitting" {
            if let Ok(pieces) = pieces {
                let equations = if let [_] = pieces[..] { "equation" } else { "equations" };
                writeln!(text, "- `{splitting}`: {} {equations} of two unknowns", pieces.len())?;
            }
            continue;
        }
        writeln!(text, "\nPieces of `{splitting}`, in the order of half a step")?;
        match pieces {
            Ok(pieces) => {
                for piece in pieces {
                    let moved: Vec<String> = piece.flow.changes.iter().map(|symbol| printer.named(*symbol)).collect();
                    let moved = if moved.is_empty() { "nothing".into() } else { moved.join(", ") };
                    match by_planes {
                        true => writeln!(text, "- the plane of {moved}")?,
                        false => writeln!(text, "- {}, moves {moved}", printer.excerpt(piece.energy))?,
                    }
                    of_piece(text, piece)?;
                }
                match (symplectic, conserves_energy) {
                    (true, _) => {
                        writeln!(text, "- a Poisson map: Casimirs are kept to rounding, {integral} to the order")?;
                    }
                    (_, true) => writeln!(text, "- {integral} is kept to rounding, Casimirs to the order")?,
                    _ => writeln!(text, "- no structure is kept")?,
                }
            }
            Err(missing) => {
                let pair = missing.pair.map_or_else(String::new, |([a, b], word)| {
                    format!("; {} and {} {word}", printer.named(a), printer.named(b))
                });
                writeln!(text, "- none, because of {}{pair}", printer.excerpt(missing.term))?;
            }
        }
    }
    Ok(())
}
