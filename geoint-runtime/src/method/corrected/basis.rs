//! Orthogonal vectors w with the span of gradients of invariants, by the Gram–Schmidt method (E. Schmidt, Math. Ann. 63 (1907) 442).
//!
//! Projections, the removal of drift, and `FourthOrder(DiscreteGradient)` correct a point or a velocity by a combination of gradients. A correction along
//! Mw does not change, to first order, the invariants before it. The metric M measures lengths and angles, because coordinates have different units. It is
//! diagonal, or 1 for gradients that are scaled already.
//!
//! A gradient that depends on the gradients before it leaves a vector of rounding errors only. It adds no condition, and its weight would amplify these
//! errors, so the basis excludes it.

use crate::scalar::{Real, zero};
use crate::space::vector::dot;
use crate::space::{Array, Square};

/// The gradients that a basis excludes. The part of a gradient that is independent of the gradients before it is compared with the gradient.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Excluded {
    /// The part is at most √ε of the gradient, as near a point at which the gradients depend on each other exactly. The independent change of the invariant is
    /// there quadratic in this part, so it is rounding.
    Dependent,
    /// The part is at most 1/32 of the gradient. Otherwise a correction would amplify the rounding of one evaluation by more than √1024, the growth of the
    /// rounding error in the 1024 steps between two removals of drift.
    NearlyDependent,
}

impl Excluded {
    /// Returns the square of the largest part that is excluded.
    fn square<R: Real>(self) -> f64 {
        match self {
            Self::Dependent => R::epsilon(),
            Self::NearlyDependent => 1.0 / 1024.0,
        }
    }
}

/// Orthogonal vectors w of the space of the given gradients: w_a·Mw_b = 0 for a ≠ b.
pub(crate) struct Basis<V: Array, Z: Array<Real = V::Real>> {
    /// w.
    pub(crate) vectors: V::Map<Z>,
    /// Mw.
    pub(crate) weighted: V::Map<Z>,
    /// 1/(w·Mw), or zero for an excluded gradient. A square below normal numbers excludes its gradient, too.
    pub(crate) reciprocals: V,
    /// Gradient a is w_a + Σ `coefficients[a][b]` w_b, with the sum over b < a.
    pub(crate) coefficients: Square<V>,
}

impl<V: Array, Z: Array<Real = V::Real>> Basis<V, Z> {
    /// Makes `gradients` orthogonal. `metric` multiplies a vector by M. Precondition: squares of the gradients do not overflow.
    #[inline(always)]
    pub(crate) fn new(gradients: V::Map<Z>, excluded: Excluded, metric: impl Fn(&Z) -> Z) -> Self {
        let (mut vectors, mut weighted) = (gradients, gradients);
        let (mut reciprocals, mut coefficients) = (V::zero(), V::fill(V::zero()));
        for (a, row) in V::entries::<V>(&mut coefficients).iter_mut().enumerate() {
            let (before, rest) = V::entries(&mut vectors).split_at_mut(a);
            let (vector, weighted, reciprocals) = (&mut rest[0], V::entries(&mut weighted), reciprocals.as_mut_slice());
            let whole = dot(vector, &metric(vector)).magnitude();
            // Orthogonalise twice, because rounding leaves a residue if gradients are almost parallel.
            for b in (0..a).chain(0..a) {
                let coefficient = dot(vector, &weighted[b]) * reciprocals[b];
                vector.add_scaled(-coefficient, &before[b]);
                row.as_mut_slice()[b] += coefficient;
            }
            weighted[a] = metric(vector);
            let square = dot(vector, &weighted[a]);
            // NaN is kept.
            let is_excluded = square.magnitude() <= excluded.square::<V::Real>() * whole + V::Real::smallest();
            reciprocals[a] = if is_excluded { zero() } else { V::Real::from_f64(1.0) / square };
        }
        Basis { vectors, weighted, reciprocals, coefficients }
    }
}
