//! x' = −xy ∂H/∂y, y' = xy ∂H/∂x with H = bx − c ln x + by − a ln y.

use super::fma;
use super::increments::{Increments, Sums};

/// Parameters.
pub(crate) struct LotkaVolterra {
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) c: f64,
}

impl LotkaVolterra {
    /// d = h S(m) ∇̄H in d = (u, v), with m = (x + u/2, y + v/2): u = −h mₓ m_y (b − a ln[y, y + v]), v = h mₓ m_y (b − c ln[x, x + u]).
    pub(crate) fn discrete_gradient<const CARRIED: bool>(
        &self,
        h: f64,
        steps: u64,
        [mut x, mut y]: [f64; 2],
    ) -> [f64; 2] {
        let Self { a, b, c } = *self;
        let explicit = |x: f64, y: f64| {
            // Half a step ahead.
            let (u, v) = (0.5 * h * x * (a - b * y), 0.5 * h * y * (b * x - c));
            [h * (x + u) * (a - b * (y + v)), h * (y + v) * (b * (x + u) - c)]
        };
        let mut increments = Increments::new(explicit(x, y));
        let mut sums = Sums::<2, CARRIED>::new();
        for _ in 0..steps {
            let [increment, lost] = increments.next(
                [x, y],
                || explicit(x, y),
                |[u, v]| {
                    let (mx, my) = (fma(0.5, *u, x), fma(0.5, *v, y));
                    let (first, second) = (slope(x, *u), slope(y, *v));
                    let (p, q) = (b - c * first[0], b - a * second[0]);
                    let s = h * mx * my;
                    let [rx, ry] = [u + s * q, v - s * p];
                    // ∂s/∂u = h m_y/2, ∂s/∂v = h mₓ/2.
                    let (su, sv) = (0.5 * h * my, 0.5 * h * mx);
                    let (xx, xy) = (1.0 + su * q, sv * q - s * a * second[1]);
                    let (yx, yy) = (s * c * first[1] - su * p, 1.0 - sv * p);
                    let inverse = 1.0 / (xx * yy - xy * yx);
                    [inverse * (rx * yy - ry * xy), inverse * (ry * xx - rx * yx)]
                },
            );
            let mut z = [x, y];
            sums.add(&mut z, increment, lost);
            [x, y] = z;
        }
        [x, y]
    }
}

/// ln[x, x + d] and its derivative with respect to d.
#[inline(always)]
fn slope(x: f64, d: f64) -> [f64; 2] {
    let inverse = 1.0 / x;
    let t = d * inverse;
    if t.abs() > 0.1 {
        let value = t.ln_1p() / d;
        return [value, (1.0 / (x + d) - value) / d];
    }
    // With ln(1 + t) = 2 artanh w, w = t/(2 + t) and s = w².
    let half = 1.0 / (2.0 + t);
    let w = t * half;
    let s = w * w;
    let mut sum = 1.0 / 17.0;
    let mut rate = 16.0 / 17.0;
    for k in (1..8).rev() {
        let n = f64::from(2 * k + 1);
        sum = fma(sum, s, 1.0 / n);
        rate = fma(rate, s, 2.0 * f64::from(k) / n);
    }
    let value = fma(2.0 * half, s * sum, 2.0 * half);
    // ∂w/∂t = 2/(2 + t)², and the slope is 2 (1 + s/3 + …)/(2 + t).
    let slope = 2.0 * half * half * fma(2.0 * half, w * rate, -fma(s, sum, 1.0));
    [inverse * value, inverse * inverse * slope]
}
