//! The equations of an implicit step, by the form in which a system is solved.
//!
//! The macros choose the form in which the equations of a system are given, and emit its kernels:
//!
//! | system | form of stages, of discrete gradients | unknown |
//! |---|---|---|
//! | energies and fields | `ByField`, `ByTree` | values of the field, increments |
//! | Lagrangians without a short formula for H | `ByVelocities`, `ByPolarisation` | velocities |
//! | Lagrangians linear in the velocities | `ByCanonical`, `ByTree` | points, which have canonical coordinates y(x) |
//! | energies with constraints | none, `ByConstraint` | increments and multipliers |
//!
//! Contact systems have forms with an action s. The iterations that solve the equations are in the module `solving`, and the methods in the module
//! `method`.
//!
//! Limits: a system has only the forms that the macros can derive. A method that needs another form is a type error for this system.

mod canonical; // Systems that are canonical in other coordinates y(x), such as logarithms. The stages are solved for x itself.
mod constraints; // Positions on g(q) = 0: the check of a state, the equation of a step, and the projection onto the constraints.
mod contact; // Lagrangians with an action: stages and steps are solved for velocities and s.
mod fields; // z' = f(z, t), or q'' = M⁻¹f(q, t): stages and discrete gradients, also those of contact Hamiltonians.
mod forms; // Marker types of the forms. `Collocated` names the form of stages, `Graded` the form of discrete gradients.
mod regular; // Proof that the mass matrix of a Lagrangian stays regular during a run.
mod velocities; // Lagrangians without an action: stages and steps are solved for velocities. Also computes v from p = ∂L/∂v, for all Lagrangians.

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
pub use regular::singular_mass;
pub use velocities::{MassForm, PolarisedForm, VelocityForm, energy_of, own_momentum, rate_of, velocity_of};
pub(crate) use velocities::{acceleration, row_scale, velocity_near};
