//! H = Σ |pᵢ|²/(2mᵢ) − Σ G mᵢ mⱼ/|qᵢ − qⱼ|, six bodies.
//!
//! With momenta instead of velocities the impulse of a pair is one vector, added to one body and taken from the other.

use super::{Stages, fma};
use geoint_runtime::BlanesMoanSrkn14a;

const BODIES: usize = 6;
const PAIRS: usize = BODIES * (BODIES - 1) / 2;

/// Parameters.
pub(crate) struct OuterSolarSystem {
    pub(crate) m: [f64; BODIES],
    pub(crate) g: f64,
}

/// Positions or momenta.
pub(crate) type Vectors = [[f64; 3]; BODIES];

impl OuterSolarSystem {
    /// h·G·mᵢ·mⱼ of every pair.
    fn pulls(&self, h: f64) -> [f64; PAIRS] {
        let mut pulls = [0.0; PAIRS];
        let mut pair = 0;
        for i in 0..BODIES {
            for j in i + 1..BODIES {
                pulls[pair] = h * self.g * self.m[i] * self.m[j];
                pair += 1;
            }
        }
        pulls
    }

    fn inverse_masses(&self, h: f64) -> [f64; BODIES] {
        self.m.map(|m| h / m)
    }

    pub(crate) fn verlet(&self, h: f64, steps: u64, (mut q, mut p): (Vectors, Vectors)) -> (Vectors, Vectors) {
        let (pulls, drifts) = (self.pulls(h), self.inverse_masses(h));
        kick(&self.pulls(0.5 * h), &q, &mut p);
        for _ in 0..steps {
            drift(&drifts, &mut q, &p);
            kick(&pulls, &q, &mut p);
        }
        kick(&self.pulls(-0.5 * h), &q, &mut p);
        (q, p)
    }

    pub(crate) fn srkn_14a(&self, h: f64, steps: u64, (mut q, mut p): (Vectors, Vectors)) -> (Vectors, Vectors) {
        let Stages { first, inner, outer } = Stages::new(BlanesMoanSrkn14a.table(), h, h);
        let pulls = inner.map(|h| self.pulls(h));
        let drifts = outer.map(|h| self.inverse_masses(h));
        drift(&self.inverse_masses(first), &mut q, &p);
        for _ in 0..steps {
            for i in 0..14 {
                kick(&pulls[i], &q, &mut p);
                drift(&drifts[i], &mut q, &p);
            }
        }
        drift(&self.inverse_masses(-first), &mut q, &p);
        (q, p)
    }
}

/// One division and one root a pair.
#[inline(always)]
fn kick(pulls: &[f64; PAIRS], q: &Vectors, p: &mut Vectors) {
    let mut pair = 0;
    for i in 0..BODIES {
        for j in i + 1..BODIES {
            let [x, y, z] = [0, 1, 2].map(|k| q[j][k] - q[i][k]);
            let r2 = fma(x, x, fma(y, y, z * z));
            let f = pulls[pair] / (r2 * r2.sqrt());
            for (k, d) in [x, y, z].into_iter().enumerate() {
                p[i][k] = fma(f, d, p[i][k]);
                p[j][k] = fma(-f, d, p[j][k]);
            }
            pair += 1;
        }
    }
}

#[inline(always)]
fn drift(drifts: &[f64; BODIES], q: &mut Vectors, p: &Vectors) {
    for i in 0..BODIES {
        for k in 0..3 {
            q[i][k] = fma(drifts[i], p[i][k], q[i][k]);
        }
    }
}
