//! Kernels of methods for H = A + B, such as planets around a sun: A has an exact flow, and B is small. `split` has chosen A.
//!
//! A step alternates the flows of A and B, so its error is proportional to B. The methods are correct for any B and pay off for a small one. The runtime's traits
//! are `PerturbedSystem` and, for kicks with a force gradient, `PerturbedGradient`.

use super::{FlowKernel, Missing};
use crate::ir::Id;
use crate::schedule::{Routine, Scheduler};
use crate::split::OwnMotion;
use std::ops::Range;

/// Both parts of H and their flows.
#[derive(Debug)]
pub(crate) struct Perturbed {
    /// Energy A, in the coordinates in which the method moves.
    pub(crate) a: Id,
    /// Energy B = H − A, in the same coordinates.
    pub(crate) b: Id,
    /// Motions inside A that may end within a step, such as a fall into the centre of attraction, each with the range of coordinates that it moves.
    /// The runtime names the motion in its error.
    pub(crate) own_motions: Vec<(OwnMotion, Range<usize>)>,
    /// Lines of the report: the rules that gave the flow of A, with energies and sources.
    pub(crate) rules: Vec<String>,
    /// True if the flow of A is exact in its own time, from t to t + h. Otherwise it takes place at the frozen time of the kicks beside it.
    pub(crate) time_passes_in_a: bool,
    pub(crate) flow_of_a: FlowKernel,
    /// Flow of B: a kick, or a kick and a motion of the positions.
    pub(crate) flow_of_b: FlowKernel,
    /// True if B moves momenta only.
    pub(crate) b_is_kick: bool,
    /// True if `flow_of_b` is exact. Otherwise it is a symmetric step of order 2.
    pub(crate) b_is_exact: bool,
    /// True if the impulse of a kick depends on positions only. Two kicks at the same positions then have the same impulse, and the runtime computes it once.
    pub(crate) kicks_repeat: bool,
    /// Kick by B with a force gradient.
    pub(crate) gradient_kick: Result<FlowKernel, Missing>,
    /// Coordinates in which A and B move, if these differ from the coordinates of the state.
    pub(crate) inner: Option<Inner>,
}

/// Coordinates of a method, such as Jacobi's for bodies that attract each other.
#[derive(Debug)]
pub(crate) struct Inner {
    /// Name in the report.
    pub(crate) name: &'static str,
    /// From the coordinates of the state.
    pub(crate) enter: FlowKernel,
    /// Back to the coordinates of the state.
    pub(crate) leave: FlowKernel,
    /// Pairs (m, M) of a mass and a sum of masses: the coordinates divide m by M.
    pub(crate) shares: Vec<[Id; 2]>,
    /// Evaluates the masses and `shares`. The runtime refuses parameters with |M| below the rounding error of m.
    pub(crate) check_of_masses: Routine,
}

impl Perturbed {
    /// Schedules all routines. The caller has built all nodes.
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        let kicks = [&mut self.flow_of_b].into_iter().chain(&mut self.gradient_kick);
        for flow in [&mut self.flow_of_a].into_iter().chain(kicks) {
            flow.kernel.schedule(scheduler);
        }
        if let Some(Inner { enter, leave, check_of_masses, .. }) = &mut self.inner {
            enter.kernel.schedule(scheduler);
            leave.kernel.schedule(scheduler);
            check_of_masses.schedule(scheduler);
        }
    }
}
