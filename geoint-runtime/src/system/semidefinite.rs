//! Checks that a damping matrix C never adds energy: its power −vᵀCv must not be positive for any velocity v.

use crate::scalar::Real;

/// Returns whether vᵀCv ≥ 0 for all v, to rounding, by symmetric elimination without exchanges. The result is `false` if an entry that is read is NaN.
///
/// Precondition: C is symmetric. Only its lower triangle is read. The diagonal is enlarged by the factor 1 + 8N²ε, more than the rounding errors of the
/// elimination (J. Demmel 1989: LAPACK Working Note 14). A matrix that is singular on paper therefore passes.
pub fn is_positive_semidefinite<R: Real, const N: usize>(mut c: [[R; N]; N]) -> bool {
    let margin = R::from_f64(1.0 + 8.0 * (N * N) as f64 * R::epsilon());
    for (k, row) in c.iter_mut().enumerate() {
        row[k] *= margin;
    }
    for k in 0..N {
        // Products below the smallest normal number are rounded without regard to their size.
        if !(c[k][k] + R::from_f64(R::smallest())).all_at_least_zero() {
            return false;
        }
        // A pivot that is zero, or subnormal, requires zeros below it.
        let pivot = c[k][k];
        if pivot.any_not_positive() && (k + 1..N).any(|i| c[i][k].magnitude() > 0.0) {
            return false;
        }
        for i in k + 1..N {
            let factor = c[i][k] / pivot.max(R::from_f64(R::smallest()));
            for j in k + 1..=i {
                c[i][j] -= factor * c[j][k];
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::is_positive_semidefinite;

    #[test]
    fn definite_singular_and_neither() {
        assert!(is_positive_semidefinite([[2.0, -1.0], [-1.0, 3.0]]));
        assert!(is_positive_semidefinite([[0.0_f64; 3]; 3]));
        assert!(is_positive_semidefinite([[0.0, 0.0, 0.0], [0.0, 1.0, 2.0], [0.0, 2.0, 4.0]]));
        assert!(!is_positive_semidefinite([[1.0, 2.0], [2.0, 3.9]]));
        assert!(!is_positive_semidefinite([[0.0, 1e-9], [1e-9, 1.0]]));
        assert!(!is_positive_semidefinite([[0.0_f32, 1e-9], [1e-9, 1.0]]));
        assert!(!is_positive_semidefinite([[-1e-30]]) && !is_positive_semidefinite([[f64::NAN]]));
        // The friction of a slow velocity v, c(1, −v)(1, −v)ᵀ.
        let (c, v) = (0.1471, 110.0 / 37.0 * 1e-160);
        assert!(is_positive_semidefinite([[c, -c * v], [-c * v, v * v * c]]));
        // The result is the same in any units.
        for unit in [1e-200, 1.0, 1e200] {
            let scaled = |c: [[f64; 2]; 2]| c.map(|row| row.map(|x| x * unit));
            assert!(is_positive_semidefinite(scaled([[2.0, -1.0], [-1.0, 3.0]])));
            assert!(!is_positive_semidefinite(scaled([[1.0, 2.0], [2.0, 3.9]])));
        }
        // Every block of two is positive, but the whole matrix is not: the eigenvalue of (1, 1, 1) is 1 − 2·0.6.
        let c = [[1.0, -0.6, -0.6], [-0.6, 1.0, -0.6], [-0.6, -0.6, 1.0]];
        assert!(!is_positive_semidefinite(c));
    }

    /// Checks v vᵀ + w wᵀ for irrational v and w. On paper, this matrix is positive semidefinite of rank 2. Here its entries are rounded.
    #[test]
    fn rounding_is_no_reason() {
        let [v, w]: [[f64; 5]; 2] =
            [core::array::from_fn(|i| libm::sin(1.7 * i as f64)), core::array::from_fn(|i| libm::cos(0.3 * i as f64))];
        let c = core::array::from_fn(|i| core::array::from_fn(|j| v[i] * v[j] + w[i] * w[j]));
        assert!(is_positive_semidefinite(c));
        let mut d = c;
        d[4][4] -= 1e-12;
        assert!(!is_positive_semidefinite::<f64, 5>(d));
    }
}
