//! Taylor series: recurrences of coefficients, order and length of a step, polynomials and their roots.

mod estimate;
mod method;
mod polynomial;
mod reach;
pub mod recurrence;
mod roots;

pub(crate) use estimate::Estimate;
pub use method::{Steps, Taylor, TaylorFixed, TaylorMethod, TaylorOrder};
pub(crate) use polynomial::{in_parts, increment, increments, rate, shift};
pub(crate) use reach::reach;
pub(crate) use roots::{MOST, Roots, roots};
