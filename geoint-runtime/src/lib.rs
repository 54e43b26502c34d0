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

pub mod scalar;
pub mod space;
pub mod slope;
mod solving;
pub mod system;
pub mod method;
pub mod running;
#[doc(hidden)]
pub mod private;

pub use geoint_macros::{contact_hamiltonian, hamiltonian};
#[doc(inline)]
pub use method::composition::{Composed, Composition};
#[doc(inline)]
pub use method::contact::{
    ContactDiscreteGradient, ContactLeapfrog, ContactMidpoint, ContactSplitting, PieceComposition,
};
#[doc(inline)]
pub use method::corrected::{Energy, Invariants, Projection, Relaxation};
#[doc(inline)]
pub use method::discrete_gradient::{
    CoordinateIncrement, DiscreteGradient, FourthOrder, Gonzalez, ItohAbe, ItohAbeAdjoint, ItohAbePair, MeanValue,
    SymmetrisedItohAbe,
};
#[doc(inline)]
pub use method::explicit::{DOP853, ExplicitEuler, RK4, RungeKutta};
#[doc(inline)]
pub use method::gauss::{Gauss, ImplicitMidpoint};
#[doc(inline)]
pub use method::kahan::Kahan;
#[doc(inline)]
pub use method::splitting::{
    Nystrom, PositionVerlet, Splitting, StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint,
};
pub use method::tables::*;
#[doc(inline)]
pub use method::{Claims, Method};
pub use nalgebra;
#[doc(inline)]
pub use running::{Adaptive, Integrator, Reason, Run, StepError};
#[doc(inline)]
pub use scalar::Real;
#[doc(inline)]
pub use space::{ContactState, Coordinates, State};
#[doc(inline)]
pub use system::{
    Autonomous, Conformal, Conservative, Contact, ForceGradient, Hamiltonian, Mechanical, ModifiedEnergy, PhaseSpace,
    Pieces, QuadraticKinetic, Separable,
};

/// Everything that a program needs.
pub mod prelude {
    pub use crate::method::tables::*;
    pub use crate::{
        Adaptive, ContactDiscreteGradient, ContactLeapfrog, ContactMidpoint, ContactSplitting, ContactState,
        CoordinateIncrement, DOP853, DiscreteGradient, Energy, ExplicitEuler, FourthOrder, Gauss, Gonzalez,
        Hamiltonian, ImplicitMidpoint, Integrator, ItohAbe, ItohAbeAdjoint, ItohAbePair, Kahan, MeanValue, Method,
        PhaseSpace, PositionVerlet, Projection, RK4, Relaxation, Run, State, StepError, StormerVerlet,
        SymmetrisedItohAbe, SymplecticEuler, SymplecticEulerAdjoint, contact_hamiltonian, hamiltonian,
    };
}
