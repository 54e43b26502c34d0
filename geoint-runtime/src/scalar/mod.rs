//! The scalar of every kernel.

mod real;
mod floats;
mod interval;
mod enclosure;
mod series;

pub(crate) use enclosure::{Enclosure, bounds};
pub(crate) use interval::Interval;
pub use real::Real;
pub(crate) use real::{signed, zero};
pub use series::Series;
