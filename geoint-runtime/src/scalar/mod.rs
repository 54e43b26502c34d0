//! Scalars: the trait [`Real`], its implementations, and intervals for proofs.

mod real;
mod floats;
mod four;
mod interval;
mod enclosure;
mod exact;
mod series;

pub(crate) use enclosure::{Enclosure, bounds};
pub(crate) use exact::{exact_product, exact_sum, halves, sum_with_small};
pub(crate) use interval::Interval;
pub use real::{Four, Real};
pub(crate) use real::{signed, zero};
pub use series::Series;
