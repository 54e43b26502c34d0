//! Newton's iteration for the momentum increment of an implicit step, started from the increments before it.
//!
//! Increments of a smooth motion are smooth in time. A polynomial through the last nine foretells the next so well that one
//! evaluation is enough in almost every step of these benches: what it leaves is the square of a small correction. Where a step
//! is too long for that, the force half a step ahead is the better guess, and at very long steps the only one that is safe.

/// How many increments are extrapolated.
const POINTS: usize = 9;

/// xₙ = Σ (−1)ʲ⁺¹ (9 choose j) xₙ₋ⱼ, j = 1 … 9: as if the ninth difference were zero.
const WEIGHTS: [f64; POINTS] = [9.0, -36.0, 84.0, -126.0, 126.0, -84.0, 36.0, -9.0, 1.0];

/// What the next correction is bound to be below, relative to the momentum, when the iteration ends.
const ROUNDING: f64 = f64::EPSILON / 1024.0;

/// The increments before a step, the latest first.
pub(crate) struct Increments<const N: usize> {
    latest: [[f64; N]; POINTS],
    /// The last step took more than two evaluations: the next starts from the explicit guess.
    rough: bool,
}

impl<const N: usize> Increments<N> {
    /// As if all had been the same, which the first extrapolation then gives back.
    pub(crate) fn new(first: [f64; N]) -> Self {
        Increments { latest: [first; POINTS], rough: false }
    }

    /// The next increment: where Newton's `correction`, to be subtracted, has nothing left to correct in p + x. And what the last
    /// subtraction rounded off.
    #[inline(always)]
    pub(crate) fn next(
        &mut self,
        p: [f64; N],
        explicit: impl Fn() -> [f64; N],
        correction: impl Fn(&[f64; N]) -> [f64; N],
    ) -> [[f64; N]; 2] {
        let mut lost = [0.0; N];
        let mut x = if self.rough { explicit() } else { self.extrapolated() };
        let mut before = f64::INFINITY;
        let mut evaluations = 0;
        loop {
            let delta = correction(&x);
            for i in 0..N {
                let before = x[i];
                x[i] -= delta[i];
                lost[i] = (before - x[i]) - delta[i];
            }
            evaluations += 1;
            let (change, size) = (square(&delta), square(&p) + square(&x));
            if ends(evaluations, before, change, size) {
                break;
            }
            assert!(change < f64::INFINITY && evaluations < 40, "no convergence");
            before = change;
        }
        self.rough = evaluations > 2;
        for j in (1..POINTS).rev() {
            self.latest[j] = self.latest[j - 1];
        }
        self.latest[0] = x;
        [x, lost]
    }

    /// From the oldest on: only one product and one sum wait for the latest increment.
    #[inline(always)]
    fn extrapolated(&self) -> [f64; N] {
        let mut x = [0.0; N];
        for j in (0..POINTS).rev() {
            for i in 0..N {
                x[i] = super::fma(WEIGHTS[j], self.latest[j][i], x[i]);
            }
        }
        x
    }
}

/// Sums of increments; if they are `CARRIED`, what each addition rounds off goes into the next one.
pub(crate) struct Sums<const N: usize, const CARRIED: bool> {
    carry: [f64; N],
}

impl<const N: usize, const CARRIED: bool> Sums<N, CARRIED> {
    pub(crate) fn new() -> Self {
        Sums { carry: [0.0; N] }
    }

    /// x ← x + change, where the change has lost some digits before.
    #[inline(always)]
    pub(crate) fn add(&mut self, x: &mut [f64; N], change: [f64; N], lost: [f64; N]) {
        for i in 0..N {
            if CARRIED {
                let change_now = change[i] + self.carry[i];
                let first = self.carry[i] - (change_now - change[i]);
                let sum = x[i] + change_now;
                let added = sum - x[i];
                let second = (x[i] - (sum - added)) + (change_now - added);
                (x[i], self.carry[i]) = (sum, first + second + lost[i]);
            } else {
                x[i] += change[i];
            }
        }
    }
}

/// Whether the next correction is bound to be lost in rounding; squares of sizes, so that nothing takes a root.
///
/// A first correction c is followed by c², relative to what is corrected, and one that shrank by θ by one that shrinks by θ².
/// Where corrections do not shrink by four any more, and are small, they are rounding.
#[inline(always)]
fn ends(evaluations: u32, before: f64, change: f64, size: f64) -> bool {
    if evaluations == 1 {
        return change <= ROUNDING * size;
    }
    let shrunk = change / before;
    change * shrunk * shrunk <= ROUNDING * ROUNDING * size || (shrunk > 1.0 / 16.0 && change <= 1e-18 * size)
}

#[inline(always)]
fn square<const N: usize>(x: &[f64; N]) -> f64 {
    let mut sum = 0.0;
    for x in x {
        sum = super::fma(*x, *x, sum);
    }
    sum
}
