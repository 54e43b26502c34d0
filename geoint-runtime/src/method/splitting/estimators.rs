//! What the forces of a step tell of its error: weights of kicks in two estimates.
//!
//! With a quadratic T a table is a method of Runge–Kutta–Nyström type. Other weights b̂ᵢ of the same forces are another one, of lower order, and
//! Σ (bᵢ − b̂ᵢ) h fᵢ is the error of that: as small as hʳ⁺¹, if the differences dᵢ = bᵢ − b̂ᵢ solve the conditions of orders 1 to r, which are linear in
//! them (E. Hairer, S. P. Nørsett & G. Wanner, *Solving Ordinary Differential Equations I* (1993), section II.14).

use crate::method::tables::total::adds_up;

/// The differences dᵢ of all kicks of a step, by the first half of them, the middle included.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) enum Mirrored<const HALF: usize> {
    /// They read the same from both ends: what they find is odd in h.
    Same([f64; HALF]),
    /// From the other end they have the other sign: what they find is even in h.
    Opposite([f64; HALF]),
}

impl<const HALF: usize> Mirrored<HALF> {
    /// The n-th of `kicks` differences.
    const fn at(&self, n: usize, kicks: usize) -> f64 {
        match self {
            Mirrored::Same(half) => half[if n < HALF { n } else { kicks - 1 - n }],
            Mirrored::Opposite(half) if n < HALF => half[n],
            Mirrored::Opposite(half) => -half[kicks - 1 - n],
        }
    }
}

/// By what each kick is multiplied in an error of the momenta, and in one of the positions, of which only the drift over h is to come.
pub(super) type Weights = [f64; 2];

/// Two estimates of the error of a step, e₅ of the higher order and e₃: the error is taken to be e₅²/(e₅² + e₃²/100)½, which is of the order of the
/// method. Of all solutions of the conditions they are those that see most of the next order, so large that a tolerance leads to no larger errors
/// than comparing with halves of steps does (Kepler's problem, e = 0.6).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimators<const K: usize> {
    /// Of the first K kicks, in both estimates.
    kicks: [[Weights; 2]; K],
    /// Of a kick at the end of a step.
    last: [f64; 2],
}

impl<const K: usize> Estimators<K> {
    /// For kicks with fractions bᵢ of h, K of them and perhaps one at the end, after drifts over the fractions cᵢ.
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
                // A kick has added h bᵢ fᵢ.
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

    /// Of the n-th kick, in both estimates.
    #[inline(always)]
    pub(super) fn of_kick(&self, n: usize) -> [Weights; 2] {
        if n < K { self.kicks[n] } else { self.last.map(|weight| [weight, 0.0]) }
    }
}
