//! Everything that some method needs of a system, as nodes: derived once, before anything is emitted.
//!
//! One value, [`System`], holds it for every form. A part that a form does not have is `None`. A part that an energy lacks is `Err` with the
//! reason.

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
mod findings;

pub(crate) use bodies::{BodyKernels, Shift, Turn, bodies};
pub(crate) use canonical::{Decompositions, canonical};
pub(crate) use constraints::constrained;
pub(crate) use contact::{ContactEnergy, contact};
pub(crate) use domain::{Angles, Check, Domain, Edges, Sign};
pub(crate) use exact::parts::{Parted, parts};
pub(crate) use facts::Fact;
pub(crate) use findings::{BesideVelocities, Derived, FieldFindings, Findings, Source};
pub(crate) use flow::flow;
pub(crate) use forced::{Forced, forced};
pub(crate) use implicit::MOST_UNKNOWNS;
pub(crate) use jet::JetKernel;
pub(crate) use poles::{Jumps, Margin, Margins, Poles, Signs};
pub(crate) use proof::flow::{Flow, Named, Origin};
pub(crate) use proof::liouville::{Liouville, Multiplier, Recovered, liouville};
pub(crate) use system::{
    ActionStages, Collocation, ConstraintKernels, ContactStages, FieldKernels, FlowKernel, GradientKick, Implicit,
    Inner, Integrals, KeptMomentum, KickDrift, Lagrangian, MassKernels, Missing, Modified, NamedFunction, Pair,
    Perturbed, PieceKernel, PiecesOf, StageKernel, StepKernel, System, Undamped, VelocityKernels, VelocityStages,
};
pub(crate) use velocities::{LagrangianOfVelocities, velocities};
