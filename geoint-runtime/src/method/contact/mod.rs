//! Dissipative and driven systems: the systems of `#[contact_hamiltonian]`, and their methods.
//!
//! H(q, p, s, t) defines the flow q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H (A. Bravetti, H. Cruz & D. Tapias, Ann. Phys. 376 (2017) 17). The
//! action s is one number. The flow multiplies the contact form ds − p dq by a positive factor. A contact map is a map with this property. All methods here
//! are contact maps, except [`ContactDiscreteGradient`], which keeps the decay law of H instead: H' = −H ∂H/∂s if H does not read time.
//!
//! ```
//! use geoint_runtime::methods::*;
//! use geoint_runtime::prelude::*;
//!
//! /// A pendulum in a viscous medium; q in rad, p in kg m²/s.
//! #[contact_hamiltonian]
//! fn damped_pendulum(q: f64, p: f64, s: f64, m: f64, l: f64, g: f64, gamma: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos() + gamma * s
//! }
//!
//! let system = DampedPendulum { m: 0.7, l: 1.2, g: 9.81, gamma: 0.3 };
//! let start = ContactState::new(2.0, 0.0, 0.0);
//! // Explicit: the exact flows of two pieces, here composed to order 4.
//! let mut splitting = system.integrator(Suzuki4.of(ContactSplitting), 0.02, start);
//! // Implicit: H decays as in the flow, H₁ = H₀ e^(−γh), to rounding.
//! let mut gradient = system.integrator(ContactDiscreteGradient, 0.02, start);
//! let energy = gradient.energy();
//! splitting.advance(500)?;
//! gradient.advance(500)?;
//! assert!((gradient.energy() / (energy * (-0.3_f64 * 10.0).exp()) - 1.0).abs() < 1e-12);
//! assert!((splitting.state().q - gradient.state().q).abs() < 1e-2);
//! # Ok::<(), StepError>(())
//! ```

mod discrete_gradient;
pub(crate) mod gauss;
pub(crate) mod implicit;
mod leapfrog;
mod midpoint;

pub use discrete_gradient::ContactDiscreteGradient;
pub use gauss::ContactGauss;
pub(crate) use gauss::SolvedByContactGauss;
pub use leapfrog::{ContactLeapfrog, ExplicitLeapfrog};
pub use midpoint::ContactMidpoint;
