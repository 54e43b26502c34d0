//! H = Σ pᵢ²/2 + Σ (d²/2 + αd³/3), d the stretches of the springs between neighbours and to the walls.
//!
//! Pulls of springs first, then their differences: both loops have no iteration that waits for another.

use super::{Stages, fma};

/// Parameters.
pub(crate) struct Chain {
    pub(crate) alpha: f64,
}

/// Positions and momenta.
type Point<const N: usize> = ([f64; N], [f64; N]);

impl Chain {
    pub(crate) fn verlet<const N: usize>(&self, h: f64, steps: u64, (mut q, mut p): Point<N>) -> Point<N> {
        self.kick(0.5 * h, &q, &mut p);
        for _ in 0..steps {
            drift(h, &mut q, &p);
            self.kick(h, &q, &mut p);
        }
        self.kick(-0.5 * h, &q, &mut p);
        (q, p)
    }

    /// Kicks are the outer flows.
    pub(crate) fn kicks_first<const N: usize, const K: usize>(
        &self,
        stages: Stages<K>,
        h: f64,
        steps: u64,
        (mut q, mut p): Point<N>,
    ) -> Point<N> {
        let Stages { first, inner, outer } = stages.times(h, h);
        self.kick(first, &q, &mut p);
        for _ in 0..steps {
            for i in 0..K {
                drift(inner[i], &mut q, &p);
                self.kick(outer[i], &q, &mut p);
            }
        }
        self.kick(-first, &q, &mut p);
        (q, p)
    }

    /// Drifts are.
    pub(crate) fn drifts_first<const N: usize, const K: usize>(
        &self,
        stages: Stages<K>,
        h: f64,
        steps: u64,
        (mut q, mut p): Point<N>,
    ) -> Point<N> {
        let Stages { first, inner, outer } = stages.times(h, h);
        drift(first, &mut q, &p);
        for _ in 0..steps {
            for i in 0..K {
                self.kick(inner[i], &q, &mut p);
                drift(outer[i], &mut q, &p);
            }
        }
        drift(-first, &mut q, &p);
        (q, p)
    }

    #[inline(always)]
    fn kick<const N: usize>(&self, h: f64, q: &[f64; N], p: &mut [f64; N]) {
        let (linear, square) = (h, h * self.alpha);
        let pull = |d: f64| d * fma(square, d, linear);
        let mut pulls = [0.0; N];
        for i in 0..N - 1 {
            pulls[i] = pull(q[i + 1] - q[i]);
        }
        pulls[N - 1] = pull(-q[N - 1]);
        p[0] += pulls[0] - pull(q[0]);
        for i in 1..N {
            p[i] += pulls[i] - pulls[i - 1];
        }
    }
}

/// q ← q + h·p.
#[inline(always)]
fn drift<const N: usize>(h: f64, q: &mut [f64; N], p: &[f64; N]) {
    for i in 0..N {
        q[i] = fma(h, p[i], q[i]);
    }
}
