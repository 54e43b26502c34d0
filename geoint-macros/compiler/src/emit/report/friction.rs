//! Reports damping and other forces.

use super::Report;
use crate::analyze::{Damping, Forces};
use crate::check::wording::commas;
use crate::ir::Id;

/// Reports the damping matrix and the loss of energy.
pub(super) fn damping(report: &mut Report<'_>, damping: &Damping, autonomous: bool) {
    let diagonal: Vec<Id> = (0..damping.matrix.len()).map(|i| damping.matrix[i][i]).collect();
    let matrix = match damping.diagonal {
        true if diagonal.iter().all(|entry| *entry == diagonal[0]) => report.excerpt(diagonal[0]),
        true => format!("diag({})", report.excerpts(&diagonal)),
        false => format!("[{}]", commas(damping.matrix.iter().map(|row| report.vector(row)))),
    };
    let explicit = if autonomous { "" } else { " + ∂H/∂t" };
    writeln!(report, "\nDamping");
    writeln!(report, "- p' = −∂H/∂q − C ∂H/∂p with C = {matrix}");
    writeln!(report, "- dH/dt = −∂H/∂p·C ∂H/∂p{explicit}");
    if autonomous {
        writeln!(report, "- in a step of `DiscreteGradient` the energy falls by exactly h ∇̄H·C ∇̄H, for every h");
    }
    writeln!(report, "- kick and drift do not exist: damping is no part of either")
}

/// Reports applied forces, friction, and their power.
pub(super) fn forces(report: &mut Report<'_>, forces: &Forces, autonomous: bool) {
    writeln!(report, "\nForces beside the energy");
    let mut power = vec![];
    if let Some(applied) = &forces.applied {
        writeln!(report, "- F = {}", report.vector(applied));
        power.push("v·F");
    }
    if let Some(friction) = &forces.friction {
        writeln!(report, "- friction −∂R/∂v with ∂R/∂v = {}", report.vector(friction));
        power.push("− v·∂R/∂v");
    }
    writeln!(report, "- they add {} to dH/dt, with v = ∂H/∂p", power.join(" "));
    if autonomous {
        writeln!(
            report,
            "- in a step of `DiscreteGradient` they add exactly h times that at the mean velocity, for every h"
        );
    }
    if forces.friction.is_some() {
        writeln!(report, "- a step in which friction would feed energy is refused");
    }
    if let Some(potential) = forces.potential {
        writeln!(
            report,
            "- this force has a potential: add {} to L, or take it off H, and the discrete gradient keeps the whole energy",
            report.excerpt(potential)
        );
    }
    writeln!(report, "- kick and drift do not exist: a force is no part of either")
}
