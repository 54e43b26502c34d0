//! Gauss collocation for every H. The implicit midpoint rule is the method with one stage.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// A bead on the wire y = q²/2, in the potential y²: T depends on the position.
//! #[hamiltonian]
//! fn coupled(q: f64, p: f64, m: f64) -> f64 {
//!     p * p / (2.0 * m * (1.0 + q * q)) + q.powi(4) / 4.0
//! }
//!
//! let system = Coupled { m: 0.7 };
//! let end = |steps: u64| -> Result<f64, StepError> {
//!     let mut sim = system.integrator(Gauss::<3>, 4.0 / steps as f64, State::new(1.0, 0.3));
//!     sim.advance(steps)?;
//!     Ok(sim.state().q)
//! };
//! let [a, b, c] = [end(20)?, end(40)?, end(80)?];
//! // If h is halved, the error of order 6 falls by the factor 2⁶.
//! let order = ((a - b) / (b - c)).log2();
//! assert!((order - 6.0).abs() < 0.3);
//! # Ok::<(), StepError>(())
//! ```

pub(crate) mod canonical; // Step in canonical coordinates y(x).
mod defect; // Error estimate of `fields`.
pub(in crate::method) mod factors; // Weights of momenta in contact systems.
pub(crate) mod fields; // Step of y' = f(y, t), or q'' = M⁻¹f(q, t).
pub(crate) mod prepared; // Table times h.
pub(crate) mod solved; // The bound for all numbers of stages.
pub(in crate::method) mod stages; // Equations of all stages, except in `fields`.
pub(crate) mod tableau; // Table for each number of stages.
pub(crate) mod velocities; // Step of Lagrangians that are solved for velocities.

pub(crate) use solved::SolvedByGauss;
pub(crate) use tableau::GaussTableau;

use crate::implicit_method;
use crate::method::composition::substeps;
use crate::method::implicit::{ImplicitMethod, StepFor};
use crate::method::{Claims, Name};
use crate::scalar::Real;
use crate::system::PhaseSpace;

/// Gauss collocation with `S` stages, 1 to 6. Order 2S, symmetric, symplectic, for every H. Keeps quadratic invariants. The reference method for energies
/// that are not separable.
///
/// A step of y' = f(y, t) solves kᵢ = f(Yᵢ, t + cᵢh) for all stages together, with Yᵢ = y₀ + h Σ aᵢⱼ kⱼ. Then y₁ = y₀ + h Σ bᵢ kᵢ. The weights bᵢ and nodes
/// cᵢ are those of Gauss's quadrature on \[0, 1\]. The coefficients A = (aᵢⱼ) integrate polynomials of degree S − 1 exactly from 0 to cᵢ. If H = T(p) + V(q)
/// with a quadratic T and the mass matrix M, the unknowns are the forces kᵢ alone: Yᵢ = q₀ + cᵢh q'₀ + h² Σ (A²)ᵢⱼ M⁻¹kⱼ.
///
/// For a Lagrangian without a short formula for its energy, such as one with a full mass matrix, the unknowns are the stage velocities Vᵢ:
/// Qᵢ = q₀ + h Σ aᵢⱼVⱼ, ∂L/∂v(Qᵢ, Vᵢ) = p₀ + h Σ aᵢⱼ ∂L/∂q(Qⱼ, Vⱼ). The map is that of the energy, with half of the unknowns.
///
/// A Lagrangian ϑ(q)·v − H(q) is linear in the velocities. If canonical coordinates are found, which the report states, the method advances these, and solves
/// for q. The step is then symplectic for Ω = dϑ. Otherwise it solves q' = Ω⁻¹∇H, and is not symplectic.
///
/// [Adaptive](crate::Adaptive) steps with three or four stages estimate their errors from f between the stages, if the unknowns are values of f, at most
/// six a stage. The estimate has order 2S. It detects a motion that is small beside other motions, however fast the small motion is.
///
/// Hairer, Lubich & Wanner, *Geometric Numerical Integration* (2006), sections II.1.3, IV.2.1 (invariants) and VI.4 (symplecticity).
#[doc(alias("Gauss-Legendre", "collocation", "IRK", "implicit Runge-Kutta"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gauss<const S: usize>;

/// x₁ = x₀ + h J∇H((x₀ + x₁)/2) with x = (q, p) and J(q, p) = (p, −q): the Gauss method with one stage. Order 2, symmetric, symplectic, for every H. Keeps
/// quadratic invariants.
///
/// For a higher order prefer [`Gauss`] with more stages to a composition of this method.
#[doc(alias = "midpoint rule")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ImplicitMidpoint;

implicit_method!(
    [const S: usize] Gauss<S>,
    |_| Name::new(["Gauss<1>", "Gauss<2>", "Gauss<3>", "Gauss<4>", "Gauss<5>", "Gauss<6>"][S - 1]),
    Claims::of_order(2 * S as u32).symmetric().symplectic()
);
implicit_method!(ImplicitMidpoint, |_| Name::new("ImplicitMidpoint"), Claims::of_order(2).symmetric().symplectic());
substeps!([] ImplicitMidpoint);

/// The midpoint rule is the Gauss method with one stage.
impl<Y: PhaseSpace<R>, R: Real> ImplicitMethod<Y, R> for ImplicitMidpoint
where
    Gauss<1>: ImplicitMethod<Y, R>,
{
    type Proof = <Gauss<1> as ImplicitMethod<Y, R>>::Proof;
    type Step = StepFor<Gauss<1>, Y, R>;

    fn step(self) -> Self::Step {
        Gauss::<1>.step()
    }
}
