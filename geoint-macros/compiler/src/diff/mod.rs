//! Derivations on the graph: gradient, Hessian, divided differences, and the field of implicit methods.

pub(crate) mod by_velocities;
pub(crate) mod constraint;
pub(crate) mod contact;
pub(crate) mod field;
pub(crate) mod flow;
pub(crate) mod jet;
pub(crate) mod lagrangian;
mod force_gradient;
mod forward;
pub(crate) mod modified;
mod rules;
mod slope;
mod sweep;
mod gradient;
mod rate;

pub(crate) use force_gradient::gradient_kick;
pub(crate) use forward::{along, jacobian};
pub(crate) use gradient::{Gradient, discrete_gradient, gradient, increment, mean_rate, partial};
pub(crate) use rate::derivative_along;
