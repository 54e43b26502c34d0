//! Equations of implicit steps: how they are solved, and when a solution is one.

mod damped;
pub(crate) mod equation;
mod inverse;
pub(crate) mod linear;
#[cfg(test)]
mod linear_tests;
pub(crate) mod newton;
pub(crate) mod noise;
mod planar;
pub(crate) mod quasi_newton;
mod refusal;
pub(crate) mod roughness;
pub(crate) mod rounding;
pub(crate) mod segment;
mod semidefinite;
pub(crate) mod size;

pub use inverse::{Inverse, Inverted};
pub use planar::planar_step;
pub use refusal::Refusal;
pub use semidefinite::is_positive_semidefinite;
