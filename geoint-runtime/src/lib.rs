//! Geometric integrators for energies written as ordinary Rust functions.
//!
//! Write an energy, put [`#[hamiltonian]`](hamiltonian) above it, and you have a system. The attribute differentiates the
//! function symbolically at compile time, proves what structure it has, and emits kernels for exactly that structure; this
//! crate composes them into methods that keep what the flow keeps.
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
//! assert!((sim.energy() - start).abs() < 2e-12);
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Conventions
//!
//! - **q' = ∂H/∂p, p' = −∂H/∂q**. Coordinates always come in the order q, p, t, and as named fields.
//! - A *kick* of length h is the flow of V(q, t): p ← p − h ∂V/∂q. A *drift* is the flow of T(p, t): q ← q + h ∂T/∂p.
//! - `h` may be negative. Time is `t0 + n·h`, never a running sum; output never changes the step.
//!   With [`Adaptive`] it is a compensated sum, and the last step ends at the time asked for.
//! - Division by something known before the loop becomes multiplication by its reciprocal (about one rounding), and
//!   `a·b + c` is fused where the processor of the build does that; the feature `strict-math` forbids the latter.
//!
//! # What a method needs
//!
//! What was proven of a system are traits: [`Separable`], [`QuadraticKinetic`]. A method asks for the traits that it
//! needs, so that a method which would silently be wrong for a system is a type error, whose message names the term that is
//! in the way. What was derived can be read in the docs of the generated struct and in its constant `REPORT`.
//!
//! # Map of the crate
//!
//! [`State`] is a point, [`Integrator`] a system under a method. Methods: tables of kicks and drifts ([`Splitting`],
//! [`Nystrom`]), compositions of symmetric maps ([`Composition`]), [`Gauss`] collocation and [`ImplicitMidpoint`],
//! [`DiscreteGradient`] and others that keep the energy, [`Kahan`]; explicit [`RungeKutta`] methods, and [`Projection`] and
//! [`Relaxation`] that make any method keep the energy. [`Adaptive`] is an [`Integrator`] that chooses its steps. Methods of
//! one's own implement [`method::Method`]; systems written by hand implement the traits of
//! [`system`].

#![cfg_attr(not(feature = "std"), no_std)]

pub mod real;
pub mod array;
pub mod slope;
pub mod state;
pub mod error;
pub mod point;
pub mod method;
pub mod system;
mod damped;
mod damping;
mod linear;
mod newton;
mod quasi_newton;
mod predictor;
mod stagnation;
pub mod kicks;
mod field;
pub mod splitting;
pub mod composition;
mod tables;
pub mod tableau;
pub mod gauss;
pub mod discrete_gradient;
pub mod kahan;
pub mod contact;
pub mod explicit;
pub mod runge_kutta;
pub mod invariants;
pub mod projection;
pub mod relaxation;
pub mod integrator;
mod step_size;
pub mod adaptive;
#[doc(hidden)]
pub mod private;

#[doc(inline)]
pub use adaptive::Adaptive;
#[doc(inline)]
pub use composition::{Composed, Composition};
#[doc(inline)]
pub use contact::{
    Conformal, Contact, ContactDiscreteGradient, ContactLeapfrog, ContactMidpoint, ContactSplitting, Mechanical,
    PieceComposition, Pieces,
};
#[doc(inline)]
pub use discrete_gradient::{
    CoordinateIncrement, DiscreteGradient, FourthOrder, Gonzalez, ItohAbe, ItohAbeAdjoint, ItohAbePair, MeanValue,
    SymmetrisedItohAbe,
};
#[doc(inline)]
pub use error::{Reason, StepError};
#[doc(inline)]
pub use explicit::ExplicitEuler;
#[doc(inline)]
pub use gauss::{Gauss, ImplicitMidpoint};
pub use geoint_macros::{contact_hamiltonian, hamiltonian};
#[doc(inline)]
pub use integrator::Integrator;
#[doc(inline)]
pub use invariants::{Energy, Invariants};
#[doc(inline)]
pub use kahan::Kahan;
#[doc(inline)]
pub use method::{Claims, Method};
pub use nalgebra;
#[doc(inline)]
pub use projection::Projection;
#[doc(inline)]
pub use real::Real;
#[doc(inline)]
pub use relaxation::Relaxation;
#[doc(inline)]
pub use runge_kutta::{DOP853, RK4, RungeKutta};
#[doc(inline)]
pub use splitting::{Nystrom, PositionVerlet, Splitting, StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint};
#[doc(inline)]
pub use state::{ContactState, Coordinates, State};
#[doc(inline)]
pub use system::{
    Autonomous, Conservative, ForceGradient, Hamiltonian, ModifiedEnergy, PhaseSpace, QuadraticKinetic, Separable,
};
pub use tables::*;

/// Everything that a program needs.
pub mod prelude {
    pub use crate::tables::*;
    pub use crate::{
        Adaptive, ContactDiscreteGradient, ContactLeapfrog, ContactMidpoint, ContactSplitting, ContactState,
        CoordinateIncrement, DOP853, DiscreteGradient, Energy, ExplicitEuler, FourthOrder, Gauss, Gonzalez,
        Hamiltonian, ImplicitMidpoint, Integrator, ItohAbe, ItohAbeAdjoint, ItohAbePair, Kahan, MeanValue, Method,
        PhaseSpace, PositionVerlet, Projection, RK4, Relaxation, State, StepError, StormerVerlet, SymmetrisedItohAbe,
        SymplecticEuler, SymplecticEulerAdjoint, contact_hamiltonian, hamiltonian,
    };
}
