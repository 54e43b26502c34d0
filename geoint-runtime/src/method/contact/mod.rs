//! Dissipative and driven systems: what `#[contact_hamiltonian]` implements, and the methods for it.
//!
//! H(q, p, s, t) moves q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H. The flow multiplies the form ds − p dq by a factor,
//! and so do all methods here but those that keep the decay of H instead.

mod discrete_gradient;
mod implicit;
mod leapfrog;
mod midpoint;
mod splitting;

pub use discrete_gradient::ContactDiscreteGradient;
pub use leapfrog::ContactLeapfrog;
pub use midpoint::ContactMidpoint;
pub use splitting::{ContactSplitting, PieceComposition};
