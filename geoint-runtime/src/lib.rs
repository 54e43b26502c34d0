//! Geometric integrators for energies written as ordinary Rust functions.
//!
//! Write an energy and put an attribute above it. The attribute differentiates the function at compile time, proves its structure, and writes integrators for
//! this system.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Planar pendulum; q in rad, p in kg m²/s.
//! #[hamiltonian]
//! fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! }
//!
//! let system = Pendulum { m: 1.0, l: 1.0, g: 9.81 };
//! let mut sim = system.integrator(DiscreteGradient, 0.01, State::new(2.0, 0.0));
//! let start = sim.energy();
//! sim.advance(100_000)?;
//! assert!((sim.energy() - start).abs() < 1e-13);
//! # Ok::<(), StepError>(())
//! ```
//!
//! | your question | page |
//! |---|---|
//! | How do I start? | [first picture](guide::_01_first_picture) |
//! | Which attribute fits my variables? | [`hamiltonian`], [`lagrangian`], [`contact_hamiltonian`], [`vector_field`]: [which attribute](guide::_02_which_attribute) |
//! | Which method, and which step size? | [which method](guide::_03_which_method), [a run in practice](guide::_06_runs) |
//! | Planets? Mechanisms? Friction? Rigid bodies? Games? | [planets](guide::_09_planets), [mechanisms](guide::_10_mechanisms), [friction](guide::_08_friction), [fields and bodies](guide::_11_fields), [real time](guide::_13_real_time) |
//! | Events, Poincaré sections, output at given times? | [events](guide::_12_events) |
//! | How large may my problem be? | [limits](guide::_18_limits), [systems written by hand](guide::_14_by_hand) |
//! | I know another library. | [coming from](guide::_15_coming_from) |
//! | Which methods exist? | [`method`], with a table of all; `use geoint_runtime::methods::*` imports them |
//! | A message stops me. | [errors and remedies](guide::_16_errors) |
//!
//! The [guide] has nineteen pages.
//!
//! # Conventions
//!
//! - Equations of motion: q' = ∂H/∂p and p' = −∂H/∂q. Coordinates come in the order q, p, s (contact systems only), t.
//! - Contact systems describe friction by an auxiliary variable s: q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.
//! - A *kick* of length h is the flow of V(q, t), p ← p − h ∂V/∂q. A *drift* is the flow of T(p, t), q ← q + h ∂T/∂p.
//! - The step size h may be negative. The time of fixed steps is t₀ + n·h, without a running sum. `sampled_every`, `sampled_at` and `crossings` do not
//!   change the steps. `until_event` ends the run at the event: its time becomes the new t₀, and n starts at 0.
//! - Single steps give the same bits as many steps in one call.
//! - Division by a value that is known before the loop becomes multiplication by its reciprocal. `a·b + c` is fused if the build targets a processor that
//!   supports it; the last bits then differ between machines. The feature `strict-math` forbids this.
//!
//! # Map of the crate
//!
//! - A point is a [`State`], [`ContactState`], [`FlowState`] or [`BodyState`].
//! - A run is an [`Integrator`] with fixed steps, an [`Adaptive`] one, or a [`TaylorIntegrator`]. The traits [`Trajectory`] and
//!   [`Dense`] give their steps, states between steps, sections and events. With the feature `alloc` runs can be saved: [`running::Resumable`].
//! - Traits in [`system`] describe proven structure, for instance [`Separable`]. A method asks for the traits that it needs. Systems written by hand implement
//!   these traits.
//! - [`Method`] is the trait of methods. [`Claims`] states the order and the invariants of a method.
//! - Numbers are `f64` or `f32`: write `f32` in the arguments of the energy. Without the feature `std` the crate needs no standard library.

#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(any(feature = "alloc", test))]
extern crate alloc;

mod ablation;

/// Only this crate implements traits with the supertrait `Sealed`. Later versions can therefore add items to these traits.
mod sealed {
    /// Implemented in this crate only.
    pub trait Sealed {}
}

pub mod scalar;
pub mod space;
mod slope;
mod solving;
pub mod system;
pub mod taylor;
pub mod method;
pub mod methods;
pub mod running;
#[cfg(any(doc, doctest))]
pub mod guide;
#[doc(hidden)]
pub mod private;

pub use geoint_macros::{contact_hamiltonian, energy_function, hamiltonian, lagrangian, vector_field};
#[doc(inline)]
pub use method::{Claims, Failure, Method};
pub use methods::*;
pub use nalgebra;
#[doc(inline)]
pub use running::{
    Adaptive, Crossing, Dense, Direction, Integrator, IntoIntegrator, StepError, TaylorIntegrator, Trajectory,
};
#[doc(inline)]
pub use scalar::Real;
#[doc(inline)]
pub use space::{BodyState, ContactState, Coordinates, FlowState, State};
#[doc(inline)]
pub use system::{
    Autonomous, Conformal, Conservative, Constrained, Contact, Cotangent, FirstIntegrals, ForceGradient, Hamiltonian,
    Invariants, KeepsEnergy, Lagrangian, Mechanical, Origin, Perturbed, PerturbedGradient, PhaseSpace, Pieces,
    PrincipalAxes, QuadraticKinetic, Rates, Separable, SteadyIntegrals, VectorField,
};

/// The names that most programs need, for `use geoint_runtime::prelude::*`: attributes, states, runs with their traits, and the methods that are used most.
///
/// All methods are in [`methods`].
pub mod prelude {
    #[cfg(feature = "alloc")]
    pub use crate::running::Resumable;
    pub use crate::{
        Adaptive, BlanesMoan4, BlanesMoanSrkn14a, BodyState, ContactSplitting, ContactState, DOP853, Dense, Direction,
        DiscreteGradient, Failure, FlowState, FourthOrder, Gauss, Hamiltonian, ImplicitMidpoint, Integrator,
        IntoIntegrator, Method, PhaseSpace, RK4, Real, State, StepError, StormerVerlet, Suzuki4, Taylor,
        TaylorIntegrator, Trajectory, contact_hamiltonian, energy_function, hamiltonian, lagrangian, vector_field,
    };
}

/// The programs of the README compile and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
