//! Routines of rigid bodies.

use super::FlowKernel;
use crate::ir::Symbol;
use crate::schedule::{Routine, Scheduler};

/// Kicks and drifts of rigid bodies.
#[derive(Debug)]
pub(crate) struct BodyKernels {
    pub(crate) kick: FlowKernel,
    pub(crate) gradient_kick: FlowKernel,
    /// The nonzero entries of hJ and hb of every body, and of hM⁻¹, each once.
    pub(crate) drift: Routine,
    /// The rotation of each body, by indices of these entries.
    pub(crate) turns: Vec<Turn>,
    /// The shift of each coordinate of the centres of mass, by indices of these entries.
    pub(crate) centres: Vec<[Shift; 3]>,
    /// True if the frames of all bodies are frames of principal axes.
    pub(crate) principal: bool,
    /// True if the impulse of a kick depends on positions only.
    pub(crate) kicks_repeat: bool,
}

/// The rotation vector hω = hJm + hb of one body in a drift, by indices of prepared numbers. Zero entries are absent.
#[derive(Clone, Debug, Default)]
pub(crate) struct Turn {
    pub(crate) linear: [[Option<usize>; 3]; 3],
    pub(crate) constant: [Option<usize>; 3],
    /// An axis about which the body is symmetric.
    pub(crate) symmetry: Option<usize>,
}

/// The increment of a coordinate of a centre of mass in a drift: a linear form in the momenta, and a constant. Both are indices of prepared numbers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shift {
    pub(crate) linear: Vec<(usize, Symbol)>,
    pub(crate) constant: Option<usize>,
}

impl BodyKernels {
    /// Computes the statements of all routines.
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        self.kick.kernel.schedule(scheduler);
        self.gradient_kick.kernel.schedule(scheduler);
        self.drift.schedule(scheduler);
    }
}
