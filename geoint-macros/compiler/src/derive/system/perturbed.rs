//! H = A + B: a part A with an exact flow, and the rest B.

use super::{FlowKernel, Missing};
use crate::ir::Id;
use crate::schedule::{Routine, Scheduler};
use crate::split::OwnMotion;
use std::ops::Range;

/// Flows of A and B.
#[derive(Debug)]
pub(crate) struct Perturbed {
    /// A.
    pub(crate) exact: Id,
    /// B.
    pub(crate) rest: Id,
    /// True if the flow of B is a kick.
    pub(crate) is_kick: bool,
    /// True if the flow of B is exact. Otherwise it is replaced by a step of order 2.
    pub(crate) is_exact: bool,
    /// Parts of the flow of A that may end within a step.
    pub(crate) parts: Vec<(OwnMotion, Range<usize>)>,
    /// Rules of the flow of A: their names, energies and sources.
    pub(crate) known: Vec<String>,
    pub(crate) flow: FlowKernel,
    /// Flow of A after a kick that adds Dp to the momenta. Present if the flow is linear in p. The kick then enters through one product and one
    /// sum.
    pub(crate) flow_after_kick: Option<FlowKernel>,
    /// True if the flow of A is exact in its own time.
    pub(crate) exact_in_time: bool,
    pub(crate) kick: FlowKernel,
    /// True if the impulse of a kick depends on positions only.
    pub(crate) repeats: bool,
    pub(crate) gradient_kick: Result<FlowKernel, Missing>,
    pub(crate) inner: Option<Inner>,
}

/// Coordinates in which A and B move, if these differ from the coordinates of the state.
#[derive(Debug)]
pub(crate) struct Inner {
    pub(crate) name: &'static str,
    pub(crate) enter: FlowKernel,
    pub(crate) leave: FlowKernel,
    /// Masses, each with its divisor.
    pub(crate) shares: Vec<[Id; 2]>,
    /// The values of all masses and shares, which the runtime checks.
    pub(crate) weighed: Routine,
}

impl Perturbed {
    /// Computes the statements of all routines.
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        let kicks = [&mut self.kick].into_iter().chain(&mut self.gradient_kick);
        for flow in [&mut self.flow].into_iter().chain(&mut self.flow_after_kick).chain(kicks) {
            flow.kernel.schedule(scheduler);
        }
        if let Some(Inner { enter, leave, weighed, .. }) = &mut self.inner {
            enter.kernel.schedule(scheduler);
            leave.kernel.schedule(scheduler);
            weighed.schedule(scheduler);
        }
    }
}
