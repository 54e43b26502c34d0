//! H = (|p|² + x² + y²)/2 + λ(x²y − y³/3).

use super::increments::{Increments, Sums};
use super::{Stages, fma};

/// Parameters.
pub(crate) struct HenonHeiles {
    pub(crate) lambda: f64,
}

/// x, y and their momenta.
type Point = [f64; 4];

/// A kick of length h: −h, −hλ and −2hλ.
#[derive(Clone, Copy)]
struct Kick {
    linear: f64,
    square: f64,
    cross: f64,
}

impl HenonHeiles {
    fn kick(&self, h: f64) -> Kick {
        Kick { linear: -h, square: -h * self.lambda, cross: -2.0 * h * self.lambda }
    }

    pub(crate) fn verlet<const TERM_BY_TERM: bool>(&self, h: f64, steps: u64, mut z: Point) -> Point {
        let (half, whole) = (self.kick(0.5 * h), self.kick(h));
        half.apply::<TERM_BY_TERM>(&mut z);
        for _ in 0..steps {
            drift(h, &mut z);
            whole.apply::<TERM_BY_TERM>(&mut z);
        }
        self.kick(-0.5 * h).apply::<TERM_BY_TERM>(&mut z);
        z
    }

    /// Kicks are the outer flows.
    #[inline]
    pub(crate) fn kicks_first<const TERM_BY_TERM: bool, const K: usize>(
        &self,
        stages: Stages<K>,
        h: f64,
        steps: u64,
        mut z: Point,
    ) -> Point {
        let Stages { first, inner, outer } = stages.times(h, h);
        let kicks = outer.map(|h| self.kick(h));
        self.kick(first).apply::<TERM_BY_TERM>(&mut z);
        for _ in 0..steps {
            for i in 0..K {
                drift(inner[i], &mut z);
                kicks[i].apply::<TERM_BY_TERM>(&mut z);
            }
        }
        self.kick(-first).apply::<TERM_BY_TERM>(&mut z);
        z
    }

    /// Drifts are.
    #[inline]
    pub(crate) fn drifts_first<const TERM_BY_TERM: bool, const K: usize>(
        &self,
        stages: Stages<K>,
        h: f64,
        steps: u64,
        mut z: Point,
    ) -> Point {
        let Stages { first, inner, outer } = stages.times(h, h);
        let kicks = inner.map(|h| self.kick(h));
        drift(first, &mut z);
        for _ in 0..steps {
            for i in 0..K {
                kicks[i].apply::<TERM_BY_TERM>(&mut z);
                drift(outer[i], &mut z);
            }
        }
        drift(-first, &mut z);
        z
    }

    /// q₁ = q₀ + 2d, p₁ = p₀ + P, with d = (a, b) = h/2·(p₀ + P/2), the mean (x, y) = q₀ + d and
    ///
    /// ```text
    /// P = −h (x + 2λxy, y + λ(x² + a² − y² − b²/3))
    /// ```
    ///
    /// because the divided difference of x² is 2x, that of x²y is (2xy, x² + a²), and that of y³ is 3y² + b².
    pub(crate) fn discrete_gradient<const CARRIED: bool>(
        &self,
        h: f64,
        steps: u64,
        [mut qx, mut qy, mut px, mut py]: Point,
    ) -> Point {
        let Kick { linear, square, cross } = self.kick(h);
        let (half, quarter) = (0.5 * h, 0.25 * h);
        let explicit = |[x, y, px, py]: Point| {
            let mut kicked = [fma(half, px, x), fma(half, py, y), 0.0, 0.0];
            self.kick(h).apply::<false>(&mut kicked);
            [kicked[2], kicked[3]]
        };
        let mut increments = Increments::new(explicit([qx, qy, px, py]));
        let mut sums = [Sums::<2, CARRIED>::new(), Sums::new()];
        for _ in 0..steps {
            let d = [half * px, half * py];
            let d = |increment: &[f64; 2]| [fma(quarter, increment[0], d[0]), fma(quarter, increment[1], d[1])];
            let [increment, lost] = increments.next(
                [px, py],
                || explicit([qx, qy, px, py]),
                |increment| {
                    let [a, b] = d(increment);
                    let (x, y) = (qx + a, qy + b);
                    let b3 = b * (1.0 / 3.0);
                    let rx = fma(-fma(cross, y, linear), x, increment[0]);
                    let ry = increment[1] - fma(square, fma(x, x, a * a) - fma(y, y, b * b3), linear * y);
                    // Second divided differences; ∂d/∂P = h/4.
                    let (e, c) = (1.0 - quarter * linear, -quarter * cross);
                    let (xx, xy) = (fma(c, y, e), c * x);
                    let (yx, yy) = (c * (x + a), fma(-c, y + b3, e));
                    let inverse = 1.0 / fma(xx, yy, -(xy * yx));
                    [inverse * fma(rx, yy, -(ry * xy)), inverse * fma(ry, xx, -(rx * yx))]
                },
            );
            let [a, b] = d(&increment);
            if CARRIED {
                let (mut q, mut p) = ([qx, qy], [px, py]);
                sums[0].add(&mut q, [2.0 * a, 2.0 * b], [0.0; 2]);
                sums[1].add(&mut p, increment, lost);
                ([qx, qy], [px, py]) = (q, p);
            } else {
                (qx, qy) = (fma(2.0, a, qx), fma(2.0, b, qy));
                (px, py) = (px + increment[0], py + increment[1]);
            }
        }
        [qx, qy, px, py]
    }
}

impl Kick {
    /// ∂V/∂x = x + 2λxy, ∂V/∂y = y + λ(x² − y²).
    ///
    /// Added to the momentum term by term, the chain of dependent operations is one shorter, and p_y is rounded twice; summed
    /// first, once.
    #[inline(always)]
    fn apply<const TERM_BY_TERM: bool>(self, [x, y, px, py]: &mut Point) {
        *px = fma(fma(self.cross, *y, self.linear), *x, *px);
        let squares = fma(*x, *x, -(*y * *y));
        if TERM_BY_TERM {
            *py = fma(self.square, squares, fma(self.linear, *y, *py));
        } else {
            *py += fma(self.square, squares, self.linear * *y);
        }
    }
}

/// q ← q + h·p.
#[inline(always)]
fn drift(h: f64, [x, y, px, py]: &mut Point) {
    *x = fma(h, *px, *x);
    *y = fma(h, *py, *y);
}
