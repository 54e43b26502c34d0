//! Solution of the equations of implicit steps.
//!
//! - A step states r(x) = 0 as a [`StepEquation`](equation::StepEquation). `newton` solves it in a few evaluations, with guesses of the `predictor` and the `experience`
//!   of earlier steps.
//! - `rescue` solves equations that take more: with many corrections, `damped` corrections, and a measurement of the `noise` of the residual. `branch` decides whether
//!   the solution is the one that is continuous in h. These files see an equation behind pointers (`distant`).
//! - `rounding` decides when corrections are rounding, relative to the `size` of each unknown. `linear` and `inverse` solve small linear systems.
//! - `quasi_newton` solves equations whose derivative is known approximately, and `planar` one equation in a plane.
//! - `segment`, `roughness` and `semidefinite` examine functions of numbers: poles on a line, jumps by rounding, signs of matrices.

mod branch;
mod damped;
mod differences;
mod distant;
pub(crate) mod equation;
mod experience;
mod inverse;
pub(crate) mod linear;
#[cfg(test)]
mod linear_tests;
pub(crate) mod newton;
#[cfg(test)]
mod newton_tests;
pub(crate) mod noise;
mod planar;
mod predictor;
pub(crate) mod quasi_newton;
mod refusal;
pub(crate) mod rescue;
pub(crate) mod roughness;
pub(crate) mod rounding;
pub(crate) mod segment;
mod semidefinite;
pub(crate) mod size;

pub use equation::{Effort, Observer};
pub use inverse::{Inverse, Inverted};
pub use planar::planar_step;
pub use refusal::Refusal;
pub use semidefinite::is_positive_semidefinite;
