//! The factors r of Gauss steps of contact systems, whose momenta decay: p' = −∂H/∂q − σ p with σ = ∂H/∂s, or σ = −∂L/∂s.
//!
//! r' = r σ, and r = 1 at the start of a step. Stages advance r p in place of p, because (r p)' = −r ∂H/∂q has no term with σ. `coupling` is h·aᵢⱼ and
//! `weights` are h·bᵢ, with the coefficients and weights of the method. `decay` is σ at each stage.

use crate::scalar::{Real, zero};
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::vector::sum_of_products;

/// The factors rᵢ = 1 + h Σ aᵢⱼ rⱼ σⱼ of the stages.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) struct Factors<R, const S: usize> {
    /// σᵢ.
    pub(in crate::method) decay: [R; S],
    /// rᵢ.
    pub(in crate::method) r: [R; S],
    /// ∂rᵢ/∂σⱼ, or zeros if no derivatives were asked for.
    pub(in crate::method) by_decay: [[R; S]; S],
}

impl<R: Real, const S: usize> Factors<R, S> {
    /// Returns the factors for the given σᵢ, with derivatives if `DERIVED`. Only a σ that depends on the unknowns of the step needs derivatives. Returns
    /// `None` if the matrix δᵢⱼ − h aᵢⱼσⱼ is singular.
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

    /// Returns the factors for new σᵢ, to first order. Preconditions: the squares of the changes are below rounding errors, and `by_decay` is known.
    #[inline(always)]
    pub(in crate::method) fn with_decay(&self, decay: &[R; S]) -> Self {
        let mut factors = Factors { decay: *decay, ..*self };
        for i in 0..S {
            for j in 0..S {
                factors.r[i] += self.by_decay[i][j] * (decay[j] - self.decay[j]);
            }
        }
        factors
    }

    /// Returns NaN for all factors, in place of factors that do not exist. The residual is then NaN, and no solution is found.
    pub(in crate::method) fn unknown() -> Self {
        let unknown = R::from_f64(f64::NAN);
        Factors { decay: [unknown; S], r: [unknown; S], by_decay: [[unknown; S]; S] }
    }

    /// Returns r₁ − 1 = h Σ bᵢ rᵢ σᵢ with r₁ at the end of the step. Returns `None` if r₁, by which the step divides the contact form, is not positive.
    #[inline(always)]
    pub(in crate::method) fn growth(&self, weights: &[R; S]) -> Option<R> {
        let grown = sum_of_products(weights, &core::array::from_fn::<_, S, _>(|i| self.r[i] * self.decay[i]));
        let factor = R::from_f64(1.0) + grown;
        let positive = factor.magnitude() > 0.0 && !factor.any_below(0.0);
        positive.then_some(grown)
    }

    /// Returns s' at the stages: the solution of sᵢ' + σᵢ h Σ aᵢⱼ sⱼ' = `at_start`ᵢ, or `None` if the matrix is singular. Precondition: s' is affine in s
    /// with the slope −σ, and `at_start` holds its values for s = s₀.
    #[inline(always)]
    pub(in crate::method) fn rates_of_action(&self, coupling: &[[R; S]; S], mut at_start: [R; S]) -> Option<[R; S]> {
        let one = R::from_f64(1.0);
        let mut matrix: [[R; S]; S] = core::array::from_fn(|i| {
            core::array::from_fn(|j| (if i == j { one } else { zero() }) + self.decay[i] * coupling[i][j])
        });
        linear::solve::<[R; S]>(&mut matrix, &mut at_start, &Sizes::equal()).map(|_| at_start)
    }
}
