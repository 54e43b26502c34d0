//! Gauss collocation for every H, including the implicit midpoint rule.
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
mod velocities;

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

/// Gauss collocation with `S` stages, 1 to 6. Order 2S, symmetric, symplectic, for every H. Keeps quadratic invariants.
///
/// The unknowns are the stage derivatives kᵢ = f(Yᵢ) of all stages together, with Yᵢ = y₀ + h Σ aᵢⱼ kⱼ. If T is quadratic, the unknowns are the stage
/// forces alone, with Yᵢ = q₀ + cᵢh q'₀ + h² Σ (A²)ᵢⱼ M⁻¹kⱼ. `Gauss` is the reference method for energies that are not separable.
///
/// For a Lagrangian with a full mass matrix, the unknowns are the stage velocities Vᵢ: Qᵢ = q₀ + h Σ aᵢⱼVⱼ, ∂L/∂v(Qᵢ, Vᵢ) = p₀ + h Σ aᵢⱼ ∂L/∂q(Qⱼ, Vⱼ).
/// The map does not change, and the number of unknowns is halved. A Lagrangian that is linear in the velocities has momenta ϑ(q), of which half may be
/// zero. The method then advances canonical coordinates, which are positions and momenta, and solves for q. The step is symplectic for Ω = dϑ.
///
/// If the unknowns are derivatives, with three and four stages of at most six unknowns, [adaptive](crate::Adaptive) steps estimate their errors from f
/// between the stages. The estimate has order 2S. It detects a motion that is small beside other motions, however fast the small motion is.
#[doc(alias("Gauss-Legendre", "collocation", "IRK", "implicit Runge-Kutta"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gauss<const S: usize>;

/// x₁ = x₀ + h J∇H((x₀ + x₁)/2), the Gauss method with one stage. Order 2, symmetric, symplectic, for every H. Keeps quadratic invariants.
///
/// For a higher order prefer [`Gauss`] to a composition of this method.
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
