//! Explicit methods that keep nothing by themselves.

mod euler;
pub mod runge_kutta;

pub use euler::ExplicitEuler;
pub use runge_kutta::{DOP853, RK4, RungeKutta};
