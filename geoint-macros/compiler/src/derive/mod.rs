//! Everything that some method needs of a system, as nodes: derived once, before anything is emitted.
//!
//! One value holds it for every form. It is a system of kernels; scheduled, the same is a system of plans. What a form does not have
//! is `None`, and what an energy does not have is `Err` with the reason.

pub(crate) mod proof;
mod facts;
mod poles;
mod domain;
mod system;
mod implicit;
mod jet;
mod canonical;
mod contact;
mod forced;
mod exact;
mod bodies;
mod flow;
mod velocities;
mod constraints;

pub(crate) use bodies::{Bodies, Shift, Turn, bodies};
pub(crate) use canonical::canonical;
pub(crate) use constraints::constrained;
pub(crate) use contact::contact;
pub(crate) use domain::{Angles, Check, Domain, Sign};
pub(crate) use exact::parts::{Parted, parts};
pub(crate) use facts::Fact;
pub(crate) use flow::flow;
pub(crate) use forced::forced;
pub(crate) use implicit::MOST_UNKNOWNS;
pub(crate) use jet::JetKernel;
pub(crate) use poles::{Jumps, Margin, Margins, Poles, Signs};
pub(crate) use proof::flow::{Flow, Named, Origin};
pub(crate) use proof::liouville::{Liouville, Multiplier, Recovered, liouville};
pub(crate) use system::{
    ConstraintKernels, ContactStages, FieldKernels, FlowKernel, GradientKick, HerglotzKernels, Implicit, Inner,
    Integrals, KickDrift, Lagrangian, MassKernels, Missing, Modified, Perturbed, PieceKernel, PiecesOf, StageKernel,
    StepKernel, System, Undamped, VelocityKernels, VelocityStages,
};
pub(crate) use velocities::{herglotz, velocities};
