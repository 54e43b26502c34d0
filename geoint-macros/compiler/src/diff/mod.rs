//! Derivatives on the graph: gradients, Jacobians, divided differences and Taylor series, and the equations of motion and of steps built from them.

// In reading order.
mod rules;
mod forward;
mod sweep;
mod slope;
mod gradient;
mod force_gradient;
pub(crate) mod equations;
pub(crate) mod field;
pub(crate) mod flow;
pub(crate) mod contact;
pub(crate) mod constraint;
pub(crate) mod lagrangian;
pub(crate) mod modified;
pub(crate) mod by_velocities;
pub(crate) mod jet;

pub(crate) use force_gradient::gradient_kick;
pub(crate) use forward::{along, blocks, derivative_along, jacobian};
pub(crate) use gradient::{Gradient, discrete_gradient, gradient, increment, mean_rate, partial};
pub(crate) use slope::{end, middle};
