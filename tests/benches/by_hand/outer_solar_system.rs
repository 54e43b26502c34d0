//! H = Σ |pᵢ|²/(2mᵢ) − Σ G mᵢ mⱼ/|qᵢ − qⱼ|, six bodies.
//!
//! With momenta instead of velocities the impulse of a pair is one vector, added to one body and taken from the other.

use super::{Stages, fma};

const BODIES: usize = 6;

/// Parameters.
pub(crate) struct OuterSolarSystem {
    pub(crate) m: [f64; BODIES],
    pub(crate) g: f64,
}

/// Positions or momenta.
pub(crate) type Vectors = [[f64; 3]; BODIES];

/// A factor for every pair.
type Pulls = [[f64; BODIES]; BODIES];

impl OuterSolarSystem {
    /// h·G·mᵢ·mⱼ.
    fn pulls(&self, h: f64) -> Pulls {
        self.m.map(|m| self.m.map(|other| h * self.g * m * other))
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

    /// Kicks are the outer flows.
    #[inline]
    pub(crate) fn kicks_first<const K: usize>(
        &self,
        stages: Stages<K>,
        h: f64,
        steps: u64,
        (mut q, mut p): (Vectors, Vectors),
    ) -> (Vectors, Vectors) {
        let Stages { first, inner, outer } = stages.times(h, h);
        let pulls = outer.map(|h| self.pulls(h));
        let drifts = inner.map(|h| self.inverse_masses(h));
        kick(&self.pulls(first), &q, &mut p);
        for _ in 0..steps {
            for i in 0..K {
                drift(&drifts[i], &mut q, &p);
                kick(&pulls[i], &q, &mut p);
            }
        }
        kick(&self.pulls(-first), &q, &mut p);
        (q, p)
    }

    /// Drifts are.
    #[inline]
    pub(crate) fn drifts_first<const K: usize>(
        &self,
        stages: Stages<K>,
        h: f64,
        steps: u64,
        (mut q, mut p): (Vectors, Vectors),
    ) -> (Vectors, Vectors) {
        let Stages { first, inner, outer } = stages.times(h, h);
        let pulls = inner.map(|h| self.pulls(h));
        let drifts = outer.map(|h| self.inverse_masses(h));
        drift(&self.inverse_masses(first), &mut q, &p);
        for _ in 0..steps {
            for i in 0..K {
                kick(&pulls[i], &q, &mut p);
                drift(&drifts[i], &mut q, &p);
            }
        }
        drift(&self.inverse_masses(-first), &mut q, &p);
        (q, p)
    }
}

/// All pairs, written out: the compiler keeps a loop over them as a loop, with p in memory, which costs ten times as much.
#[inline(always)]
fn kick(pulls: &Pulls, q: &Vectors, p: &mut Vectors) {
    pair::<0, 1>(pulls, q, p);
    pair::<0, 2>(pulls, q, p);
    pair::<0, 3>(pulls, q, p);
    pair::<0, 4>(pulls, q, p);
    pair::<0, 5>(pulls, q, p);
    pair::<1, 2>(pulls, q, p);
    pair::<1, 3>(pulls, q, p);
    pair::<1, 4>(pulls, q, p);
    pair::<1, 5>(pulls, q, p);
    pair::<2, 3>(pulls, q, p);
    pair::<2, 4>(pulls, q, p);
    pair::<2, 5>(pulls, q, p);
    pair::<3, 4>(pulls, q, p);
    pair::<3, 5>(pulls, q, p);
    pair::<4, 5>(pulls, q, p);
}

/// One division and one root; components written out for the same reason.
#[inline(always)]
fn pair<const I: usize, const J: usize>(pulls: &Pulls, q: &Vectors, p: &mut Vectors) {
    let (x, y, z) = (q[J][0] - q[I][0], q[J][1] - q[I][1], q[J][2] - q[I][2]);
    let r2 = x * x + y * y + z * z;
    let f = pulls[I][J] / (r2 * r2.sqrt());
    p[I] = [fma(f, x, p[I][0]), fma(f, y, p[I][1]), fma(f, z, p[I][2])];
    p[J] = [fma(-f, x, p[J][0]), fma(-f, y, p[J][1]), fma(-f, z, p[J][2])];
}

#[inline(always)]
fn drift(drifts: &[f64; BODIES], q: &mut Vectors, p: &Vectors) {
    for i in 0..BODIES {
        for k in 0..3 {
            q[i][k] = fma(drifts[i], p[i][k], q[i][k]);
        }
    }
}
