//! From the facts about a system to the routines of every method, as nodes of the graph.
//!
//! A [`System`] has the routines of any form. A part that a form does not have is `None`. A part that an energy lacks is `Err` with the reason.

pub(crate) mod proof;
mod facts;
mod checks;
mod poles;
mod domain;
mod system;
mod implicit;
mod jet;
mod canonical;
mod contact;
mod forced_contact;
mod exact;
mod bodies;
mod flow;
mod velocities;
mod constraints;
mod findings;

pub(crate) use bodies::bodies;
pub(crate) use canonical::{Decompositions, canonical};
pub(crate) use checks::{Check, Sign};
pub(crate) use constraints::constrained;
pub(crate) use contact::{ContactEnergy, contact};
pub(crate) use domain::{Domain, Edges};
pub(crate) use exact::parts::{Parted, parts};
pub(crate) use facts::Fact;
pub(crate) use findings::{BesideVelocities, ConstrainedFindings, Derived, FieldFindings, Findings, Measure, Source};
pub(crate) use flow::flow;
pub(crate) use forced_contact::{ForcedContact, forced_contact};
pub(crate) use implicit::MOST_UNKNOWNS;
pub(crate) use jet::JetKernel;
pub(crate) use poles::{Angles, Jumps, Margin, Margins, Poles, Signs};
pub(crate) use proof::flow::{Constant, Flow, Named, Origin};
pub(crate) use proof::liouville::{Liouville, Multiplier, Recovered, liouville};
pub(crate) use system::{
    BodyKernels, Collocation, ConstraintKernels, ContactStages, Decay, FieldKernels, FlowKernel, GradientKick, Inner,
    Integrals, KeptMomentum, Kernels, KickDrift, Lagrangian, MassKernels, Missing, MixedDerivatives, Modified,
    NamedFunction, OfEnergy, Pair, Perturbed, PieceKernel, PiecesOf, Shift, StageKernel, StepKernel, System, Turn,
    Undamped, VelocityKernels, VelocityStages,
};
pub(crate) use velocities::{LagrangianOfVelocities, velocities};
