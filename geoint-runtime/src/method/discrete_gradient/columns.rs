//! Projection of a mean velocity F onto the vectors v with Gᵀv = 0: v = F − MGλ with λ = (GᵀMG)⁻¹GᵀF.
//!
//! The N columns of G are discrete gradients of invariants, so a step h v keeps the invariants. Column 0 is the tree discrete gradient of the energy, or zero
//! if the energy reads time. The other columns are gradients of momenta at the midpoint of the step.
//!
//! The diagonal matrix M is the inverse of a metric: MGλ is the correction of F that is shortest in M⁻¹. A length needs a metric, because coordinates have
//! different units.
//!
//! The columns are replaced by orthogonal columns w of the same space, with one weight each: MGλ = Σ weight·Mw. A column that depends on the columns before it
//! leaves a w of rounding only. It adds no condition, and its weight would amplify rounding, so it is excluded.

use super::matrix::Matrix;
use crate::scalar::{Real, zero};
use crate::slope::{before_squares, recip_above};
use crate::space::Array;
use crate::space::vector::{dot, moved, product, scaled};

/// Smallest length of the part of a column that is independent of the columns before it, relative to the column. A chosen bound: with a smaller part, the
/// projection would amplify errors of the column by more than 64. Used only if nearly dependent columns are dropped.
const LEAST_INDEPENDENT_PART: f64 = 1.0 / 64.0;

/// Orthogonal columns w of the space of the given columns, w_a·Mw_b = 0 for a ≠ b, by the Gram–Schmidt process.
pub(super) struct Projector<A: Array, const N: usize> {
    /// The diagonal of M.
    metric: [A; 2],
    /// Powers of two that multiply the given columns, so that squares neither overflow nor vanish.
    scales: [A::Real; N],
    /// w.
    orthogonal: [[A; 2]; N],
    /// Mw.
    weighted: [[A; 2]; N],
    /// 1/(w·Mw). Zero excludes a column: its square w·Mw vanishes, or it depends on the columns before it up to rounding. If nearly dependent columns are
    /// dropped, the bound is [`LEAST_INDEPENDENT_PART`] instead of rounding.
    reciprocals: [A::Real; N],
    /// The scaled column a is w_a + Σ `coefficients[a][b]` w_b, with the sum over b < a.
    coefficients: [[A::Real; N]; N],
}

impl<A: Array, const N: usize> Projector<A, N> {
    /// Orthogonalises the `columns` of G with the product a·Mb. `metric` is the diagonal of M. If `drop_dependent` is true, it excludes columns that nearly
    /// depend on the columns before them. The step then does not keep their invariants.
    #[inline(always)]
    pub(super) fn new(metric: [A; 2], columns: [[A; 2]; N], drop_dependent: bool) -> Self {
        let none = zero::<A::Real>();
        let scales = columns.map(|column| {
            let sizes = Array::as_slice(&column).iter().map(|x| x.abs());
            before_squares(sizes.fold(none, |sum: A::Real, size| sum + size))
        });
        let columns: [[A; 2]; N] = core::array::from_fn(|a| scaled(scales[a], &columns[a]));
        let (mut weighted, mut reciprocals) = ([<[A; 2]>::zero(); N], [none; N]);
        let (mut orthogonal, mut coefficients) = (columns, [[none; N]; N]);
        for a in 0..N {
            // Orthogonalise twice, because rounding leaves a residue if columns are almost parallel.
            for _ in 0..if a == 0 { 0 } else { 2 } {
                for b in 0..a {
                    let coefficient = dot(&orthogonal[a], &weighted[b]) * reciprocals[b];
                    orthogonal[a] = moved(&orthogonal[a], -coefficient, &orthogonal[b]);
                    coefficients[a][b] += coefficient;
                }
            }
            weighted[a] = product(&metric, &orthogonal[a]);
            let square = dot(&orthogonal[a], &weighted[a]);
            reciprocals[a] = if a > 0 {
                let whole = dot(&columns[a], &product(&metric, &columns[a]));
                let is_dropped = drop_dependent
                    && square.magnitude() < LEAST_INDEPENDENT_PART * LEAST_INDEPENDENT_PART * whole.magnitude();
                if is_dropped { none } else { recip_above(square, whole) }
            } else if square == none {
                none
            } else {
                A::Real::from_f64(1.0) / square
            };
        }
        Projector { metric, scales, orthogonal, weighted, reciprocals, coefficients }
    }

    /// Returns whether the first column is excluded, because its square w·Mw is zero.
    #[inline(always)]
    pub(super) fn excludes_first(&self) -> bool {
        self.reciprocals[0] == zero()
    }

    /// Returns v = F − Σ weight·Mw for the `velocity` F, and the weights (w·F)/(w·Mw).
    #[inline(always)]
    pub(super) fn projected(&self, velocity: &[A; 2]) -> ([A; 2], [A::Real; N]) {
        let (mut projected, mut weights) = (*velocity, [zero(); N]);
        for a in 0..N {
            weights[a] = dot(&self.orthogonal[a], velocity) * self.reciprocals[a];
            projected = moved(&projected, -weights[a], &self.weighted[a]);
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
                lambda[a] -= self.coefficients[later][a] * lambda[later];
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
                products[a] = moved(&products[a], -self.coefficients[a][b], &products[b]);
            }
        }
        // Row a contains the coefficients of Mw_a in MG dλ: (w_a·(dF − M dG λ) + (dGᵀv)_a)/(w_a·Mw_a), from the product of Gᵀ with the differential above.
        // `slope` is dF − M dG λ at this point.
        let weight_slopes: [[A; 2]; N] = core::array::from_fn(|a| {
            let rate = moved(&products[a], A::Real::from_f64(1.0), &slope.transpose_times(&self.orthogonal[a]));
            scaled(self.reciprocals[a], &rate)
        });
        for (i, row) in slope.rows().iter_mut().enumerate() {
            for a in 0..N {
                row.add_scaled(-Array::as_slice(&self.weighted[a])[i], &weight_slopes[a]);
            }
        }
    }
}
