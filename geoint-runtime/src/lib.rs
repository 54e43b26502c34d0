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
//! Next: [which method](#which-method) is for your problem, [the table of all methods](#methods), and
//! [systems with friction, driving forces and heat](#dissipative-and-driven-systems), [Lagrangians](#lagrangians), and
//! [differential equations with first integrals](#vector-fields-and-first-integrals).
//!
#![doc = include_str!("../docs/figures/outer_solar_system_energy.svg")]
//!
#![doc = include_str!("../docs/which_method.md")]
//!
#![doc = include_str!("../docs/figures/energy_exact.svg")]
//!
#![doc = include_str!("../docs/contact.md")]
//!
#![doc = include_str!("../docs/figures/contact_compared.svg")]
//!
#![doc = include_str!("../docs/lagrangians.md")]
//!
#![doc = include_str!("../docs/flows.md")]
//!
//! # What a method needs
//!
//! What was proven of a system are traits: [`Separable`], [`QuadraticKinetic`]. A method asks for the traits that it
//! needs, so that a method which would silently be wrong for a system is a type error, whose message names the term that is
//! in the way. What was derived can be read in the docs of the generated struct and in its constant `REPORT`.
//!
//! # Invariants of your own
//!
//! The energy is an invariant that is known. Others are told: how much they change over an increment, and their gradients.
//!
//! ```
//! use geoint_runtime::prelude::*;
//! use geoint_runtime::{Invariants, Real};
//!
//! /// Two bodies; q is the vector between them.
//! #[hamiltonian]
//! fn kepler(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
//!     (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
//! }
//!
//! /// L = q₀p₁ − q₁p₀.
//! #[derive(Clone, Copy)]
//! struct AngularMomentum;
//!
//! impl Invariants<Kepler> for AngularMomentum {
//!     type Values = f64;
//!
//!     /// (q + dq) × (p + dp) − q × p, multiplied out: a difference of two values would lose digits.
//!     fn changes(&self, _: &Kepler, [q, p]: &[[f64; 2]; 2], [dq, dp]: &[[f64; 2]; 2]) -> f64 {
//!         let cross = |a: &[f64; 2], b: &[f64; 2]| a[0] * b[1] - a[1] * b[0];
//!         cross(dq, p) + cross(q, dp) + cross(dq, dp)
//!     }
//!     fn gradients(&self, _: &Kepler, [q, p]: &[[f64; 2]; 2]) -> [[f64; 2]; 2] {
//!         [[p[1], -p[0]], [-q[1], q[0]]]
//!     }
//! }
//!
//! let angular_momentum = |x: &State<[f64; 2]>| x.q[0] * x.p[1] - x.q[1] * x.p[0];
//! let start = State::new([1.0, 0.0], [0.0, 2.5]);
//! let mut sim = Kepler { m: 2.0, k: 3.0 }.integrator(Projection(RK4, (Energy, AngularMomentum)), 0.05, start);
//! let energy = sim.energy();
//! sim.advance(10_000)?;
//! assert!((sim.energy() / energy - 1.0).abs() < 1e-13);
//! assert!((angular_momentum(&sim.state()) / angular_momentum(&start) - 1.0).abs() < 1e-13);
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Steps as long as their error allows
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! # #[hamiltonian]
//! # fn kepler(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
//! #     (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
//! # }
//! // A comet of eccentricity 0.9: at its perihelion steps are a hundred times shorter than far outside.
//! let start = State::new([0.1, 0.0], [0.0, 19_f64.sqrt()]);
//! let mut sim = Kepler { m: 1.0, k: 1.0 }.adaptive(DiscreteGradient, 1e-6, start);
//! let energy = sim.energy();
//! sim.advance_to(20.0)?;
//! assert_eq!(sim.time(), 20.0);
//! assert!((sim.energy() / energy - 1.0).abs() < 1e-13);
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Conventions
//!
//! - **q' = ∂H/∂p, p' = −∂H/∂q**. Coordinates always come in the order q, p, s, t, and as named fields.
//! - Of contact systems **q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H**; the flow multiplies the form ds − p dq by a factor.
//! - A *kick* of length h is the flow of V(q, t): p ← p − h ∂V/∂q. A *drift* is the flow of T(p, t): q ← q + h ∂T/∂p.
//! - `h` may be negative. Time is `t0 + n·h`, never a running sum; output never changes the step, and single steps are those of one call, bit
//!   for bit. `until(t)` and `advance_to(t)` take the whole steps that do not end beyond t, and are at t if that is a whole number of steps
//!   away.
//!   With [`Adaptive`] it is a compensated sum, and the last step ends at the time asked for.
//! - Division by something known before the loop becomes multiplication by its reciprocal (about one rounding), and
//!   `a·b + c` is fused where the processor of the build does that; the feature `strict-math` forbids the latter.
//!
//! # Map of the crate
//!
//! [`State`] is a point, [`Integrator`] a system under a method. Methods: tables of kicks and drifts ([`Splitting`],
//! [`Nystrom`]), compositions of symmetric maps ([`Composition`]), [`Gauss`] collocation and [`ImplicitMidpoint`],
//! [`DiscreteGradient`] and others that keep the energy, [`Kahan`]; explicit [`RungeKutta`] methods, and [`Projection`] and
//! [`Relaxation`] that make any method keep the energy. [`Adaptive`] is an [`Integrator`] that chooses its steps; [`TaylorIntegrator`]
//! takes steps by Taylor series ([`Taylor`]). All are a [`Trajectory`], so that a method can be chosen while the program runs, and [`Dense`]:
//! states between steps, sections and events. With the feature `alloc` all are [`running::Resumable`]: saved, and going on elsewhere. Methods of
//! one's own implement [`method::Method`]; systems written by hand implement the traits of
//! [`system`].

