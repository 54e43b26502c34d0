//! Reports x' = L ∇E + M ∇S: friction, and the laws of the flow and of a step.

use super::Report;
use crate::diff::entropy::{Block, EntropyStep};
use crate::ir::Symbol;

/// Writes the blocks of M, and the laws of the flow.
pub(super) fn friction(report: &mut Report<'_>, step: &EntropyStep) {
    for block in &step.friction {
        writeln!(report, "- M acts on {}", coordinates(report, block));
    }
    writeln!(report, "- L ∇S = 0 and M ∇E = 0: dE/dt = ∂E/∂t and dS/dt = ∇S·M ∇S ≥ 0");
}

/// Writes the laws of a step, and the projections that it needs for them.
pub(super) fn step(report: &mut Report<'_>, step: &EntropyStep) {
    writeln!(
        report,
        "- `DiscreteGradient` keeps an energy without time, and adds h ∇̄S·M ∇̄S ≥ 0 to the entropy for h > 0, both to rounding"
    );
    for (matrix, slope, blocks) in [("L", "∇̄S", &step.structure), ("M", "∇̄E", &step.friction)] {
        for block in blocks.iter().filter(|block| block.projected) {
            writeln!(report, "- its {matrix} is projected across {slope} on {}", coordinates(report, block));
        }
    }
    writeln!(
        report,
        "- compositions with steps back in time, and `FourthOrder`, do not exist: entropy may fall in them"
    )
}

/// Lists the coordinates of a block.
fn coordinates(report: &Report<'_>, block: &Block) -> String {
    let coordinates: Vec<u32> = block.coordinates.iter().map(|i| *i as u32).collect();
    report.names(Symbol::Position, &coordinates)
}
