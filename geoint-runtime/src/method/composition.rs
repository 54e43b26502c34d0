//! Symmetric compositions Φ(γ_K h) ∘ … ∘ Φ(γ₁h) of a symmetric map Φ of order 2. The weights γ determine the order of the composition.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// A pendulum on a spring, in polar coordinates: q and p are coupled.
//! #[hamiltonian]
//! fn elastic_pendulum(q: [f64; 2], p: [f64; 2], m: f64, k: f64, g: f64) -> f64 {
//!     let [r, angle] = q;
//!     (p[0] * p[0] + p[1] * p[1] / (r * r)) / (2.0 * m) + k * (r - 1.0).powi(2) / 2.0 - m * g * r * angle.cos()
//! }
//!
//! let system = ElasticPendulum { m: 0.8, k: 40.0, g: 9.81 };
//! let start = State::new([1.1, 0.5], [0.0, 0.0]);
//! let end = |steps: u64| -> Result<f64, StepError> {
//!     let mut sim = system.integrator(Suzuki4.of(DiscreteGradient), 2.0 / steps as f64, start);
//!     let energy = sim.energy();
//!     sim.advance(steps)?;
//!     // The composition keeps the invariants of the map.
//!     assert!((sim.energy() / energy - 1.0).abs() < 1e-13);
//!     Ok(sim.state().q[1])
//! };
//! let [a, b, c] = [end(100)?, end(200)?, end(400)?];
//! let order = ((a - b) / (b - c)).log2();
//! assert!((order - 4.0).abs() < 0.2);
//! # Ok::<(), StepError>(())
//! ```

use crate::method::flows::Splitting;
use crate::method::flows::perturbed::Perturbation;
pub use crate::method::proof::StepsBack;
use crate::method::tables::total::adds_up;
use crate::method::{Claims, Failure, Handling, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Array, Summation};
use crate::system::PhaseSpace;

/// Weights γ₁, …, γ_K, a palindrome.
#[doc(alias = "composition method")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Composition<const K: usize> {
    name: Name,
    order: u32,
    gamma: [f64; K],
}

impl<const K: usize> Composition<K> {
    /// Returns a palindrome, given by its first half (the middle included).
    pub(crate) const fn palindrome<const HALF: usize>(name: &'static str, order: u32, half: [f64; HALF]) -> Self {
        assert!(HALF == K.div_ceil(2));
        let mut gamma = [0.0; K];
        let mut i = 0;
        while i < K {
            gamma[i] = half[if i < HALF { i } else { K - 1 - i }];
            i += 1;
        }
        assert!(adds_up(&gamma, 1.0), "the weights add up to 1");
        Composition { name: Name::new(name), order, gamma }
    }

    /// Returns this composition of a symmetric map of order 2.
    ///
    /// The map must be exactly symmetric, so implicit maps are solved to rounding. Compositions of [`StormerVerlet`](crate::StormerVerlet) and
    /// [`PositionVerlet`](crate::PositionVerlet) become splitting tables with neighbouring flows merged.
    pub fn of<M: SymmetricMap>(self, map: M) -> M::Composed<K> {
        map.compose(self)
    }

    /// The name.
    pub const fn name(&self) -> Name {
        self.name
    }

    /// The order of the composition of a symmetric map of order 2.
    pub const fn order(&self) -> u32 {
        self.order
    }

    /// The weights.
    pub const fn weights(&self) -> &[f64; K] {
        &self.gamma
    }
}

/// A symmetric map of order 2.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a symmetric map of order 2, and only those can be composed",
    note = "maps for T + V: `StormerVerlet`, `PositionVerlet`; for A + B: `Perturbation` of these; for what is split into pieces: `PieceSplitting`; for quadratic fields: `Kahan`",
    note = "maps for every energy: `ImplicitMidpoint`, `DiscreteGradient`, `Gonzalez`, `MeanValue`, `SymmetrisedItohAbe`, `ItohAbePair`",
    note = "maps for contact systems: `ContactSplitting`, `ContactLeapfrog`, `ContactMidpoint`, `ContactDiscreteGradient`"
)]
pub trait SymmetricMap: Copy {
    /// The method that [`compose`](Self::compose) returns.
    type Composed<const K: usize>;
    /// Returns the composition of this map.
    fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K>;
}

