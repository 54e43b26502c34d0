//! What emitted code may name. Not part of the public interface.

pub use crate::adaptive::Adaptive;
pub use crate::array::{Array, Square};
pub use crate::damping::is_positive_semidefinite;
pub use crate::integrator::Integrator;
pub use crate::method::Method;
pub use crate::real::Real;
pub use crate::slope;
pub use crate::state::State;
pub use crate::system::{
    Autonomous, Collocation, Conservative, Cubic, DiscreteField, Hamiltonian, Mean, QuadraticKinetic, Separable,
};
