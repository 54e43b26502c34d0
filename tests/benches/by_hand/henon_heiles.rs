//! H = (|p|² + x² + y²)/2 + λ(x²y − y³/3).

use super::{Stages, fma};
use geoint_runtime::BlanesMoan4;

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

    pub(crate) fn verlet(&self, h: f64, steps: u64, mut z: Point) -> Point {
        let (half, whole) = (self.kick(0.5 * h), self.kick(h));
        half.apply(&mut z);
        for _ in 0..steps {
            drift(h, &mut z);
            whole.apply(&mut z);
        }
        self.kick(-0.5 * h).apply(&mut z);
        z
    }

    pub(crate) fn blanes_moan_4(&self, h: f64, steps: u64, mut z: Point) -> Point {
        let Stages { first, inner, outer } = Stages::new(&BlanesMoan4, h, h);
        let kicks = outer.map(|h| self.kick(h));
        self.kick(first).apply(&mut z);
        for _ in 0..steps {
            for i in 0..6 {
                drift(inner[i], &mut z);
                kicks[i].apply(&mut z);
            }
        }
        self.kick(-first).apply(&mut z);
        z
    }
}

impl Kick {
    /// ∂V/∂x = x + 2λxy, ∂V/∂y = y + λ(x² − y²).
    #[inline(always)]
    fn apply(self, [x, y, px, py]: &mut Point) {
        *px = fma(fma(self.cross, *y, self.linear), *x, *px);
        *py += fma(self.square, fma(*x, *x, -(*y * *y)), self.linear * *y);
    }
}

/// q ← q + h·p.
#[inline(always)]
fn drift(h: f64, [x, y, px, py]: &mut Point) {
    *x = fma(h, *px, *x);
    *y = fma(h, *py, *y);
}
