//! H = p²/(2ml²) − mgl·cos q.

use super::{Stages, fma};
use geoint_runtime::BlanesMoan4;

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

    pub(crate) fn blanes_moan_4(&self, h: f64, steps: u64, (mut q, mut p): (f64, f64)) -> (f64, f64) {
        let Stages { first, inner, outer } = Stages::new(&BlanesMoan4, self.kick(h), self.drift(h));
        p = fma(first, q.sin(), p);
        for _ in 0..steps {
            for i in 0..6 {
                q = fma(inner[i], p, q);
                p = fma(outer[i], q.sin(), p);
            }
        }
        p = fma(-first, q.sin(), p);
        (q, p)
    }
}