/// Implements [`SymmetricMap`] for maps whose compositions take one substep after the other. The bound restricts the systems `S` of compositions.
macro_rules! substeps {
    ($([$($generic:tt)*] $map:ty $(where $systems:path)?);*) => { $(
        impl<S, R: crate::scalar::Real, $($generic)*> crate::method::proof::StepsBack<S, R> for $map
        $(where S: $systems)? {}
        impl<$($generic)*> crate::method::composition::SymmetricMap for $map {
            type Composed<const SUBSTEPS: usize> = crate::method::composition::Composed<$map, SUBSTEPS>;
            fn compose<const SUBSTEPS: usize>(
                self,
                composition: crate::method::composition::Composition<SUBSTEPS>,
            ) -> Self::Composed<SUBSTEPS> {
                crate::method::composition::Composed { map: self, composition }
            }
        }
    )* };
}
pub(crate) use substeps;

/// A table of one pair of flows, such as [`StormerVerlet`](crate::StormerVerlet) or `WisdomHolman`. The order of the composition is 1 if the table is not symmetric.
impl SymmetricMap for Splitting<1> {
    type Composed<const K: usize> = Splitting<K>;
    fn compose<const K: usize>(self, composition: Composition<K>) -> Splitting<K> {
        Splitting::composed(composition.name, composition.order, &composition.gamma, &self)
    }
}

impl<M: SymmetricMap> SymmetricMap for Perturbation<M> {
    type Composed<const K: usize> = Perturbation<M::Composed<K>>;
    fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K> {
        Perturbation(self.0.compose(composition))
    }
}

/// The coefficients of one substep.
#[derive(Clone, Copy, Debug)]
pub struct Substep<P, R> {
    map: P,
    /// The start of the substep, relative to the start of the step.
    after: R,
}

/// A symmetric composition of a map whose neighbouring steps share no flow. It takes one substep after the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Composed<M, const K: usize> {
    pub(crate) map: M,
    pub(crate) composition: Composition<K>,
}

impl<S: PhaseSpace<R>, R: Real, M: Method<S, R> + StepsBack<S, R>, const K: usize> Method<S, R> for Composed<M, K> {
    type Proof = M::Proof;
    type Prepared = [Substep<M::Prepared, R>; K];
    /// One memory for each substep: increments are extrapolated from those of the same substep in earlier steps. Do not share one memory. Substeps
    /// differ in length and sign, so initial guesses would be poor and iterations slow.
    type Memory = [M::Memory; K];
    // The maps that are composed move the point of the state.
    const HANDLING: Handling = Handling { moves_inner_point: false, ..M::HANDLING };

    #[inline]
    fn way_back(prepared: &Self::Prepared, system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        prepared.first().map_or(S::Phase::zero(), |first| M::way_back(&first.map, system, origin, z))
    }

    #[inline]
    fn is_in_range(prepared: &Self::Prepared, system: &S, z: &S::Phase) -> bool {
        prepared.first().is_none_or(|first| M::is_in_range(&first.map, system, z))
    }

    fn claims(&self) -> Claims {
        let map = self.map.claims();
        let order = self.composition.order.min(M::COMPOSES_TO);
        Claims { order, forces: map.forces.map(|forces| K as u32 * forces), ..map }
    }

    fn name(&self) -> Name {
        self.composition.name.of(self.map.name())
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        let gamma = &self.composition.gamma;
        core::array::from_fn(|i| Substep {
            map: self.map.prepare(system, R::from_f64(gamma[i]) * h),
            after: R::from_f64(gamma[..i].iter().sum()) * h,
        })
    }

    fn memory(z: &S::Phase) -> Self::Memory {
        core::array::from_fn(|_| M::memory(z))
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        let [t, end] = [step.t, step.end];
        for (i, (substep, memory)) in prepared.iter().zip(memory).enumerate() {
            let after = |i: usize| prepared.get(i).map_or(end, |substep| t + substep.after);
            M::step(&substep.map, memory, step.part([i, i + 1].map(after)))?;
        }
        Ok(())
    }
}
