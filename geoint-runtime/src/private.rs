//! What emitted code may name. Not part of the public interface.

pub use crate::adaptive::Adaptive;
pub use crate::array::{Array, Square};
pub use crate::contact::{
    Clock as PieceClock, Conformal as ConformalContact, Contact as ContactSystem, ContactDiscreteGradient,
    ContactMidpoint, ImplicitStep, Mechanical as MechanicalContact, Piece as ContactPiece, Pieces as ContactPieces,
};
pub use crate::damping::is_positive_semidefinite;
pub use crate::field::{gradient_kick, modified_verlet};
pub use crate::integrator::Integrator;
pub use crate::method::Method;
pub use crate::real::Real;
pub use crate::slope;
pub use crate::state::{ContactState, State};
pub use crate::system::{
    Autonomous, Collocation, Conservative, Cubic, DiscreteField, ForceGradient, Hamiltonian, Mean, ModifiedEnergy,
    PhaseSpace, QuadraticKinetic, Separable,
};
