//! Factors of the stages of a step, and their effects.

use crate::scalar::{Real, zero};
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::vector::sum_of_products;

/// Factors rᵢ = 1 + h Σ aᵢⱼ rⱼ σⱼ, and their derivatives ∂rᵢ/∂σⱼ.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) struct Factors<R, const S: usize> {
    /// σᵢ = ∂H/∂s at the stages.
    pub(in crate::method) decay: [R; S],
    pub(in crate::method) r: [R; S],
    pub(in crate::method) by_decay: [[R; S]; S],
}

impl<R: Real, const S: usize> Factors<R, S> {
    /// Solves for the factors, and for their derivatives if `DERIVED`. Derivatives are needed only if the factors are not known beforehand. Returns
    /// `None` if there are no factors.
    #[inline(always)]
    pub(in crate::method) fn new<const DERIVED: bool>(coupling: &[[R; S]; S], decay: &[R; S]) -> Option<Self> {
        let one = R::from_f64(1.0);
        let matrix: [[R; S]; S] = core::array::from_fn(|i| {
            core::array::from_fn(|j| (if i == j { one } else { zero() }) - coupling[i][j] * decay[j])
        });
        let solve = |rhs: [R; S]| {
            let (mut matrix, mut x) = (matrix, rhs);
            linear::solve::<[R; S]>(&mut matrix, &mut x, &Sizes::equal()).map(|_| x)
        };
        let r = solve([one; S])?;
        let mut by_decay = [[zero(); S]; S];
        for j in 0..if DERIVED { S } else { 0 } {
            let column = solve(core::array::from_fn(|i| coupling[i][j] * r[j]))?;
            for i in 0..S {
                by_decay[i][j] = column[i];
            }
        }
        Some(Factors { decay: *decay, r, by_decay })
    }

    /// Returns the factors after small changes of σ. The squares of these changes are rounding errors.
    #[inline(always)]
    pub(in crate::method) fn after(&self, decay: &[R; S]) -> Self {
        let mut factors = Factors { decay: *decay, ..*self };
        for i in 0..S {
            for j in 0..S {
                factors.r[i] += self.by_decay[i][j] * (decay[j] - self.decay[j]);
            }
        }
        factors
    }

    /// Returns NaN for all factors, if none exist. No solution is then found.
    pub(in crate::method) fn unknown() -> Self {
        let unknown = R::from_f64(f64::NAN);
        Factors { decay: [unknown; S], r: [unknown; S], by_decay: [[unknown; S]; S] }
    }

    /// Returns r₁ − 1 = h Σ bᵢ rᵢ σᵢ. Returns `None` if the step would not multiply the contact form by a positive number.
    #[inline(always)]
    pub(in crate::method) fn growth(&self, weights: &[R; S]) -> Option<R> {
        let grown = sum_of_products(weights, &core::array::from_fn::<_, S, _>(|i| self.r[i] * self.decay[i]));
        let factor = R::from_f64(1.0) + grown;
        let positive = factor.magnitude() > 0.0 && !factor.any_below(0.0);
        positive.then_some(grown)
    }

    /// Solves for s' at the stages, kᵢ, from the values of s' at s₀: aᵢ = kᵢ + σᵢ h Σ aᵢⱼ kⱼ.
    #[inline(always)]
    pub(in crate::method) fn rates_of_action(&self, coupling: &[[R; S]; S], mut at_start: [R; S]) -> Option<[R; S]> {
        let one = R::from_f64(1.0);
        let mut matrix: [[R; S]; S] = core::array::from_fn(|i| {
            core::array::from_fn(|j| (if i == j { one } else { zero() }) + self.decay[i] * coupling[i][j])
        });
        linear::solve::<[R; S]>(&mut matrix, &mut at_start, &Sizes::equal()).map(|_| at_start)
    }
}
