//! H = A + B: a part with an exact flow, and a rest.

use super::{FlowKernel, Missing};
use crate::ir::Id;
use crate::schedule::{Routine, Scheduler};
use crate::split::OwnMotion;
use std::ops::Range;

/// Flows of A and B.
#[derive(Debug)]
pub(crate) struct Perturbed {
    pub(crate) exact: Id,
    pub(crate) rest: Id,
    /// Whether the flow of B is a kick.
    pub(crate) is_kick: bool,
    /// Whether the map of B is its flow. Else it is a step of order 2.
    pub(crate) is_exact: bool,
    /// Parts of the flow of A that may end within a step.
    pub(crate) parts: Vec<(OwnMotion, Range<usize>)>,
    /// The rules by which the flow of A is known.
    pub(crate) known: Vec<String>,
    pub(crate) flow: FlowKernel,
    /// Flow of A after a kick that adds Dp to the momenta. Present if the flow is linear in p. The kick then enters through one product and one
    /// sum.
    pub(crate) flow_after_kick: Option<FlowKernel>,
    /// Whether the flow of A is exact in its own time.
    pub(crate) exact_in_time: bool,
    pub(crate) kick: FlowKernel,
    /// Whether the impulse of a kick depends on positions only.
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
    /// Masses, each with the sum that it is divided by.
    pub(crate) shares: Vec<[Id; 2]>,
    /// The values of all masses, and those of the shares.
    pub(crate) weighed: Routine,
}

impl Perturbed {
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        self.flow.kernel.schedule(scheduler);
        if let Some(after) = &mut self.flow_after_kick {
            after.kernel.schedule(scheduler);
        }
        self.kick.kernel.schedule(scheduler);
        if let Ok(kick) = &mut self.gradient_kick {
            kick.kernel.schedule(scheduler);
        }
        if let Some(inner) = &mut self.inner {
            inner.enter.kernel.schedule(scheduler);
            inner.leave.kernel.schedule(scheduler);
            inner.weighed.schedule(scheduler);
        }
    }
}
