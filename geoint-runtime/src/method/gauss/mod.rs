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
mod fields;
pub(crate) mod prepared;
mod stages;
mod tableau;
pub(in crate::method) mod velocities;

pub use tableau::GaussTableau;

use crate::method::composition::{Composed, Composition, SymmetricMap};
use crate::method::{And, Claims, Estimate, Method, Name, Probe, Refusal, Step, StepsOf};
use crate::scalar::Real;
use crate::space::Summation;
use crate::system::Collocated;

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

impl<Y: Collocated<R>, R: Real, const S: usize> Method<Y, R> for Gauss<S>
where
    Y::Stages: StepsOf<Gauss<S>, Y, R>,
    Gauss<S>: GaussTableau<S>,
{
    type Proof = <<Gauss<S> as GaussTableau<S>>::Proof as And<<Y as Collocated<R>>::Proof>>::Both;
    type Prepared = <Y::Stages as StepsOf<Self, Y, R>>::Prepared;
    type Memory = <Y::Stages as StepsOf<Self, Y, R>>::Memory;

    fn claims(&self) -> Claims {
        Claims::of_order(2 * S as u32).symmetric().symplectic()
    }

    fn name(&self) -> Name {
        Name::new(["Gauss<1>", "Gauss<2>", "Gauss<3>", "Gauss<4>", "Gauss<5>", "Gauss<6>"][S - 1])
    }

    fn prepare(&self, system: &Y, h: R) -> Self::Prepared {
        <Y::Stages as StepsOf<Self, Y, R>>::prepare(system, h)
    }

    fn memory() -> Self::Memory {
        <Y::Stages as StepsOf<Self, Y, R>>::memory()
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        <Y::Stages as StepsOf<Self, Y, R>>::step(prepared, memory, step)
    }

    fn order_of_estimate(&self) -> Option<u32> {
        <Y::Stages as StepsOf<Self, Y, R>>::order_of_estimate()
    }

    #[inline(always)]
    fn estimated<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, Y, R, C, P>,
    ) -> Option<Result<Estimate<Y, R>, Refusal>> {
        <Y::Stages as StepsOf<Self, Y, R>>::estimated(prepared, memory, step)
    }
}

impl<Y: Collocated<R>, R: Real> Method<Y, R> for ImplicitMidpoint
where
    Y::Stages: StepsOf<Gauss<1>, Y, R>,
{
    type Proof = <Y as Collocated<R>>::Proof;
    type Prepared = <Gauss<1> as Method<Y, R>>::Prepared;
    type Memory = <Gauss<1> as Method<Y, R>>::Memory;

    fn claims(&self) -> Claims {
        Method::<Y, R>::claims(&Gauss::<1>)
    }

    fn name(&self) -> Name {
        Name::new("ImplicitMidpoint")
    }

    fn prepare(&self, system: &Y, h: R) -> Self::Prepared {
        Gauss::<1>.prepare(system, h)
    }

    fn memory() -> Self::Memory {
        <Gauss<1> as Method<Y, R>>::memory()
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        Gauss::<1>::step(prepared, memory, step)
    }
}

impl SymmetricMap for ImplicitMidpoint {
    type Composed<const K: usize> = Composed<ImplicitMidpoint, K>;
    fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K> {
        Composed { map: self, composition }
    }
}
