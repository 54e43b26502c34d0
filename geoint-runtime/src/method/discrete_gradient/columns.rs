//! Projection of a mean velocity onto the vectors v with Gᵀv = 0, for given columns G, in a metric M: v = F − MG(GᵀMG)⁻¹GᵀF.

use super::matrix::Matrix;
use crate::scalar::{Real, zero};
use crate::slope::{before_squares, recip_above};
use crate::space::Array;
use crate::space::vector::{dot, moved, product, scaled};

/// Smallest part of a column that is independent of the columns before it. A column with a smaller part nearly depends on them.
const NEARLY: f64 = 1.0 / 64.0;

/// Columns that are orthogonal in the metric, by Gram and Schmidt, and span the space of the given columns.
pub(super) struct Projector<A: Array, const N: usize> {
    metric: [A; 2],
    /// Powers of two by which columns are multiplied, so that no square overflows or vanishes.
    scales: [A::Real; N],
    orthogonal: [[A; 2]; N],
    /// Each orthogonal column times the metric.
    weighted: [[A; 2]; N],
    /// 1/(w·Mw) of each orthogonal column w. Zero for a column that takes no part. Such a column depends on the columns before it, to rounding or, if
    /// `loose`, nearly, or its square in the metric vanishes.
    reciprocals: [A::Real; N],
    /// Coefficients of column = orthogonal + Σ coefficient·(orthogonal columns before it).
    coefficients: [[A::Real; N]; N],
}

impl<A: Array, const N: usize> Projector<A, N> {
    #[inline(always)]
    pub(super) fn new(metric: [A; 2], columns: [[A; 2]; N], loose: bool) -> Self {
        let none = zero::<A::Real>();
        let scales = columns.map(|column| {
            let sizes = Array::as_slice(&column).iter().map(|x| x.abs());
            before_squares(sizes.fold(none, |sum: A::Real, size| sum + size))
        });
        let columns: [[A; 2]; N] = core::array::from_fn(|a| scaled(scales[a], &columns[a]));
        let (mut weighted, mut reciprocals) = ([<[A; 2]>::zero(); N], [none; N]);
        let (mut orthogonal, mut coefficients) = (columns, [[none; N]; N]);
        for a in 0..N {
            // Orthogonalise twice, because rounding leaves a residue of columns that are almost parallel.
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
                let dependent = loose && square.magnitude() < NEARLY * NEARLY * whole.magnitude();
                if dependent { none } else { recip_above(square, whole) }
            } else if square == none {
                none
            } else {
                A::Real::from_f64(1.0) / square
            };
        }
        Projector { metric, scales, orthogonal, weighted, reciprocals, coefficients }
    }

    /// Returns whether the first column vanishes in the metric.
    #[inline(always)]
    pub(super) fn is_without_first(&self) -> bool {
        self.reciprocals[0] == zero()
    }

    /// Returns F − MGλ, and λ of the orthogonal columns.
    #[inline(always)]
    pub(super) fn projected(&self, velocity: &[A; 2]) -> ([A; 2], [A::Real; N]) {
        let (mut mean, mut weights) = (*velocity, [zero(); N]);
        for a in 0..N {
            weights[a] = dot(&self.orthogonal[a], velocity) * self.reciprocals[a];
            mean = moved(&mean, -weights[a], &self.weighted[a]);
        }
        (mean, weights)
    }

    /// Turns the derivative of F by d into the derivative of v, from Gᵀdv = −dGᵀv and dv + MG dλ = dF − M dG λ. `of_first` is the derivative of the
    /// first column. `of_others` gives the symmetric derivatives of the other columns as functions of a vector. The derivative of M is left out: its
    /// term is of the order of λ.
    #[inline(always)]
    pub(super) fn derivative(
        &self,
        (slope, v): (&mut Matrix<A>, &[A; 2]),
        (of_first, weights): (&mut Matrix<A>, &[A::Real; N]),
        of_others: impl Fn(&[A; 2]) -> [[A; 2]; N],
    ) {
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
                let bent = of_others(&unit);
                for a in 1..N {
                    row.add_scaled(-lambda[a] * weight, &bent[a]);
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
        let powers: [[A; 2]; N] = core::array::from_fn(|a| {
            let power = moved(&products[a], A::Real::from_f64(1.0), &slope.transpose_times(&self.orthogonal[a]));
            scaled(self.reciprocals[a], &power)
        });
        for (i, row) in slope.rows().iter_mut().enumerate() {
            for a in 0..N {
                row.add_scaled(-Array::as_slice(&self.weighted[a])[i], &powers[a]);
            }
        }
    }
}
