//! What the factors of a step are.

use crate::method::Refusal;
use crate::method::gauss::prepared::Prepared;
use crate::scalar::{Real, zero};
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::Array;
use crate::system::ContactStages;

/// rᵢ = 1 + h Σ aᵢⱼ rⱼ σⱼ, and ∂rᵢ/∂σⱼ.
#[derive(Clone, Copy)]
pub(super) struct Factors<R, const S: usize> {
    /// σᵢ = ∂H/∂s at the stages.
    pub(super) decay: [R; S],
    pub(super) r: [R; S],
    pub(super) by_decay: [[R; S]; S],
}

impl<R: Real, const S: usize> Factors<R, S> {
    /// Those that time alone decides; `None` where there are none of that kind.
    #[inline(always)]
    pub(super) fn known<Y: ContactStages<R>>(
        system: &Y,
        prepared: &Prepared<Y::StageConstants, R, S>,
        t: R,
    ) -> Result<Option<Self>, Refusal> {
        if varying::<Y, R>() {
            return Ok(None);
        }
        let decay = prepared.nodes.map(|node| system.decay(&prepared.constants, t + node, &Y::Moved::zero()));
        Self::new::<false>(&prepared.coupling, &decay).map(Some).ok_or(Refusal::Singular)
    }

    /// Derivatives are wanted where they are not known beforehand. `None` where there are no factors.
    #[inline(always)]
    pub(super) fn new<const DERIVED: bool>(coupling: &[[R; S]; S], decay: &[R; S]) -> Option<Self> {
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
}

/// Whether the factors depend on what is solved for: those of H = g(t)·s + H₀ do not.
pub(super) const fn varying<Y: ContactStages<R>, R: Real>() -> bool {
    Y::Moved::LEN > <Y::Phase as Array>::LEN
}
