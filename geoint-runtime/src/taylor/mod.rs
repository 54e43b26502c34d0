//! Taylor series: recurrences of coefficients, order and length of a step, polynomials and their roots.

mod estimate;
pub(crate) mod method;
mod polynomial;
mod reach;
pub(crate) mod recurrence;
mod roots;

pub(crate) use estimate::Estimate;
pub(crate) use method::TaylorMethod;
pub use method::{Steps, Taylor, TaylorFixed, TaylorOrder};
pub(crate) use polynomial::{in_parts, increment, increments, rate, shift};
pub(crate) use reach::reach;
pub(crate) use roots::{MOST, Roots, roots};
