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

mod stages;
mod tableau;

pub use tableau::GaussTableau;

use crate::method::composition::{Composed, Composition, SymmetricMap};
use crate::method::{And, Claims, Method, Name, Probe, Refusal, Step, check_end, start};
use crate::scalar::Real;
use crate::solving::newton::Newton;
use crate::space::Array;
use crate::space::{Snapshot, Summation};
use crate::system::{Collocation, Poles};
use stages::Stages;

/// Gauss collocation with `S` stages, 1 to 6. Order 2S, symmetric, symplectic, for every H; keeps quadratic invariants.
///
/// Solved for the stage derivatives kᵢ = f(Yᵢ), all together: Yᵢ = y₀ + h Σ aᵢⱼ kⱼ; or, if T is quadratic, for the stage
/// forces alone: Yᵢ = q₀ + cᵢh q'₀ + h² Σ (A²)ᵢⱼ M⁻¹kⱼ. The reference for energies that are not separable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gauss<const S: usize>;

/// x₁ = x₀ + h J∇H((x₀ + x₁)/2), the Gauss method with one stage. Order 2, symmetric, symplectic, for every H; keeps
/// quadratic invariants.
///
/// For a higher order prefer [`Gauss`] to a composition of this.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ImplicitMidpoint;

/// Coefficients of one step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R, const S: usize> {
    poles: Poles,
    constants: P,
    h: R,
    /// What stage j adds to stage i: h·A, or h²·A².
    coupling: [[R; S]; S],
    /// h·c.
    nodes: [R; S],
    /// h·b.
    weights: [R; S],
    /// What a stage adds to the end: h·b, or h²·b(1 − c).
    increments: [R; S],
}

impl<Y: Collocation<R>, R: Real, const S: usize> Method<Y, R> for Gauss<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Proof = <<Gauss<S> as GaussTableau<S>>::Proof as And<<Y as Collocation<R>>::Proof>>::Both;
    type Prepared = Prepared<Y::Constants, R, S>;
    type Memory = Newton<[Y::Unknown; S]>;

    fn claims(&self) -> Claims {
        Claims {
            order: 2 * S as u32,
            symmetric: true,
            symplectic: true,
            conserves_energy: false,
            perturbed: &[],
            forces: None,
        }
    }

    fn name(&self) -> Name {
        Name::new(["Gauss<1>", "Gauss<2>", "Gauss<3>", "Gauss<4>", "Gauss<5>", "Gauss<6>"][S - 1])
    }

    fn prepare(&self, system: &Y, h: R) -> Self::Prepared {
        let tableau = Self::TABLEAU;
        let first_order = Y::DERIVATIVE == 1;
        let coupling = |i: usize, j: usize| {
            let square = (0..S).map(|k| tableau.a[i][k] * tableau.a[k][j]).sum();
            if first_order { R::from_f64(tableau.a[i][j]) * h } else { R::from_f64(square) * h * h }
        };
        let increment = |i: usize| {
            let (b, c) = (tableau.b[i], tableau.c[i]);
            if first_order { R::from_f64(b) * h } else { R::from_f64(b * (1.0 - c)) * h * h }
        };
        Prepared {
            poles: Poles::of(system),
            constants: system.constants(),
            h,
            coupling: core::array::from_fn(|i| core::array::from_fn(|j| coupling(i, j))),
            nodes: tableau.c.map(|c| R::from_f64(c) * h),
            weights: tableau.b.map(|b| R::from_f64(b) * h),
            increments: core::array::from_fn(increment),
        }
    }

    fn memory() -> Self::Memory {
        Newton::new(Y::State::ALIKE, Y::Unknown::LEN / Y::State::ALIKE)
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        newton: &mut Self::Memory,
        Step { system, t, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let zero = Y::Unknown::zero();
        let (y0, changed) = Y::start(&x.z);
        let velocity = system.velocity(&prepared.constants, &changed);
        probe.visit(t, &x.z, &());
        let (k, _) = newton.solve(&Stages { system, prepared, t, z: x.z, y0, changed, velocity }, probe)?;

        let Prepared { poles, constants, h, weights, increments, .. } = prepared;
        let (mut change, mut impulse) = (zero, zero);
        change.add_scaled(*h, &velocity);
        for i in 0..S {
            system.add(constants, increments[i], &k[i], &mut change);
            impulse.add_scaled(weights[i], &k[i]);
        }
        let before = start::<Y, R, C>(x);
        x.add(&Y::increments(&change, &impulse));
        check_end(poles, [t, t + *h], &before, Step { system, t, x, probe })
    }
}

impl<Y: Collocation<R>, R: Real> Method<Y, R> for ImplicitMidpoint {
    type Proof = <Y as Collocation<R>>::Proof;
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
