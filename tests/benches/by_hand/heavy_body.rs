//! A heavy body about a fixed point: kicks by its weight, and the free motion by a Taylor series of twelve terms.

use super::fma;

/// Moments of inertia, and the centre of mass times the weight.
pub(crate) struct HeavyBody {
    pub(crate) inertia: [f64; 3],
    pub(crate) c: [f64; 3],
}

const TERMS: usize = 12;

impl HeavyBody {
    /// r = (i, j, k, w) and the momentum in the body.
    pub(crate) fn verlet(&self, h: f64, steps: u64, mut r: [f64; 4], mut m: [f64; 3]) -> ([f64; 4], [f64; 3]) {
        let inverse = self.inertia.map(|i| h / i);
        self.kick(0.5 * h, &r, &mut m);
        for _ in 0..steps {
            drift(&inverse, &mut r, &mut m);
            self.kick(h, &r, &mut m);
        }
        self.kick(-0.5 * h, &r, &mut m);
        (r, m)
    }

    /// m ← m + h γ × c, γ the vertical in the body.
    #[inline(always)]
    fn kick(&self, h: f64, [x, y, z, w]: &[f64; 4], m: &mut [f64; 3]) {
        let [c1, c2, c3] = self.c.map(|c| h * c);
        let g = [2.0 * (x * z - w * y), 2.0 * fma(*y, *z, w * x), fma(-2.0 * x, *x, fma(-2.0 * y, *y, 1.0))];
        m[0] += g[1] * c3 - g[2] * c2;
        m[1] += g[2] * c1 - g[0] * c3;
        m[2] += g[0] * c2 - g[1] * c1;
    }
}

/// h times r' = ½ r⊗(0, ω) and m' = m × ω, ω = I⁻¹m: coefficients by products of series.
#[inline(always)]
fn drift(inverse: &[f64; 3], r: &mut [f64; 4], m: &mut [f64; 3]) {
    let mut q = [[0.0; 4]; TERMS + 1];
    let mut l = [[0.0; 3]; TERMS + 1];
    let mut o = [[0.0; 3]; TERMS];
    (q[0], l[0]) = (*r, *m);
    for n in 0..TERMS {
        o[n] = [0, 1, 2].map(|i| inverse[i] * l[n][i]);
        let (mut dq, mut dl) = ([0.0; 4], [0.0; 3]);
        for k in 0..=n {
            let ([x, y, z, w], [u, v, t], [a, b, c]) = (q[k], l[k], o[n - k]);
            dq[0] += fma(w, a, fma(y, c, -z * b));
            dq[1] += fma(w, b, fma(z, a, -x * c));
            dq[2] += fma(w, c, fma(x, b, -y * a));
            dq[3] -= fma(x, a, fma(y, b, z * c));
            dl[0] += fma(v, c, -t * b);
            dl[1] += fma(t, a, -u * c);
            dl[2] += fma(u, b, -v * a);
        }
        let whole = 1.0 / (n + 1) as f64;
        q[n + 1] = dq.map(|x| 0.5 * whole * x);
        l[n + 1] = dl.map(|x| whole * x);
    }
    // The smallest terms first.
    let (mut dq, mut dl) = (q[TERMS], l[TERMS]);
    for n in (1..TERMS).rev() {
        dq = [0, 1, 2, 3].map(|i| dq[i] + q[n][i]);
        dl = [0, 1, 2].map(|i| dl[i] + l[n][i]);
    }
    *r = [0, 1, 2, 3].map(|i| r[i] + dq[i]);
    *m = [0, 1, 2].map(|i| m[i] + dl[i]);
}
