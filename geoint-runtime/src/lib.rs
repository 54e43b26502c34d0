//! Geometric integrators for energies written as ordinary Rust functions.
#![cfg_attr(not(feature = "std"), no_std)]

pub mod array;
mod real;
pub mod slope;
mod state;
mod error;
pub mod method;
pub mod system;
mod linear;
mod newton;
pub mod splitting;
pub mod composition;
mod tables;
mod tableau;
mod gauss;
mod discrete_gradient;
mod explicit;
mod integrator;
#[doc(hidden)]
pub mod private;

pub use nalgebra;
pub use geoint_macros::hamiltonian;
pub use error::StepError;
pub use real::Real;
pub use state::{Coordinates, State};
pub use integrator::{Integrator, Samples};
pub use method::{Claims, Method};
pub use splitting::{PositionVerlet, Splitting, StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint, Nystrom};
pub use composition::{Composed, Composition, SymmetricMap};
pub use discrete_gradient::DiscreteGradient;
pub use explicit::ExplicitEuler;
pub use gauss::{Gauss, ImplicitMidpoint};
pub use system::{Hamiltonian, QuadraticKinetic, Separable};
pub use tables::*;

/// Everything a program needs.
pub mod prelude {
    pub use crate::tables::*;
    pub use crate::{
        DiscreteGradient, ExplicitEuler, Gauss, Hamiltonian, ImplicitMidpoint, Integrator, PositionVerlet, State, StepError,
        StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint, hamiltonian,
    };
}
