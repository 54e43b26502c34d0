//! Gauss collocation, the implicit midpoint rule among it, for every H.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// A particle that is bound to a ring on a plane which turns: T depends on the position.
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
//! let order = ((a - b) / (b - c)).log2();
//! assert!((order - 6.0).abs() < 0.3);
//! # Ok::<(), StepError>(())
//! ```

mod canonical;
mod defect;
pub(in crate::method) mod factors;
mod fields;
pub(crate) mod prepared;
pub(in crate::method) mod stages;
mod tableau;
pub(in crate::method) mod velocities;

pub use canonical::CanonicalStages;
pub use fields::FieldStages;
pub use tableau::GaussTableau;
pub use velocities::VelocityStages;

use crate::implicit_method;
use crate::method::composition::substeps;
use crate::method::implicit::{ImplicitMethod, SolvedBy, StepFor};
use crate::method::{Claims, Name};
use crate::scalar::Real;
use crate::system::PhaseSpace;

/// Gauss collocation with `S` stages, 1 to 6. Order 2S, symmetric, symplectic, for every H; keeps quadratic invariants.
///
/// Solved for the stage derivatives kᵢ = f(Yᵢ), all together: Yᵢ = y₀ + h Σ aᵢⱼ kⱼ; or, if T is quadratic, for the stage
/// forces alone: Yᵢ = q₀ + cᵢh q'₀ + h² Σ (A²)ᵢⱼ M⁻¹kⱼ. The reference for energies that are not separable. A Lagrangian whose mass
/// matrix is full is solved for stage velocities Vᵢ: Qᵢ = q₀ + h Σ aᵢⱼVⱼ, ∂L/∂v(Qᵢ, Vᵢ) = p₀ + h Σ aᵢⱼ ∂L/∂q(Qⱼ, Vⱼ), which is the same
/// map with half of the unknowns. Of a Lagrangian that is linear in velocities, with momenta of which half may be zero, it is moved by
/// canonical coordinates, positions and momenta ϑ(q), and solved for q: symplectic for Ω = dϑ.
///
/// Where it is solved for derivatives, with three and four stages of at most six unknowns, [adaptive](crate::Adaptive) steps estimate their errors
/// by f between the stages: the estimate is of order 2S, and sees what is small beside other motions, however fast.
#[doc(alias("Gauss-Legendre", "collocation", "IRK", "implicit Runge-Kutta"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gauss<const S: usize>;

/// x₁ = x₀ + h J∇H((x₀ + x₁)/2), the Gauss method with one stage. Order 2, symmetric, symplectic, for every H; keeps
/// quadratic invariants.
///
/// For a higher order prefer [`Gauss`] to a composition of this.
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

/// One stage is the midpoint rule.
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

/// A system that has Gauss methods with each number of stages.
pub trait SolvedByGauss<R: Real = f64>:
    PhaseSpace<R>
    + SolvedBy<Gauss<1>, R>
    + SolvedBy<Gauss<2>, R>
    + SolvedBy<Gauss<3>, R>
    + SolvedBy<Gauss<4>, R>
    + SolvedBy<Gauss<5>, R>
    + SolvedBy<Gauss<6>, R>
    + SolvedBy<ImplicitMidpoint, R>
{
}

impl<Y, R: Real> SolvedByGauss<R> for Y where
    Y: PhaseSpace<R>
        + SolvedBy<Gauss<1>, R>
        + SolvedBy<Gauss<2>, R>
        + SolvedBy<Gauss<3>, R>
        + SolvedBy<Gauss<4>, R>
        + SolvedBy<Gauss<5>, R>
        + SolvedBy<Gauss<6>, R>
        + SolvedBy<ImplicitMidpoint, R>
{
}
