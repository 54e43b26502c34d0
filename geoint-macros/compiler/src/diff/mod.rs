//! Derivatives on the graph, and the equations that are built from them.
//!
//! - Derivatives at a point: `rules` (one table), `forward` (along a direction, Jacobians), `sweep` and `gradient` (all entries by one reverse sweep).
//! - Divided differences between two points without cancellation: `slope`.
//! - Kicks with a force gradient: `force_gradient`.
//! - Equations of motion of every form: `equations`.
//! - Equations of implicit steps, built from both kinds of derivatives: `field` for (q, p), `flow` for x, `contact`, `constraint`, and `lagrangian` for velocities.
//! - The energy that a symmetric step of order 2 keeps up to h⁴: `modified`.
//! - Forces by velocities in place of momenta: `by_velocities`.
//! - Recurrences of Taylor coefficients: `jet`.
//!
//! All functions accept nodes that are not defined everywhere; `derive/domain` adds the tests. The derivative of a selection selects between the derivatives, so
//! a jump has no derivative.

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
