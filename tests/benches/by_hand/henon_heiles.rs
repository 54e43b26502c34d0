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

    pub(crate) fn blanes_moan_4<const TERM_BY_TERM: bool>(&self, h: f64, steps: u64, mut z: Point) -> Point {
        let Stages { first, inner, outer } = Stages::new(&BlanesMoan4, h, h);
        let kicks = outer.map(|h| self.kick(h));
        self.kick(first).apply::<TERM_BY_TERM>(&mut z);
        for _ in 0..steps {
            for i in 0..6 {
                drift(inner[i], &mut z);
                kicks[i].apply::<TERM_BY_TERM>(&mut z);
            }
        }
        self.kick(-first).apply::<TERM_BY_TERM>(&mut z);
        z
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
