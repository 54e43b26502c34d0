//! H = |p|²/(2m) − μm/|q| in the plane.

use super::increments::{Increments, Sums};
use super::{Stages, fma};

/// Parameters.
pub(crate) struct Kepler {
    pub(crate) m: f64,
    pub(crate) mu: f64,
}

/// q₀, q₁, p₀, p₁.
type Point = [f64; 4];

impl Kepler {
    pub(crate) fn verlet(&self, h: f64, steps: u64, mut z: Point) -> Point {
        let (half, pull, step) = (-0.5 * h * self.mu * self.m, -h * self.mu * self.m, h / self.m);
        kick(half, &mut z);
        for _ in 0..steps {
            drift(step, &mut z);
            kick(pull, &mut z);
        }
        kick(-half, &mut z);
        z
    }

    /// Kicks are the outer flows.
    #[inline]
    pub(crate) fn kicks_first<const K: usize>(&self, stages: Stages<K>, h: f64, steps: u64, mut z: Point) -> Point {
        let Stages { first, inner, outer } = stages.times(-h * self.mu * self.m, h / self.m);
        kick(first, &mut z);
        for _ in 0..steps {
            for i in 0..K {
                drift(inner[i], &mut z);
                kick(outer[i], &mut z);
            }
        }
        kick(-first, &mut z);
        z
    }

    /// Drifts are.
    #[inline]
    pub(crate) fn drifts_first<const K: usize>(&self, stages: Stages<K>, h: f64, steps: u64, mut z: Point) -> Point {
        let Stages { first, inner, outer } = stages.times(h / self.m, -h * self.mu * self.m);
        drift(first, &mut z);
        for _ in 0..steps {
            for i in 0..K {
                kick(inner[i], &mut z);
                drift(outer[i], &mut z);
            }
        }
        drift(-first, &mut z);
        z
    }

    /// q₁ = q₀ + h/m·(p₀ + P/2), p₁ = p₀ + P, P = −hμm·u/D, with u = q₀ + q₁ and D = r₀r₁(r₀ + r₁): the divided difference of
    /// −1/√s is 1/(√s₀√s₁(√s₀ + √s₁)), that of s = x² + y² is u.
    pub(crate) fn discrete_gradient<const CARRIED: bool>(
        &self,
        h: f64,
        steps: u64,
        [mut x, mut y, mut px, mut py]: Point,
    ) -> Point {
        let (pull, step, half) = (h * self.mu * self.m, h / self.m, 0.5 * h / self.m);
        let beta = pull * half;
        let explicit = |z: Point| {
            let [mut x, mut y, px, py] = z;
            (x, y) = (fma(half, px, x), fma(half, py, y));
            let mut kicked = [x, y, 0.0, 0.0];
            kick(-pull, &mut kicked);
            [kicked[2], kicked[3]]
        };
        let mut increments = Increments::new(explicit([x, y, px, py]));
        let mut sums = [Sums::<2, CARRIED>::new(), Sums::new()];
        for _ in 0..steps {
            let r0 = fma(x, x, y * y).sqrt();
            let d = [step * px, step * py];
            let moved = |[a, b]: [f64; 2]| [x + fma(half, a, d[0]), y + fma(half, b, d[1])];
            let [increment, lost] = increments.next(
                [px, py],
                || explicit([x, y, px, py]),
                |increment| {
                    // Newton's matrix times D is (D + β)·1 − β·n/(r₁²·(r₀ + r₁))·u⊗q₁, β = h²μ/2, n = r₀ + 2r₁: one and a matrix of
                    // rank one, inverted by Sherman and Morrison's formula with two divisions side by side.
                    let [x1, y1] = moved(*increment);
                    let s1 = fma(x1, x1, y1 * y1);
                    let r1 = s1.sqrt();
                    let sum = r0 + r1;
                    let d = r0 * r1 * sum;
                    let u = [x + x1, y + y1];
                    let residual = [fma(d, increment[0], pull * u[0]), fma(d, increment[1], pull * u[1])];
                    let bn = beta * (sum + r1);
                    let a = d + beta;
                    let inverse = 1.0 / a;
                    let along =
                        bn * fma(x1, residual[0], y1 * residual[1]) / fma(a, s1 * sum, -bn * fma(x1, u[0], y1 * u[1]));
                    [inverse * fma(along, u[0], residual[0]), inverse * fma(along, u[1], residual[1])]
                },
            );
            if CARRIED {
                let (mut q, mut p) = ([x, y], [px, py]);
                sums[0].add(&mut q, [0, 1].map(|i| fma(half, increment[i], d[i])), [0.0; 2]);
                sums[1].add(&mut p, increment, lost);
                ([x, y], [px, py]) = (q, p);
            } else {
                [x, y] = moved(increment);
                (px, py) = (px + increment[0], py + increment[1]);
            }
        }
        [x, y, px, py]
    }
}

/// p ← p + pull·q/|q|³: one division, one root.
#[inline(always)]
fn kick(pull: f64, [x, y, px, py]: &mut Point) {
    // Not contracted: two products side by side and a sum are sooner there than two fused operations in a row.
    let r2 = *x * *x + *y * *y;
    let f = pull / (r2 * r2.sqrt());
    *px = fma(f, *x, *px);
    *py = fma(f, *y, *py);
}

/// q ← q + step·p.
#[inline(always)]
fn drift(step: f64, [x, y, px, py]: &mut Point) {
    *x = fma(step, *px, *x);
    *y = fma(step, *py, *y);
}
