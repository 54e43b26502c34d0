//! A free body: its momentum by the midpoint rule, which is the discrete gradient of a quadratic energy, and its angular velocity by
//! rotations in three planes.

use super::fma;
use super::increments::{Increments, Sums};

/// Moments of inertia.
pub(crate) struct FreeBody {
    pub(crate) inertia: [f64; 3],
}

impl FreeBody {
    /// d = h f(m + d/2), fᵢ = cᵢ mⱼmₖ with c₁ = 1/I₃ − 1/I₂.
    pub(crate) fn discrete_gradient<const CARRIED: bool>(&self, h: f64, steps: u64, mut m: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.inertia.map(|i| 1.0 / i);
        let [c1, c2, c3] = [h * (c - b), h * (a - c), h * (b - a)];
        let field = |[x, y, z]: [f64; 3]| [c1 * y * z, c2 * z * x, c3 * x * y];
        let explicit = |m: [f64; 3]| {
            let half = field(m);
            field([0, 1, 2].map(|i| fma(0.5, half[i], m[i])))
        };
        let mut increments = Increments::new(explicit(m));
        let mut sums = Sums::<3, CARRIED>::new();
        for _ in 0..steps {
            let [increment, lost] = increments.next(
                m,
                || explicit(m),
                |d| {
                    let [x, y, z] = [0, 1, 2].map(|i| fma(0.5, d[i], m[i]));
                    let r = [fma(-c1 * y, z, d[0]), fma(-c2 * z, x, d[1]), fma(-c3 * x, y, d[2])];
                    // 1 − f'/2, with one in the diagonal.
                    let (xy, xz) = (-0.5 * c1 * z, -0.5 * c1 * y);
                    let (yx, yz) = (-0.5 * c2 * z, -0.5 * c2 * x);
                    let (zx, zy) = (-0.5 * c3 * y, -0.5 * c3 * x);
                    let cofactors = [fma(-yz, zy, 1.0), fma(yz, zx, -yx), fma(yx, zy, -zx)];
                    let inverse = 1.0 / fma(xy, cofactors[1], fma(xz, cofactors[2], cofactors[0]));
                    let row = |u: f64, v: f64, w: f64| inverse * fma(u, r[0], fma(v, r[1], w * r[2]));
                    [
                        row(cofactors[0], fma(xz, zy, -xy), fma(xy, yz, -xz)),
                        row(cofactors[1], fma(-xz, zx, 1.0), fma(xz, yx, -yz)),
                        row(cofactors[2], fma(xy, zx, -zy), fma(-xy, yx, 1.0)),
                    ]
                },
            );
            sums.add(&mut m, increment, lost);
        }
        m
    }

    /// The planes (0, 1), (1, 2), (0, 2), (1, 2), (0, 1), of which all but the third for half a step. With yᵢ = √Iᵢ ωᵢ each is a rotation
    /// by h √Iₖ yₖ/√(IᵢIⱼ); neighbouring ones in (0, 1) are one.
    pub(crate) fn rotations(&self, h: f64, steps: u64, velocity: [f64; 3]) -> [f64; 3] {
        let roots = self.inertia.map(f64::sqrt);
        let [mut x, mut y, mut z] = [0, 1, 2].map(|i| roots[i] * velocity[i]);
        let [a, b, c] = roots;
        let (about_z, about_x, about_y) = (h * c / (a * b), 0.5 * h * a / (b * c), h * b / (a * c));
        rotate(0.5 * about_z * z, &mut x, &mut y);
        for _ in 0..steps {
            rotate(about_x * x, &mut y, &mut z);
            rotate(about_y * y, &mut z, &mut x);
            rotate(about_x * x, &mut y, &mut z);
            rotate(about_z * z, &mut x, &mut y);
        }
        rotate(-0.5 * about_z * z, &mut x, &mut y);
        [x / a, y / b, z / c]
    }
}

/// x' = −y, y' = x.
#[inline(always)]
fn rotate(angle: f64, x: &mut f64, y: &mut f64) {
    let (sin, cos) = angle.sin_cos();
    (*x, *y) = (fma(cos, *x, -sin * *y), fma(cos, *y, sin * *x));
}
