//! What implicit methods solve: by a field, by canonical coordinates, by velocities, with constraints.

mod canonical;
mod constraints;
mod fields;
mod forms;
mod velocities;

pub use canonical::CanonicalForm;
pub use constraints::{Constrained, ConstrainedStep, Gradients, Unmet, unmet};
pub(crate) use constraints::{on_one_side, projected, tangent};
pub use fields::{Collocation, DiscreteField, Mean, QuadraticField};
pub use forms::{ByCanonical, ByConstraint, ByField, ByPolarisation, ByTree, ByVelocities, Collocated, Graded};
pub(crate) use velocities::{Orientation, acceleration, row_scale, velocity_near};
pub use velocities::{PolarisedForm, VelocityForm, energy_of, rate_of, velocity_of};
