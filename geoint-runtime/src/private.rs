//! What emitted code may name. Not part of the public interface.

pub use crate::array::{Array, Square};
pub use crate::real::Real;
pub use crate::slope;
pub use crate::state::Coordinates;
pub use crate::system::mean_gradient::{Midpoint, Tree};
pub use crate::system::{Collocation, Hamiltonian, MeanGradient, QuadraticKinetic, Separable};
