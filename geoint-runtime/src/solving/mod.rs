//! Solves the equations of implicit steps, r(x) = 0, to rounding.
//!
//! - `equation` has the interface: a method states r as a [`StepEquation`](equation::StepEquation). A [`Refusal`] is the reason why a step has no result.
//! - `newton` solves most equations in at most five evaluations. It uses guesses of the `predictor` and bounds from the `experience` of earlier steps.
//! - `rescue` solves the equations that take more: with up to 100 evaluations, `damped` corrections, and a measurement of the `noise` of r. `branch` decides
//!   whether the solution is the one that is continuous in the step size h. These files reach the equation through a pointer (`distant`).
//! - `quasi_newton` solves equations whose derivative is approximate, by the searches of `rescue`. If they fail, `differences` replaces the derivative by
//!   difference quotients.
//! - `rounding` decides when corrections are rounding, relative to the `size` of each unknown. `linear` and `inverse` solve small linear systems.

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
