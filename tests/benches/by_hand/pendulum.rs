//! H = p²/(2ml²) − mgl·cos q.

use super::increments::{Increments, Sums};
use super::{Stages, fma};

/// Parameters.
pub(crate) struct Pendulum {
    pub(crate) m: f64,
    pub(crate) l: f64,
    pub(crate) g: f64,
}

impl Pendulum {
    fn drift(&self, h: f64) -> f64 {
        h / (self.m * self.l * self.l)
    }

    /// The torque is −mgl·sin q.
    fn kick(&self, h: f64) -> f64 {
        -h * self.m * self.g * self.l
    }

    pub(crate) fn verlet(&self, h: f64, steps: u64, (mut q, mut p): (f64, f64)) -> (f64, f64) {
        let (half, kick, drift) = (self.kick(0.5 * h), self.kick(h), self.drift(h));
        p = fma(half, q.sin(), p);
        for _ in 0..steps {
            q = fma(drift, p, q);
            p = fma(kick, q.sin(), p);
        }
        p = fma(-half, q.sin(), p);
        (q, p)
    }

    /// Kicks are the outer flows.
    #[inline]
    pub(crate) fn kicks_first<const K: usize>(
        &self,
        stages: Stages<K>,
        h: f64,
        steps: u64,
        (mut q, mut p): (f64, f64),
    ) -> (f64, f64) {
        let Stages { first, inner, outer } = stages.times(self.kick(h), self.drift(h));
        p = fma(first, q.sin(), p);
        for _ in 0..steps {
            for i in 0..K {
                q = fma(inner[i], p, q);
                p = fma(outer[i], q.sin(), p);
            }
        }
        p = fma(-first, q.sin(), p);
        (q, p)
    }

    /// Drifts are.
    #[inline]
    pub(crate) fn drifts_first<const K: usize>(
        &self,
        stages: Stages<K>,
        h: f64,
        steps: u64,
        (mut q, mut p): (f64, f64),
    ) -> (f64, f64) {
        let Stages { first, inner, outer } = stages.times(self.drift(h), self.kick(h));
        q = fma(first, p, q);
        for _ in 0..steps {
            for i in 0..K {
                p = fma(inner[i], q.sin(), p);
                q = fma(outer[i], p, q);
            }
        }
        q = fma(-first, p, q);
        (q, p)
    }

    /// q₁ = q₀ + 2u, p₁ = p₀ + P, with u = h/(2ml²)·(p₀ + P/2) and P = −h·mgl·sin(q₀ + u)·sin u/u, which is
    /// h·mgl·(cos q₁ − cos q₀)/(q₁ − q₀).
    pub(crate) fn discrete_gradient<const CARRIED: bool>(
        &self,
        h: f64,
        steps: u64,
        (mut q, mut p): (f64, f64),
    ) -> (f64, f64) {
        let (kick, half, quarter) = (self.kick(h), 0.5 * self.drift(h), 0.25 * self.drift(h));
        let explicit = |q: f64, p: f64| [kick * fma(half, p, q).sin()];
        let mut increments = Increments::new(explicit(q, p));
        let mut sums = [Sums::<1, CARRIED>::new(), Sums::new()];
        for _ in 0..steps {
            let u = half * p;
            let u = |increment: f64| fma(quarter, increment, u);
            let [[increment], lost] = increments.next(
                [p],
                || explicit(q, p),
                |&[x]| {
                    let u = u(x);
                    let (sin, cos) = (q + u).sin_cos();
                    let (sinc, slope) = sinc(u);
                    let residual = fma(-kick, sin * sinc, x);
                    let derivative = fma(-quarter * kick, fma(cos, sinc, sin * slope), 1.0);
                    [residual / derivative]
                },
            );
            if CARRIED {
                let (mut end, mut momentum) = ([q], [p]);
                sums[0].add(&mut end, [2.0 * u(increment)], [0.0]);
                sums[1].add(&mut momentum, [increment], lost);
                ([q], [p]) = (end, momentum);
            } else {
                q = fma(2.0, u(increment), q);
                p += increment;
            }
        }
        (q, p)
    }
}

/// sin u/u and its derivative.
#[inline(always)]
fn sinc(u: f64) -> (f64, f64) {
    if u.abs() >= 1.0 {
        let (sin, cos) = u.sin_cos();
        return (sin / u, (cos - sin / u) / u);
    }
    // The series Σ (−1)ᵏ u²ᵏ/(2k + 1)!, its remainder below 10⁻¹⁷, and its derivative term by term.
    const SERIES: [f64; 9] = series();
    let y = u * u;
    let (mut value, mut slope) = (SERIES[8], 0.0);
    for k in (0..8).rev() {
        slope = fma(slope, y, value);
        value = fma(value, y, SERIES[k]);
    }
    (value, 2.0 * u * slope)
}

const fn series() -> [f64; 9] {
    let mut terms = [1.0; 9];
    let mut k = 1;
    while k < 9 {
        terms[k] = -terms[k - 1] / (2 * k * (2 * k + 1)) as f64;
        k += 1;
    }
    terms
}
