//! The kernels of implicit steps, by the form in which a system is solved.
//!
//! The macros choose the kernels of a system, and with them the steps of `Gauss` and `DiscreteGradient`. A kernel computes the terms of the equation of a
//! step, and their derivatives:
//!
//! | system | kernels of stages, of discrete gradients | unknown |
//! |---|---|---|
//! | energies and fields | `Collocation`, `DiscreteField` | values of the field, increments |
//! | contact Hamiltonians | `ContactStages`, `ContactEquation` | increments |
//! | Lagrangians without a short formula for the energy, with or without an action s | `VelocityForm`, `PolarisedForm` | velocities, and s |
//! | Lagrangians linear in the velocities, with canonical coordinates y(x) | `CanonicalForm`, `DiscreteField` | points x, increments |
//! | energies with constraints | none, `ConstrainedStep` | increments and multipliers |
//!
//! A Lagrangian with a short formula for its energy has the kernels of that energy. If it has an action and is quadratic in v, its stages still have
//! `VelocityForm`. The steps themselves are in the module `method`, and the iterations in the module `solving`.
//!
//! Limit: a system has only the forms that the macros can derive. A method that needs another form is a type error for this system.

mod canonical; // Systems that are canonical in other coordinates y(x) than their own. The stages are solved for x itself.
mod constraints; // Positions on g(q) = 0: the check of a state, the equation of a step, and the projection onto the constraints.
mod fields; // z' = f(z, t), or q'' = M⁻¹f(q, t): stages and discrete gradients, also those of contact Hamiltonians.
mod kept; // The invariants that discrete gradient steps keep.
mod mass; // The mass matrix of a Lagrangian, and v from p = ∂L/∂v.
mod regular; // Check that the mass matrix of a Lagrangian stays regular during a run.
mod velocities; // Lagrangians that are solved for velocities.

pub use canonical::CanonicalForm;
pub(crate) use constraints::{At, held, on_one_side, projected, tangent};
pub use constraints::{Constrained, ConstrainedStep, Gradients, Unmet, unmet};
pub use fields::{
    Collocation, ContactStages, DiscreteField, EquationOrder, FourthOrderField, Mean, QuadraticField, Span,
};
pub use kept::Keeping;
pub(crate) use kept::KeptBy;
pub use mass::{MassForm, energy_of, own_momentum, velocity_of};
pub(crate) use mass::{mass_units, row_scale, row_units, velocity_near};
pub(crate) use regular::Regular;
pub use regular::singular_mass;
pub(crate) use velocities::rates_of_velocity;
pub use velocities::{MixedDerivatives, PolarisedForm, VelocityForm, VelocityStage, contact_gradient_of, rate_of};
