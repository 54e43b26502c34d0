//! Steps along a discrete gradient, x₁ = x₀ + h J ∇̄H(x₀, x₁). Accepted steps keep the energy H to rounding, for every step size h. The exception is
//! [`MeanValue`], whose ∇̄H is a discrete gradient only if its integral is exact.
//!
//! Here x = (q, p) and J(q, p) = (p, −q). A discrete gradient ∇̄H satisfies ∇̄H·(x₁ − x₀) = H(x₁) − H(x₀), and tends to ∇H if x₁ tends to x₀
//! (O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449). J is skew, so the energy is kept: H(x₁) − H(x₀) = h ∇̄H·J∇̄H = 0.
//!
//! The method [`DiscreteGradient`] is the usual choice. It has the fewest unknowns. It is the only method here for damped systems: J − C replaces J for a
//! damping matrix C, and H changes by −h ∇̄H·C∇̄H. For vector fields with named invariants (`keeps(name = expression)`), `DiscreteGradient` and
//! `FourthOrder(DiscreteGradient)` keep these in place of H.
//!
//! | method | order | symmetric | unknowns | reason to choose it |
//! |---|---|---|---|---|
//! | [`DiscreteGradient`] | 2 | yes | n or 2n | lowest cost; momenta that the report names; damping; constraints |
//! | [`FourthOrder`]`(DiscreteGradient)` | 4 | yes | 2n | accurate positions |
//! | [`MeanValue`]`::<K>` | 2 | yes | 2n | averaged vector field of the literature |
//! | [`Gonzalez`] | 2 | yes | 2n | midpoint discrete gradient of the literature |
//! | [`ItohAbePair`] | 2 | yes | 2n, in each of two steps of h/2 | symmetric form of `ItohAbe` with the smaller error |
//! | [`SymmetrisedItohAbe`] | 2 | yes | 2n | symmetric form of `ItohAbe` with one solve |
//! | [`ItohAbe`], [`ItohAbeAdjoint`], [`CoordinateIncrement`] | 1 | no | 2n | comparison with the literature |
//! | `FourthOrder` of `Gonzalez`, `MeanValue` or `SymmetrisedItohAbe` | 4 | yes | 2n | comparison with the literature |
//!
//! Orders and symmetries hold for every H, and n is the number of degrees of freedom. `DiscreteGradient` has n unknowns if H = T(p) + V(q) with a quadratic T
//! and without damping. [Energy kept exactly](crate::guide::_07_energy) compares errors and times.
//!
//! Limits: steps are not symplectic in general. An energy that reads time is not constant. A step of order 1 or 2 freezes time in its middle, and keeps
//! H(·, t + h/2). Steps of order 4 do not.
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
//!     // H and its tree discrete gradient read differences of positions only. The entries of ∇̄H for q add up to 0, so Σp is kept as well.
//!     assert!((sim.state().p.iter().sum::<f64>() - momentum).abs() < 1e-13);
//! }
//! # Ok::<(), StepError>(())
//! ```

#[doc(hidden)]
pub(crate) mod canonical;
mod columns;
mod coordinate_increment;
mod energy;
mod fourth_order;
pub(crate) mod gonzalez;
mod itoh_abe;
mod matrix;
pub(crate) mod mean;
mod mean_value;
mod methods;
pub(crate) mod polarised;
mod projected;
pub(crate) mod tree;

pub use coordinate_increment::CoordinateIncrement;
pub use energy::{Energy, Slope, Staircase};
pub use fourth_order::FourthOrder;
pub use gonzalez::Gonzalez;
pub use itoh_abe::{ItohAbe, ItohAbeAdjoint, ItohAbePair, SymmetrisedItohAbe};
pub use matrix::Matrix;
pub use mean_value::MeanValue;
pub use tree::DiscreteGradient;
