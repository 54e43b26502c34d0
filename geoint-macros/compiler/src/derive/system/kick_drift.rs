//! Kick and drift: the flows of V and T.

use super::{FlowKernel, Missing};
use crate::schedule::{Routine, Scheduler};

/// Kick and drift.
#[derive(Debug)]
pub(crate) struct KickDrift {
    pub(crate) kick: FlowKernel,
    pub(crate) drift: FlowKernel,
    /// True if time passes during a drift. Otherwise T is followed at the fixed time of the kick.
    pub(crate) time_passes_in_drift: bool,
    /// True if the impulse of a kick depends on positions only. Two kicks at the same positions then have the same impulse, and the runtime computes it once.
    pub(crate) kicks_repeat: bool,
    /// True if a kick outside the domain of the energy makes momenta that are not finite. The runtime then sees them without a test of the domain.
    pub(crate) kicks_show: bool,
    pub(crate) gradient_kick: Result<GradientKick, Missing>,
    /// For contact systems.
    pub(crate) undamped: Option<Undamped>,
}

/// A kick with a force gradient.
#[derive(Debug)]
pub(crate) enum GradientKick {
    /// A derivative of the field, by the kernel of collocation.
    Collocation,
    Flow(FlowKernel),
}

/// Kick and drift without damping, each present if damping changes it, and the damping.
#[derive(Debug)]
pub(crate) struct Undamped {
    pub(crate) kick: Option<FlowKernel>,
    pub(crate) drift: Option<FlowKernel>,
    pub(crate) damping: Routine,
}

impl KickDrift {
    /// Schedules all routines. The caller has built all nodes.
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        self.kick.kernel.schedule(scheduler);
        self.drift.kernel.schedule(scheduler);
        if let Ok(GradientKick::Flow(flow)) = &mut self.gradient_kick {
            flow.kernel.schedule(scheduler);
        }
        if let Some(Undamped { kick, drift, damping }) = &mut self.undamped {
            kick.iter_mut().chain(drift).for_each(|flow| flow.kernel.schedule(scheduler));
            damping.schedule(scheduler);
        }
    }
}
