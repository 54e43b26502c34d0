//! Derivatives on the graph, and the equations that are built from them. There are two kinds of derivatives: at a point, and as divided differences over a step.
//!
//! - Derivatives at a point: `rules` (the derivative of each operation, in one table), `forward` (one direction, or a Jacobian).
//! - Divided differences between two points, without cancellation: `slope`.
//! - Gradients and discrete gradients: `gradient`. One reverse sweep (`sweep`) computes all entries of either kind; only the rules differ.
//! - Kicks with a force gradient: `force_gradient`.
//! - Equations of motion of every form: `equations`.
//! - Equations of implicit steps, built from both kinds: `field` for (q, p), `flow` for x' = f(x), `entropy` for x' = L ∇E + M ∇S, `contact`, `constraint`,
//!   and `lagrangian` for velocities.
//! - The energy H + h²H₂ that a symmetric splitting of order 2 keeps with an error of O(h⁴): `modified`.
//! - Forces as functions of (q, v) in place of (q, p): `by_velocities`.
//! - Recurrences of Taylor coefficients: `jet`.
//!
//! All functions accept nodes that are not defined everywhere; `derive/domain` adds the tests. The derivative of a selection selects between the derivatives of
//! its branches, so a jump adds nothing to it. `analyze/identity/crossings` finds jumps.

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
pub(crate) mod entropy;
pub(crate) mod contact;
pub(crate) mod constraint;
pub(crate) mod lagrangian;
pub(crate) mod modified;
pub(crate) mod by_velocities;
pub(crate) mod jet;

pub(crate) use force_gradient::gradient_kick;
pub(crate) use forward::{along, blocks, derivative_along, jacobian};
pub(crate) use gradient::{Gradient, discrete_gradient, gradient, increment, mean_rate, partial_derivative};
pub(crate) use slope::{coordinate_at_end, coordinate_in_middle};
