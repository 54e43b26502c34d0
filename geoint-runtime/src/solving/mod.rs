//! Solution of the equations of implicit steps.
//!
//! - A step states r(x) = 0 as a [`StepEquation`](equation::StepEquation). `newton` solves it in a few evaluations, with guesses of the `predictor` and the `experience`
//!   of earlier steps.
//! - `rescue` solves equations that take more: with many corrections, `damped` corrections, and a measurement of the `noise` of the residual. `branch` decides whether
//!   the solution is the one that is continuous in h. These files see an equation behind pointers (`distant`).
//! - `rounding` decides when corrections are rounding, relative to the `size` of each unknown. `linear` and `inverse` solve small linear systems.
//! - `quasi_newton` solves equations whose derivative is known approximately.

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
mod predictor;
pub(crate) mod quasi_newton;
mod refusal;
pub(crate) mod rescue;
pub(crate) mod rounding;
pub(crate) mod size;

pub use equation::{Effort, Observer};
pub use inverse::{Inverse, Inverted};
pub use refusal::Refusal;
