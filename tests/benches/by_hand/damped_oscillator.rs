//! H = p²/2 + q²/2 + γs without the action: half a damped drift, a kick, half a damped drift; drifts of neighbouring steps are one.

use super::fma;

/// Parameters.
pub(crate) struct DampedOscillator {
    pub(crate) gamma: f64,
}

impl DampedOscillator {
    pub(crate) fn steps(&self, h: f64, steps: u64, [mut q, mut p]: [f64; 2]) -> [f64; 2] {
        let drift = |h: f64| {
            let lost = -(-self.gamma * h).exp_m1();
            (lost / self.gamma, 1.0 - lost)
        };
        let [half, whole, back] = [0.5 * h, h, -0.5 * h].map(drift);
        (q, p) = (fma(half.0, p, q), half.1 * p);
        for _ in 0..steps {
            p = fma(-h, q, p);
            (q, p) = (fma(whole.0, p, q), whole.1 * p);
        }
        (q, p) = (fma(back.0, p, q), back.1 * p);
        [q, p]
    }
}
