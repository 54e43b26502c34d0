//! Kernels of the methods of one form: implicit methods, and splittings of rigid bodies.

use super::Missing;
use super::bodies::BodyKernels;
use crate::analyze::{Conserved, MeanValue};
use crate::diff::constraint::Row;
use crate::schedule::{Kernel, Routine, Scheduler, Space};

/// Kernels of the methods of one form.
#[derive(Debug)]
pub(crate) enum Kernels {
    /// Implicit methods of a canonical system or a flow.
    Field(Box<FieldKernels>),
    /// Implicit methods of a contact system.
    Contact(ContactKernels),
    /// Implicit methods of a Lagrangian, with velocities as unknowns.
    Velocities(VelocityKernels),
    /// Implicit methods of a system with constraints.
    Constrained(ConstraintKernels),
    /// Kicks and drifts of rigid bodies.
    Bodies(BodyKernels),
}

/// ∂L/∂v of a Lagrangian, and its dependence on v.
#[derive(Debug)]
pub(crate) struct MassKernels {
    /// ∂L/∂v and M.
    pub(crate) mass: Routine,
    /// Functions of the parameters: the outputs `not_negative` and `positive`. If all their values have these signs, M is positive definite at
    /// every state.
    pub(crate) definite: Option<Routine>,
    /// True if L is quadratic in v.
    pub(crate) quadratic: bool,
}

/// Stages of collocation of a Lagrangian, with velocities as unknowns.
#[derive(Debug)]
pub(crate) struct VelocityStages {
    pub(crate) decay: Decay,
    pub(crate) mixed: MixedDerivatives,
    pub(crate) mass: MassKernels,
    /// The routines `stage` and `force`.
    pub(crate) stage: Kernel,
}

/// The derivatives of p = ∂L/∂v and of the force that are not zero everywhere, beside the mass matrix and ∂f/∂q.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MixedDerivatives {
    pub(crate) momentum_by_q: bool,
    pub(crate) momentum_by_s: bool,
    pub(crate) force_by_v: bool,
    pub(crate) force_by_s: bool,
}

/// The decay rate σ = −∂L/∂s.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Decay {
    /// There is no action.
    None,
    /// σ reads time alone. The action follows from the velocities.
    OfTime,
    /// σ reads the state. The action is an unknown of each stage.
    OfState,
}

