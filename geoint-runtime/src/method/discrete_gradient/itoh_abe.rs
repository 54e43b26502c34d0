//! Discrete gradients whose entry i is the divided difference of H along an edge that changes coordinate i only.
//!
//! The edges form a path from x₀ to x₁. Its direction distinguishes [`ItohAbe`] from its adjoint; [`SymmetrisedItohAbe`] and [`ItohAbePair`] combine both.
//!
//! This file implements [`Method`] for [`ItohAbePair`], which takes two steps. The table in `methods.rs` makes methods of the other types.

use super::energy::{Energy, Slope, Staircase};
use super::matrix::Matrix;
use super::mean::{MeanGradient, MeanStep};
use crate::method::composition::substeps;
use crate::method::corrected::kept;
use crate::method::implicit::{Memory, Prepared};
use crate::method::{Claims, Failure, Handling, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::vector::{moved, opposite, scaled, sum};
use crate::space::{Array, Summation};
use crate::system::{Conservative, DiscreteField, Invariants, KeptBy};

/// x₁ = x₀ + h J g with gᵢ = (H(…, x₁ᵢ, x₀ᵢ₊₁, …) − H(…, x₀ᵢ, x₀ᵢ₊₁, …))/(x₁ᵢ − x₀ᵢ). The entries i of x₀ and x₁ are x₀ᵢ and x₁ᵢ. Here x = (q, p) and
/// J(q, p) = (p, −q). The order of the entries is all of q, then all of p. Entries before i have their new values, entries after i their old ones. If H
/// does not read time, every accepted step keeps the energy to rounding.
///
/// Order 1. Order 2 and symmetric if H = Σ Tᵢ(pᵢ) + Σ Vᵢ(qᵢ). If H does not read a coordinate, its momentum is kept. Use the method for comparison with the
/// literature. Otherwise prefer [`DiscreteGradient`](crate::DiscreteGradient): a step of `ItohAbe` depends on the numbering of the coordinates.
///
/// T. Itoh & K. Abe, J. Comput. Phys. 76 (1988) 85.
#[doc(alias("coordinate increment discrete gradient", "Itoh-Abe"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ItohAbe;

/// The adjoint of [`ItohAbe`]: a step of [`ItohAbe`] from x₁ with −h leads to x₀. Coordinates change in the reverse order.
///
/// Order 1. Keeps the energy as [`ItohAbe`] does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ItohAbeAdjoint;

/// [`ItohAbe`] for h/2, then [`ItohAbeAdjoint`] for h/2. Order 2, symmetric. Keeps the energy as [`ItohAbe`] does.
///
/// A step solves two equations. Its error is about a quarter of the error of [`SymmetrisedItohAbe`] in the example `which_discrete_gradient`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ItohAbePair;

/// The step along the mean of the discrete gradients of [`ItohAbe`] and [`ItohAbeAdjoint`]. Order 2, symmetric. Keeps the energy as [`ItohAbe`] does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SymmetrisedItohAbe;

impl MeanGradient for ItohAbe {
    fn mean_name(&self) -> Name {
        Name::new("ItohAbe")
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Failure> {
        // Each edge changes one coordinate. `end` is the derivative of g by the end x + d, thus ∂g/∂d.
        let Staircase { g, end, .. } = energy.staircase(x, d, 1);
        Ok(Slope { g, derivative: end })
    }
}

impl MeanGradient for ItohAbeAdjoint {
    fn mean_name(&self) -> Name {
        Name::new("ItohAbeAdjoint")
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Failure> {
        // The path from x₁ back to x₀ starts at x₁, so its derivative by the start is ∂g/∂d.
        let end = sum(x, d);
        let Staircase { g, start, .. } = energy.staircase(&end, &opposite(d), 1);
        Ok(Slope { g, derivative: start })
    }
}

impl MeanGradient for SymmetrisedItohAbe {
    fn mean_name(&self) -> Name {
        Name::new("SymmetrisedItohAbe")
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Failure> {
        let half = R::from_f64(0.5);
        let (mut forward, mut backward) = (ItohAbe.between(energy, x, d)?, ItohAbeAdjoint.between(energy, x, d)?);
        let mut slope = Slope { g: moved(&scaled(half, &forward.g), half, &backward.g), derivative: Matrix::zero() };
        slope.derivative.add_scaled(half, &mut forward.derivative);
        slope.derivative.add_scaled(half, &mut backward.derivative);
        Ok(slope)
    }
}

/// Mean gradient of one half of a step of [`ItohAbePair`]. Both halves have one type, so that they share a solver and its guesses.
#[derive(Clone, Copy, Debug)]
pub enum Half {
    /// [`ItohAbe`].
    First,
    /// [`ItohAbeAdjoint`].
    Second,
}

impl MeanGradient for Half {
    fn mean_name(&self) -> Name {
        match self {
            Half::First => ItohAbe.mean_name(),
            Half::Second => ItohAbeAdjoint.mean_name(),
        }
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Failure> {
        match self {
            Half::First => ItohAbe.between(energy, x, d),
            Half::Second => ItohAbeAdjoint.between(energy, x, d),
        }
    }
}

/// Coefficients of both halves of a step of [`ItohAbePair`].
#[derive(Clone)]
pub struct PreparedPair<S: DiscreteField<R> + Conservative<R>, R: Real> {
    first: Prepared<MeanStep<Half>, S, R>,
    second: Prepared<MeanStep<Half>, S, R>,
    /// h/2.
    half_step: R,
}

impl<S: DiscreteField<R> + Conservative<R>, R: Real> Method<S, R> for ItohAbePair {
    type Proof = <S as Conservative<R>>::Proof;
    type Prepared = PreparedPair<S, R>;
    type Memory = Memory<MeanStep<Half>, S, R>;
    const HANDLING: Handling =
        Handling { keeps_invariants: <KeptBy<S, R> as Invariants<S, R>>::Values::LEN > 0, ..Handling::PLAIN };

    #[inline]
    fn way_back(_: &Self::Prepared, system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        kept::way_back(system, &KeptBy::<S, R>::default(), origin, z)
    }

    fn claims(&self) -> Claims {
        Claims::of_order(2).symmetric().conserving_energy()
    }

    fn name(&self) -> Name {
        Name::new("ItohAbePair")
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        let half_step = R::from_f64(0.5) * h;
        let [first, second] = [Half::First, Half::Second].map(|mean| Prepared::new(MeanStep(mean), system, half_step));
        PreparedPair { first, second, half_step }
    }

    fn memory(_: &S::Phase) -> Self::Memory {
        Memory::new()
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        PreparedPair { first, second, half_step }: &Self::Prepared,
        memory: &mut Self::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        let [start, middle, end] = [step.t, step.t + *half_step, step.end];
        first.step(memory, step.part([start, middle]))?;
        second.step(memory, step.part([middle, end]))
    }
}

// Both are symmetric maps of order 2, which compositions need. `ItohAbe` and its adjoint are not symmetric.
substeps!([] ItohAbePair; [] SymmetrisedItohAbe);