#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(any(feature = "alloc", test))]
extern crate alloc;

mod ablation;

/// Traits with this supertrait are implemented in this crate only, so that they may grow.
mod sealed {
    /// Implemented in this crate only.
    pub trait Sealed {}
}

pub mod scalar;
pub mod space;
pub mod slope;
mod solving;
pub mod system;
pub mod taylor;
pub mod method;
pub mod running;
#[doc(hidden)]
pub mod private;

pub use geoint_macros::{contact_hamiltonian, energy_function, hamiltonian, lagrangian, vector_field};
#[doc(inline)]
pub use method::composition::{Composed, Composition};
pub use method::constrained::Rattle;
#[doc(inline)]
pub use method::contact::{ContactDiscreteGradient, ContactGauss, ContactLeapfrog, ContactMidpoint};
#[doc(inline)]
pub use method::corrected::{Energy, Integrals, Invariants, Projection, Relaxation};
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
pub use method::perturbed::Perturbation;
#[doc(inline)]
pub use method::pieces::{
    ContactSplitting, PieceComposition, PieceNystrom, PieceSplitting, PlanarDiscreteGradient, PlanarItohAbe,
    PlanarItohAbeAdjoint, PlanarItohAbePair, PlanarSplitting, PoissonSplitting,
};
#[doc(inline)]
pub use method::splitting::{
    FiveRotations, Nystrom, PositionVerlet, Splitting, StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint,
};
pub use method::tables::*;
#[doc(inline)]
pub use method::{Claims, Method};
pub use nalgebra;
#[doc(inline)]
pub use running::{
    Adaptive, Crossing, Dense, Direction, Integrator, IntoIntegrator, Reason, StepError, TaylorIntegrator, Trajectory,
};
#[doc(inline)]
pub use scalar::Real;
#[doc(inline)]
pub use space::{Attitudes, BodyState, Centres, ContactState, Coordinates, FlowState, State};
#[doc(inline)]
pub use system::{
    Autonomous, Conformal, Conservative, Constrained, Contact, Cotangent, FirstIntegrals, ForceGradient, Hamiltonian,
    KeepsEnergy, Lagrangian, Mechanical, ModifiedEnergy, Perturbed, PerturbedGradient, PhaseSpace, Pieces,
    PrincipalAxes, QuadraticKinetic, Rates, Separable, SteadyIntegrals, VectorField,
};

#[doc(inline)]
pub use taylor::{Taylor, TaylorFixed, TaylorMethod, TaylorOrder};

/// Everything that a program needs.
pub mod prelude {
    pub use crate::method::tables::*;
    #[cfg(feature = "alloc")]
    pub use crate::running::Resumable;
    pub use crate::{
        Adaptive, BodyState, ContactDiscreteGradient, ContactGauss, ContactLeapfrog, ContactMidpoint, ContactSplitting,
        ContactState, CoordinateIncrement, DOP853, Dense, Direction, DiscreteGradient, Energy, ExplicitEuler,
        FiveRotations, FlowState, FourthOrder, Gauss, Gonzalez, Hamiltonian, ImplicitMidpoint, Integrals, Integrator,
        IntoIntegrator, ItohAbe, ItohAbeAdjoint, ItohAbePair, Kahan, MeanValue, Method, Perturbation, PhaseSpace,
        PieceSplitting, PlanarDiscreteGradient, PlanarItohAbe, PlanarItohAbeAdjoint, PlanarItohAbePair,
        PlanarSplitting, PoissonSplitting, PositionVerlet, Projection, RK4, Rattle, Real, Relaxation, State, StepError,
        StormerVerlet, SymmetrisedItohAbe, SymplecticEuler, SymplecticEulerAdjoint, Taylor, TaylorFixed, TaylorOrder,
        Trajectory, contact_hamiltonian, energy_function, hamiltonian, lagrangian, vector_field,
    };
}

/// The programs of the README compile and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
