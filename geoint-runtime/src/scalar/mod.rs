//! The scalar of every kernel.

mod floats;
mod real;

pub use real::Real;
pub(crate) use real::{signed, zero};
