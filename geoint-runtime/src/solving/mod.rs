//! Equations of implicit steps: how they are solved, and when a solution is one.

mod damped;
pub(crate) mod equation;
mod inverse;
pub(crate) mod linear;
pub(crate) mod newton;
mod noise;
mod planar;
pub(crate) mod quasi_newton;
mod refusal;
pub(crate) mod rounding;
pub(crate) mod segment;
mod semidefinite;
pub(crate) mod size;

pub use inverse::{Inverse, Inverted};
pub use planar::planar_step;
pub use refusal::Refusal;
pub use semidefinite::is_positive_semidefinite;

/// What is seldom done, and does not depend on the shape of the unknowns, is compiled with this crate. Programs take it from here, since it is
/// never inlined. These are its addresses, because only what somebody names is compiled.
#[inline(never)]
pub fn compiled() -> [[*const (); 2]; 2] {
    [noise::compiled::<f64>(), noise::compiled::<f32>()]
}
