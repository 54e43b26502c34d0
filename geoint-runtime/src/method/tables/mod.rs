//! The tables of coefficients: fractions of h in order of application. Palindromes are given by their first half.
//!
//! Fractions have about fifty digits, and coefficients of error estimates 25. The compiler rounds each number once, to `f64`, also for wider scalars. "Free
//! parameters" is the number of parameters that the order conditions do not determine. Their values are those of the source, taken as exact. All further digits
//! of such a table follow from the order conditions.
//!
//! Names have the authors and the order. Then follow the number of stages, or for H = A + εB further orders, and letters of the source.

// Constants have names like types, because methods are values: `system.integrator(BlanesMoan4, …)`.
#![allow(non_upper_case_globals)]
#![allow(clippy::excessive_precision, reason = "all digits that are known, rounded once")]

mod composition;
mod force_gradient;
pub(crate) mod gauss;
mod near_integrable;
mod nystrom;
mod pieces;
mod splitting;
pub(crate) mod total;

pub use composition::{KahanLi8_17a, McLachlan4, McLachlan6_9, SofroniouSpaletta10_35, Suzuki4, Yoshida4, Yoshida6a};
pub use force_gradient::{
    BlanesCasasRos6, Chin4A, Chin4B, Chin4C, Chin4D, Omelyan4_4F2GV, Omelyan4_5F2GP, Omelyan6_5F3GP, Omelyan6_5F4GV,
    Omelyan8_11F11GP, TakahashiImada2,
};
pub use near_integrable::{
    Aba8_4, Aba8_6_4, Aba10_6_4, Rnia10_8_6, Saba2Gradient, Saba3Gradient, Saba4, Saba4Gradient, Saba5Gradient,
    WisdomHolman, WisdomHolmanGradient, WisdomHolmanProcessed,
};
pub use nystrom::{BceRkn17_8, BceRkn19_8, BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a};
pub use pieces::{BlanesMoan4X, BlanesMoan6X};
pub use splitting::{BlanesMoan4, BlanesMoan6, ForestRuth4, PEFRL};
