//! Splitting methods: flows of the parts of an energy in alternation, with one driver for all of them.
//!
//! The parts are T and V, or A and B in coordinates of their own ([`perturbed`]), or any number of pieces ([`pieces`]).
//!
//! For H = T + V, a table lists the fractions of h for the flows of T and V, in order of application. There are two clocks. A kick reads
//! the time that the drifts have reached, and a drift reads the time that the kicks have reached. In the phase space
//! extended by both clocks, kicks and drifts are exact flows. Every table therefore keeps its order if T or V depends on
//! time.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Two masses on springs that harden.
//! #[hamiltonian]
//! fn springs(q: [f64; 2], p: [f64; 2], m: [f64; 2], k: f64) -> f64 {
//!     let stretch = q[1] - q[0];
//!     p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + k * (stretch.powi(2) / 2.0 + stretch.powi(4) / 4.0)
//! }
//!
//! let system = Springs { m: [0.5, 2.0], k: 3.0 };
//! let start = State::new([0.0, 1.0], [0.2, -0.1]);
//! // Energy errors do not grow with time. Order 4 has far smaller errors for the same number of forces.
//! let mut verlet = system.integrator(StormerVerlet, 0.01, start);
//! let mut fourth = system.integrator(BlanesMoan4, 0.06, start);
//! let energy = verlet.energy();
//! verlet.advance(60_000)?;
//! fourth.advance(10_000)?;
//! assert!((verlet.energy() / energy - 1.0).abs() < 1e-3);
//! assert!((fourth.energy() / energy - 1.0).abs() < 1e-5);
//! # Ok::<(), StepError>(())
//! ```
//!
//! A table of your own is a constant, which the compiler checks: see [`Splitting`].

mod delegate;
mod driver;
mod estimators;
mod field;
mod kinds;
mod last_kick;
mod nystrom;
mod open;
mod operation;
pub mod perturbed;
pub mod pieces;
mod processed;
mod sequence;
mod splitting;
mod table;
mod verlet;

pub(in crate::method) use delegate::{delegate, steps_of};
pub use estimators::Estimators;
pub(in crate::method) use estimators::Mirrored;
pub use field::{gradient_kick, modified_verlet};
pub use kinds::{KickAndDrift, KickAndRotations, SomeKick, WithGradient};
pub use last_kick::LastKick;
pub use nystrom::{DriftFirst, KickFirst, Nystrom};
pub use open::Open;
pub use operation::Operation;
pub use processed::ProcessedSplitting;
pub use sequence::Sequence;
pub use table::{Flow, Splitting};
pub use verlet::{FiveRotations, PositionVerlet, StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint};

use crate::space::PerCoordinate;
use crate::system::PhaseSpace;

/// The coordinates of a system, or their increments.
pub(crate) type Coordinates<S, R> = PerCoordinate<<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action>;
