//! H = |p|²/(2m) − μm/|q| in the plane.

use super::{Stages, fma};
use geoint_runtime::BlanesMoan4;

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

    pub(crate) fn blanes_moan_4(&self, h: f64, steps: u64, mut z: Point) -> Point {
        let Stages { first, inner, outer } = Stages::new(&BlanesMoan4, -h * self.mu * self.m, h / self.m);
        kick(first, &mut z);
        for _ in 0..steps {
            for i in 0..6 {
                drift(inner[i], &mut z);
                kick(outer[i], &mut z);
            }
        }
        kick(-first, &mut z);
        z
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
