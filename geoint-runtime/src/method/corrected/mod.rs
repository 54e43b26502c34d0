//! Corrections after a step of any method: projection onto invariants, and relaxation, which scales the step to keep the energy.
//!
//! ```
//! use geoint_runtime::methods::*;
//! use geoint_runtime::prelude::*;
//!
//! /// Planar pendulum; q in rad, p in kg m²/s.
//! #[hamiltonian]
//! fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! }
//!
//! let system = Pendulum { m: 0.7, l: 1.2, g: 9.81 };
//! let start = State::new(2.0, 0.0);
//! let mut plain = system.integrator(RK4, 0.05, start);
//! let mut projected = system.integrator(Projection(RK4, Energy), 0.05, start);
//! let mut relaxed = system.integrator(Relaxation(RK4), 0.05, start);
//! let energy = plain.energy();
//! plain.advance(10_000)?;
//! projected.advance(10_000)?;
//! relaxed.advance(10_000)?;
//! let error = |now: f64| (now / energy - 1.0).abs();
//! assert!(error(plain.energy()) > 1e-5);
//! assert!(error(projected.energy()) < 1e-12 && error(relaxed.energy()) < 1e-12);
//! # Ok::<(), StepError>(())
//! ```
//!
//! Users implement [`Invariants`] for invariants of their own.

pub(crate) mod basis;
mod frame;
pub mod invariants;
pub(crate) mod kept;
pub mod projection;
pub(crate) mod range;
pub mod relaxation;
mod roughness;
pub(crate) mod rounded;
mod scales;
mod series;
mod turns;
mod way_back;

pub use invariants::{Energy, Integrals, Invariants, Origin};
pub use projection::Projection;
pub use relaxation::Relaxation;
