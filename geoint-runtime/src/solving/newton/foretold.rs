//! The correction that would follow two of one unknown.

use super::iteration::Iteration;
use crate::scalar::Real;
use crate::space::Array;

/// What is left, in units of ε, is foretold where no more than this is.
const LITTLE: f64 = 1.0 / 1024.0;

/// The first of both corrections, in units of the size of the unknown: to such a part the curvature is the same at both points, and what is left is
/// foretold.
const SHORT: f64 = 1.0 / 128.0;

impl<A: Array> Iteration<A> {
    /// What is left after two corrections of one unknown, c₁ and c₂: convergence is quadratic, c₂ = Kc₁², and the next one is Kc₂² = c₂(c₂/c₁)², sign
    /// and all. Of more unknowns K depends on the direction. None where that would be too much to be foretold.
    #[inline(always)]
    pub(super) fn foretold(&self, first: &A, second: &A) -> Option<A> {
        if A::LEN != 1 {
            return None;
        }
        let mut next = *second;
        let ratio = second.as_slice()[0] / first.as_slice()[0];
        next.as_mut_slice()[0] *= ratio * ratio;
        let is_little = self.sizes.all_within(first, SHORT)
            && self.sizes.all_within(&next, LITTLE * A::Real::epsilon())
            && !self.looks();
        is_little.then_some(next)
    }
}

#[cfg(test)]
mod tests {
    use super::super::curved::{Count, Curved};
    use super::super::{Found, Newton};

    const K: f64 = 0.003;

    #[test]
    fn a_third_correction_of_one_unknown_is_carried_and_not_evaluated() {
        let (mut newton, mut count, mut largest) = (Newton::<[f32; 1]>::new(1, 1), Count(0), 0.0_f64);
        for n in 0..1000 {
            // What eleven increments miss of that is 0.4.
            let exact = 1.5 + 20.0 * (0.72 * f64::from(n)).sin();
            let equation = Curved { a: exact - K * exact * exact, b: 0.0, c: K };
            let Found { x: [x], lost: [lost], outcome } = newton.solve(&equation, &mut count);
            assert!(outcome.is_ok());
            let left = f64::from(x) + f64::from(lost) - exact;
            largest = largest.max(left.abs());
        }
        // Two evaluations leave 1e-9.
        assert!(count.0 < 2200 && largest < 5e-10, "{} {largest:.1e}", count.0);
    }
}
