//! Two estimates of the error of a step, from the forces that the step evaluates.
//!
//! With a quadratic T a table is a Runge–Kutta–Nyström method with weights bᵢ. Other weights b̂ᵢ of the same forces fᵢ define an embedded method of lower
//! order. The estimate is Σ dᵢ h fᵢ with the differences dᵢ = bᵢ − b̂ᵢ. It is O(hʳ⁺¹) if the dᵢ satisfy the order conditions 1 to r, which are linear in dᵢ.
//! E. Hairer, S. P. Nørsett & G. Wanner, *Solving Ordinary Differential Equations I* (1993), section II.14.

use crate::method::tables::total::adds_up;

/// The differences dᵢ of all kicks of a step, given by the first half with the middle included.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) enum Mirrored<const HALF: usize> {
    /// Symmetric: the n-th difference from the end equals the n-th from the start. The estimate is odd in h.
    Same([f64; HALF]),
    /// Antisymmetric: the n-th difference from the end is minus the n-th from the start. The estimate is even in h.
    Opposite([f64; HALF]),
}

impl<const HALF: usize> Mirrored<HALF> {
    /// Returns the n-th of `kicks` differences.
    const fn at(&self, n: usize, kicks: usize) -> f64 {
        match self {
            Mirrored::Same(half) => half[if n < HALF { n } else { kicks - 1 - n }],
            Mirrored::Opposite(half) if n < HALF => half[n],
            Mirrored::Opposite(half) => -half[kicks - 1 - n],
        }
    }
}

/// Factors of the impulse of one kick in two sums. The first sum is the error of the momenta. The drift of the second sum over h is the error of the
/// positions, so the second factor contains the fraction 1 − c of the step that follows the kick.
pub(super) type Weights = [f64; 2];

/// Weights of two estimates of the error of a step, e₅ of the higher order and e₃.
///
/// The error is taken to be e₅²/(e₅² + e₃²/100)½, which has the order of the method.
///
/// Of all solutions of the order conditions, these weights are the most sensitive to the next order. The scale is chosen by Kepler's problem with e = 0.6: a
/// tolerance leads to errors no larger than a comparison with two half steps does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimators<const K: usize> {
    /// Weights of the first K kicks in both estimates.
    kicks: [[Weights; 2]; K],
    /// Weights of a kick at the end of a step for the momenta, in both estimates. This kick does not move the positions.
    last: [f64; 2],
}

impl<const K: usize> Estimators<K> {
    /// Computes the weights for K kicks with fractions bᵢ of h after drifts over the fractions cᵢ.
    ///
    /// `last` is the fraction of a kick at the end of the step, or 0.
    pub(super) const fn new<const HALF: usize>(
        (b, last, c): (&[f64; K], f64, &[f64; K]),
        differences: [Mirrored<HALF>; 2],
    ) -> Self {
        let count = if last == 0.0 { K } else { K + 1 };
        assert!(HALF == count.div_ceil(2), "the first half of the kicks, the middle included");
        let mut estimators = Estimators { kicks: [[[0.0; 2]; 2]; K], last: [0.0; 2] };
        let mut which = 0;
        while which < 2 {
            let (mut all, mut end, mut n) = ([0.0; K], 0.0, 0);
            while n < K {
                all[n] = differences[which].at(n, count);
                // The impulse of a kick is h bᵢ fᵢ.
                let weight = all[n] / b[n];
                estimators.kicks[n][which] = [weight, weight * (1.0 - c[n])];
                n += 1;
            }
            if last != 0.0 {
                end = differences[which].at(K, count);
                estimators.last[which] = end / last;
            }
            assert!(adds_up(&all, -end), "differences of weights add up to 0");
            which += 1;
        }
        estimators
    }

    /// Returns the weights of the n-th kick in both estimates.
    #[inline(always)]
    pub(super) fn of_kick(&self, n: usize) -> [Weights; 2] {
        if n < K { self.kicks[n] } else { self.last.map(|weight| [weight, 0.0]) }
    }
}
