//! What implicit methods solve: by a field, by canonical coordinates, by velocities, with an action or without, with constraints.

mod canonical;
mod constraints;
mod contact;
mod fields;
mod forms;
mod regular;
mod velocities;

pub use canonical::CanonicalForm;
pub use constraints::{Constrained, ConstrainedStep, Gradients, Unmet, unmet};
pub(crate) use constraints::{held, on_one_side, projected, tangent};
pub use contact::{ContactPolarised, ContactStage, ContactVelocities, contact_gradient_of};
pub use fields::{Collocation, ContactStages, DiscreteField, FourthOrderField, Mean, QuadraticField, Span};
pub(crate) use forms::KeptBy;
pub use forms::{
    ByCanonical, ByConstraint, ByField, ByPolarisation, ByTree, ByVelocities, Collocated, ContactCollocated,
    ContactGraded, Graded,
};
pub(crate) use regular::Regular;
pub use velocities::{MassForm, PolarisedForm, VelocityForm, energy_of, rate_of, velocity_of};
pub(crate) use velocities::{acceleration, row_scale, velocity_near};
