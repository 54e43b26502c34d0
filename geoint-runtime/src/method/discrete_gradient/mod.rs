//! Steps along a discrete gradient, x₁ = x₀ + h J ∇̄H(x₀, x₁). Accepted steps keep the energy H to rounding, for every step size h.
//!
//! Here x = (q, p) and J(q, p) = (p, −q). A discrete gradient ∇̄H satisfies ∇̄H·(x₁ − x₀) = H(x₁) − H(x₀), and tends to ∇H if x₁ tends to x₀
//! (O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449). J is skew, so the energy is kept: H(x₁) − H(x₀) = h ∇̄H·J∇̄H = 0.
//!
//! [`DiscreteGradient`] is the usual choice. It has the fewest unknowns, and is the only one for damped systems: J − C replaces J for a damping
//! matrix C, and H changes by −h ∇̄H·C∇̄H.
//!
//! Limits: steps are not symplectic in general. [`MeanValue`] keeps the energy only if its integral is exact. An energy that reads time is not
//! constant: steps evaluate it at the time of their middle.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Toda's chain of three particles.
//! #[hamiltonian]
//! fn toda(q: [f64; 3], p: [f64; 3], m: f64) -> f64 {
//!     (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m)
//!         + (q[0] - q[1]).exp() + (q[1] - q[2]).exp() + (q[2] - q[0]).exp()
//! }
//!
//! // Steps of any length keep the energy. Shorter steps improve the trajectory.
//! for h in [0.01, 0.1, 0.5] {
//!     let mut sim = Toda { m: 1.5 }.integrator(DiscreteGradient, h, State::new([0.3, -0.1, 0.0], [0.5, 0.1, -0.2]));
//!     let (energy, momentum) = (sim.energy(), 0.5 + 0.1 - 0.2);
//!     sim.advance(1000)?;
//!     assert!((sim.energy() / energy - 1.0).abs() < 1e-13);
//!     // H reads differences of positions only, so Σp is kept as well.
//!     assert!((sim.state().p.iter().sum::<f64>() - momentum).abs() < 1e-13);
//! }
//! # Ok::<(), StepError>(())
//! ```

#[doc(hidden)]
pub mod canonical;
mod columns;
mod coordinate_increment;
mod energy;
mod fourth_order;
pub(crate) mod gonzalez;
mod itoh_abe;
mod matrix;
mod mean;
mod mean_value;
mod methods;
mod polarised;
mod projected;
mod tree;

pub use coordinate_increment::CoordinateIncrement;
pub use energy::{Energy, Slope, Staircase};
pub use fourth_order::FourthOrder;
pub use gonzalez::Gonzalez;
pub use itoh_abe::{ItohAbe, ItohAbeAdjoint, ItohAbePair, SymmetrisedItohAbe};
pub use matrix::Matrix;
pub use mean::{MeanGradient, MeanStep};
pub use mean_value::MeanValue;
pub use polarised::PolarisedStep;
pub use tree::{DiscreteGradient, TreeStep};