/// Constraints, and the steps that keep them.
#[derive(Debug)]
pub(crate) struct ConstraintKernels {
    pub(crate) rows: Vec<Row>,
    /// True if ∂H/∂p is affine in p.
    pub(crate) quadratic: bool,
    /// g, A and b.
    pub(crate) values: Routine,
    /// ∂H/∂p and ∂²H/∂p².
    pub(crate) velocity: Routine,
    /// g and its size, A ∂H/∂p + b and its size.
    pub(crate) departure: Routine,
    /// λ of constraints of positions, and μ of the others.
    pub(crate) multipliers: Routine,
    /// A step of each method by name: the routines `residual`, `end` and `origin`.
    pub(crate) steps: Vec<(&'static str, StepKernel)>,
}

/// A Lagrangian by its derivatives.
#[derive(Debug)]
pub(crate) struct VelocityKernels {
    pub(crate) stages: VelocityStages,
    /// True if the flow keeps p·v − L: there is no action, no friction and no other force, and L does not read time.
    pub(crate) keeps: bool,
    /// The polarised discrete gradient with the routine `equation`, if L is quadratic in v.
    pub(crate) polarised: Result<StepKernel, Missing>,
    /// Sums of momenta and angular momenta that the flow keeps.
    pub(crate) momenta: Vec<KeptMomentum>,
}

/// A momentum that a flow keeps.
#[derive(Debug)]
pub(crate) struct KeptMomentum {
    pub(crate) momentum: Conserved,
    /// True if the polarised discrete gradient keeps it, too.
    pub(crate) by_gradient: bool,
}

/// The field of implicit methods for (q, p), for q alone, or for x.
#[derive(Debug)]
pub(crate) struct FieldKernels {
    /// Coordinates of a stage, and their increments: the unknowns.
    pub(crate) coordinates: Space,
    pub(crate) increments: Space,
    pub(crate) collocation: Collocation,
    /// The routines `slope`, `drift` if there are momenta, and `equation` if Newton's iteration has one.
    pub(crate) discrete: Option<Kernel>,
    /// The reason why there is no discrete gradient, if the divergence of the field is known to be the reason.
    pub(crate) nothing_kept: Option<Missing>,
    /// The reason why steps of the discrete gradient are no part of a method of order 4, if back in time they would lower an entropy.
    pub(crate) forward: Option<Missing>,
    /// Canonical coordinates of a Lagrangian that is linear in the velocities, and their rates, with derivatives. If collocation moves them, it is symplectic.
    pub(crate) canonical: Option<Kernel>,
    /// A step of order 4, of a flow or of a canonical system: h·f̄ and 1 − ∂(h·f̄)/∂d.
    pub(crate) fourth: Option<Kernel>,
    /// Gradients of the momenta that steps of order 4 of a canonical system keep.
    pub(crate) momenta: Routine,
    /// True if the equation of a step is known to be linear. Only canonical systems ask.
    pub(crate) linear: bool,
    pub(crate) mean_value: MeanValue,
}

/// Stages of collocation: y' = f(y), or q'' = f(q).
#[derive(Debug)]
pub(crate) struct Collocation {
    /// True if the equation is of second order.
    pub(crate) second_order: bool,
    /// The routines `field`, and `velocity` and `acceleration` of an equation of second order.
    pub(crate) kernel: Kernel,
}

/// Implicit steps of a contact system.
#[derive(Debug)]
pub(crate) struct ContactKernels {
    /// A step of each method by name, such as `ContactMidpoint`: the routines `image` and `end`.
    pub(crate) steps: Vec<(&'static str, StepKernel)>,
    /// Collocation. Absent if momenta are not followed.
    pub(crate) stages: Option<ContactStages>,
}

/// Unknowns of collocation of a contact system.
#[derive(Debug)]
pub(crate) enum ContactStages {
    Points(StageKernel),
    Velocities(Box<VelocityStages>),
}

/// The field of a contact system at a stage.
#[derive(Debug)]
pub(crate) struct StageKernel {
    /// The unknowns: q and p, and s if their rates read it.
    pub(crate) moved: Space,
    /// The routines `stage`, `decay` and `action`.
    pub(crate) kernel: Kernel,
}

/// The equation of an implicit step.
#[derive(Debug)]
pub(crate) struct StepKernel {
    pub(crate) unknowns: Space,
    pub(crate) kernel: Kernel,
}

impl Kernels {
    /// Computes the statements of all routines.
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        match self {
            Kernels::Field(field) => {
                field.collocation.kernel.schedule(scheduler);
                for kernel in [&mut field.discrete, &mut field.canonical, &mut field.fourth].into_iter().flatten() {
                    kernel.schedule(scheduler);
                }
                field.momenta.schedule(scheduler);
            }
            Kernels::Velocities(VelocityKernels { stages, polarised, .. }) => {
                stages.schedule(scheduler);
                polarised.iter_mut().for_each(|step| step.kernel.schedule(scheduler));
            }
            Kernels::Contact(ContactKernels { steps, stages }) => {
                steps.iter_mut().for_each(|(_, step)| step.kernel.schedule(scheduler));
                match stages {
                    Some(ContactStages::Points(stages)) => stages.kernel.schedule(scheduler),
                    Some(ContactStages::Velocities(stages)) => stages.schedule(scheduler),
                    None => {}
                }
            }
            Kernels::Bodies(kernels) => kernels.schedule(scheduler),
            Kernels::Constrained(ConstraintKernels { values, velocity, departure, multipliers, steps, .. }) => {
                [values, velocity, departure, multipliers].into_iter().for_each(|routine| routine.schedule(scheduler));
                steps.iter_mut().for_each(|(_, step)| step.kernel.schedule(scheduler));
            }
        }
    }
}

impl VelocityStages {
    /// Returns whether the action is an unknown of a stage.
    pub(crate) fn has_action_unknown(&self) -> bool {
        self.decay == Decay::OfState
    }

    fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        self.mass.schedule(scheduler);
        self.stage.schedule(scheduler);
    }
}

impl MassKernels {
    fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        self.mass.schedule(scheduler);
        self.definite.iter_mut().for_each(|definite| definite.schedule(scheduler));
    }
}
