//! Solves the equation r(x) = 0 of an implicit step of length h, until only rounding errors are left. An evaluation computes r and its derivative J.
//!
//! - `equation` is the interface: a method states r as a [`StepEquation`](equation::StepEquation). A [`Failure`] is the reason why a step has no result.
//! - `newton` solves most equations in at most five evaluations. `predictor` extrapolates a guess of x. `experience` has bounds from earlier steps.
//! - `rescue` solves equations that take more, by searches of up to 100 evaluations. It tries `damped` corrections, and measures the `noise` (rounding) of r.
//!   `branch` tests whether the solution is continuous in h. These searches call r through a pointer (`distant`).
//! - `quasi_newton` solves equations whose J is approximate, by the searches of `rescue`. If they fail, `differences` replaces J by difference quotients.
//! - `rounding` decides whether a correction is rounding, relative to the `size` of each unknown. `linear` and `inverse` solve small linear systems.

mod branch;
mod damped;
mod differences;
mod distant;
pub(crate) mod equation;
mod experience;
mod failure;
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
pub(crate) mod rescue;
pub(crate) mod rounding;
pub(crate) mod size;

pub use equation::{Effort, Observer};
pub use failure::Failure;
pub use inverse::{Inverse, Inverted};
