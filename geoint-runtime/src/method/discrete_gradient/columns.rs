//! Projection of a mean velocity F onto the vectors v with Gᵀv = 0: v = F − MGλ with λ = (GᵀMG)⁻¹GᵀF.
//!
//! The N columns of G are discrete gradients of invariants, so a step h v keeps the invariants. Column 0 is the tree discrete gradient of the energy, or zero
//! if the energy reads time. The other columns are gradients of momenta at the midpoint of the step.
//!
//! The diagonal matrix M is the inverse of a metric: MGλ is the correction of F that is shortest in M⁻¹. A length needs a metric, because coordinates have
//! different units.
//!
//! The columns are replaced by orthogonal columns w of the same space ([`Basis`]), with one weight each: MGλ = Σ weight·Mw.

use super::matrix::Matrix;
use crate::method::corrected::basis::{Basis, Excluded};
use crate::scalar::{Real, zero};
use crate::slope::before_squares;
use crate::space::Array;
use crate::space::vector::{dot, moved, product, scaled};

/// An orthogonal basis of the columns of G.
pub(super) struct Projector<A: Array, const N: usize> {
    /// The diagonal of M.
    metric: [A; 2],
    /// Powers of two that multiply the given columns, so that squares neither overflow nor vanish.
    scales: [A::Real; N],
    /// The basis of the scaled columns.
    basis: Basis<[A::Real; N], [A; 2]>,
}

impl<A: Array, const N: usize> Projector<A, N> {
    /// Makes the `columns` of G orthogonal with the product a·Mb. `metric` is the diagonal of M. The step does not keep invariants with excluded columns.
    #[inline(always)]
    pub(super) fn new(metric: [A; 2], columns: [[A; 2]; N], excluded: Excluded) -> Self {
        let scales = columns.map(|column| {
            let sizes = Array::as_slice(&column).iter().map(|x| x.abs());
            before_squares(sizes.fold(zero(), |sum: A::Real, size| sum + size))
        });
        let columns: [[A; 2]; N] = core::array::from_fn(|a| scaled(scales[a], &columns[a]));
        Projector { metric, scales, basis: Basis::new(columns, excluded, |column| product(&metric, column)) }
    }

    /// Returns whether the first column is excluded, because its square w·Mw vanishes.
    #[inline(always)]
    pub(super) fn excludes_first(&self) -> bool {
        self.basis.reciprocals[0] == zero()
    }

    /// Returns v = F − Σ weight·Mw for the `velocity` F, and the weights (w·F)/(w·Mw).
    #[inline(always)]
    pub(super) fn projected(&self, velocity: &[A; 2]) -> ([A; 2], [A::Real; N]) {
        let (mut projected, mut weights) = (*velocity, [zero(); N]);
        for a in 0..N {
            weights[a] = dot(&self.basis.vectors[a], velocity) * self.basis.reciprocals[a];
            projected = moved(&projected, -weights[a], &self.basis.weighted[a]);
        }
        (projected, weights)
    }

    /// Replaces the derivative ∂F/∂d in `slope` by ∂v/∂d, where d is the increment of the step, on which F and G depend. The derivative follows from the
    /// differentials Gᵀdv = −dGᵀv and dv + MG dλ = dF − M dG λ.
    ///
    /// [`projected`](Self::projected) returned v with `weights`. `of_first` is the derivative of the first given column by d. `of_others` returns the products
    /// of a vector with the derivatives of the other columns; its entry 0 is not read. Precondition: the derivatives of the others are symmetric.
    ///
    /// The derivative of M is omitted, so the result is approximate. The omitted term is O(λ), and λ is small because F has order 4. Limit: the corrections of
    /// Newton's iteration then have a small linear part, which its constant C does not model.
    #[inline(always)]
    pub(super) fn derivative(
        &self,
        (slope, v): (&mut Matrix<A>, &[A; 2]),
        (of_first, weights): (&mut Matrix<A>, &[A::Real; N]),
        of_others: impl Fn(&[A; 2]) -> [[A; 2]; N],
    ) {
        // λ of the given columns, from the weights of the orthogonal columns.
        let mut lambda = *weights;
        for a in (0..N).rev() {
            for later in a + 1..N {
                lambda[a] -= self.basis.coefficients[later][a] * lambda[later];
            }
        }
        for (lambda, scale) in lambda.iter_mut().zip(&self.scales) {
            *lambda *= *scale;
        }
        for (i, row) in slope.rows().iter_mut().enumerate() {
            let weight = Array::as_slice(&self.metric)[i];
            row.add_scaled(-lambda[0] * weight, &of_first.rows()[i]);
            if N > 1 {
                let mut unit = <[A; 2]>::zero();
                Array::as_mut_slice(&mut unit)[i] = A::Real::from_f64(1.0);
                let derivative_rows = of_others(&unit);
                for a in 1..N {
                    row.add_scaled(-lambda[a] * weight, &derivative_rows[a]);
                }
            }
        }
        // dGᵀv of the given columns, then of the orthogonal columns.
        let mut products = if N > 1 { of_others(v) } else { [<[A; 2]>::zero(); N] };
        products[0] = of_first.transpose_times(v);
        for a in 0..N {
            products[a] = scaled(self.scales[a], &products[a]);
            for b in 0..a {
                products[a] = moved(&products[a], -self.basis.coefficients[a][b], &products[b]);
            }
        }
        // Row a contains the coefficients of Mw_a in MG dλ: (w_a·(dF − M dG λ) + (dGᵀv)_a)/(w_a·Mw_a), from the product of Gᵀ with the differential above.
        // `slope` is dF − M dG λ at this point.
        let weight_slopes: [[A; 2]; N] = core::array::from_fn(|a| {
            let rate = moved(&products[a], A::Real::from_f64(1.0), &slope.transpose_times(&self.basis.vectors[a]));
            scaled(self.basis.reciprocals[a], &rate)
        });
        for (i, row) in slope.rows().iter_mut().enumerate() {
            for a in 0..N {
                row.add_scaled(-Array::as_slice(&self.basis.weighted[a])[i], &weight_slopes[a]);
            }
        }
    }
}
