//! The double pendulum under the implicit midpoint rule: Newton's method with gradient and Hessian derived by hand.
//!
//! With Δ = θ₁ − θ₂, divided through by m₂l₁²l₂²:
//!
//! ```text
//! T = (A p₁² + B p₂² − 2 E p₁ p₂ cos Δ) / 2D,   D = m₁ + m₂ sin²Δ
//! A = 1/l₁²,   B = (m₁ + m₂)/(m₂ l₂²),   E = 1/(l₁ l₂)
//! V = −V₁ cos θ₁ − V₂ cos θ₂,   V₁ = (m₁ + m₂) g l₁,   V₂ = m₂ g l₂
//! ```
//!
//! Derivatives of T by Δ follow from those of T·D and ∂T/∂p·D: no square of D is needed.

use super::fma;

/// Parameters.
pub(crate) struct DoublePendulum {
    pub(crate) m: [f64; 2],
    pub(crate) l: [f64; 2],
    pub(crate) g: f64,
}

/// θ₁, θ₂, p₁, p₂.
pub(crate) type Point = [f64; 4];

/// Parameters as the loop reads them.
struct Constants {
    h: f64,
    half: f64,
    m1: f64,
    m2: f64,
    a: f64,
    b: f64,
    e: f64,
    v1: f64,
    v2: f64,
}

impl DoublePendulum {
    pub(crate) fn implicit_midpoint(&self, h: f64, steps: u64, z: Point) -> Point {
        self.composed(&[1.0], h, steps, z)
    }

    /// One step of the midpoint rule for each weight.
    pub(crate) fn composed<const K: usize>(&self, weights: &[f64; K], h: f64, steps: u64, mut z: Point) -> Point {
        let parts = weights.map(|weight| self.constants(weight * h));
        for _ in 0..steps {
            for constants in &parts {
                z = constants.step(z);
            }
        }
        z
    }

    fn constants(&self, h: f64) -> Constants {
        let ([m1, m2], [l1, l2], g) = (self.m, self.l, self.g);
        Constants {
            h,
            half: 0.5 * h,
            m1,
            m2,
            a: 1.0 / (l1 * l1),
            b: (m1 + m2) / (m2 * l2 * l2),
            e: 1.0 / (l1 * l2),
            v1: (m1 + m2) * g * l1,
            v2: m2 * g * l2,
        }
    }
}

impl Constants {
    #[inline(always)]
    fn step(&self, z: Point) -> Point {
        // The explicit midpoint rule as a guess.
        let slope = self.field(z);
        let slope = self.field(std::array::from_fn(|i| fma(self.half, slope[i], z[i])));
        let mut x = slope.map(|slope| self.h * slope);
        let mut before = f64::INFINITY;
        for iteration in 1..=40 {
            let (mut delta, mut matrix) = self.residual(&z, &x);
            eliminate(&mut matrix, &mut delta);
            for i in 0..4 {
                x[i] -= delta[i];
            }
            let correction = relative(&delta, &x, &z);
            let shrunk = if iteration == 1 { correction.sqrt() } else { correction / before };
            if correction * shrunk * shrunk <= f64::EPSILON / 1024.0 || (shrunk > 0.25 && correction <= 1e-9) {
                break;
            }
            assert!(correction < f64::INFINITY, "no convergence");
            before = correction;
        }
        std::array::from_fn(|i| z[i] + x[i])
    }

    /// ∂H/∂p₁, ∂H/∂p₂, −∂H/∂θ₁, −∂H/∂θ₂.
    #[inline(always)]
    fn field(&self, [theta1, theta2, p1, p2]: Point) -> Point {
        let (sin, cos) = (theta1 - theta2).sin_cos();
        let sin_m = self.m2 * sin;
        let w = 1.0 / fma(sin_m, sin, self.m1);
        let ec = self.e * cos;
        let u1 = fma(self.a, p1, -(ec * p2)) * w;
        let u2 = fma(self.b, p2, -(ec * p1)) * w;
        let twice_kinetic = fma(p1, u1, p2 * u2);
        let slope = w * sin * fma(self.e * p1, p2, -(twice_kinetic * self.m2 * cos));
        [u1, u2, -fma(self.v1, theta1.sin(), slope), -fma(self.v2, theta2.sin(), -slope)]
    }

    /// x − h J∇H(z + x/2), and its derivative by x: 1 − (h/2) J∇²H.
    #[inline(always)]
    fn residual(&self, z: &Point, x: &Point) -> (Point, [Point; 4]) {
        let [theta1, theta2, p1, p2]: Point = std::array::from_fn(|i| fma(0.5, x[i], z[i]));
        let (sin1, cos1) = theta1.sin_cos();
        let (sin2, cos2) = theta2.sin_cos();
        let (sin, cos) = (theta1 - theta2).sin_cos();

        // D and its derivatives, 1/D.
        let sin_m = self.m2 * sin;
        let w = 1.0 / fma(sin_m, sin, self.m1);
        let d1 = 2.0 * sin_m * cos;
        let d2 = 2.0 * fma(self.m2 * cos, cos, -(sin_m * sin));

        // ∂T/∂p and their derivatives by Δ.
        let (ec, es) = (self.e * cos, self.e * sin);
        let u1 = fma(self.a, p1, -(ec * p2)) * w;
        let u2 = fma(self.b, p2, -(ec * p1)) * w;
        let u1_slope = fma(es, p2, -(u1 * d1)) * w;
        let u2_slope = fma(es, p1, -(u2 * d1)) * w;

        // T and its derivatives by Δ.
        let kinetic = 0.5 * fma(p1, u1, p2 * u2);
        let p1p2 = p1 * p2;
        let slope = fma(es, p1p2, -(kinetic * d1)) * w;
        let bend = fma(ec, p1p2, -fma(2.0 * slope, d1, kinetic * d2)) * w;

        let (h, half) = (self.h, self.half);
        let residual = [
            fma(-h, u1, x[0]),
            fma(-h, u2, x[1]),
            fma(h, fma(self.v1, sin1, slope), x[2]),
            fma(h, fma(self.v2, sin2, -slope), x[3]),
        ];
        let (hu1, hu2, hb, hw) = (half * u1_slope, half * u2_slope, half * bend, half * w);
        let cross = hw * ec;
        let matrix = [
            [1.0 - hu1, hu1, -(hw * self.a), cross],
            [-hu2, 1.0 + hu2, cross, -(hw * self.b)],
            [fma(half * self.v1, cos1, hb), -hb, 1.0 + hu1, hu2],
            [-hb, fma(half * self.v2, cos2, hb), -hu1, 1.0 - hu2],
        ];
        (residual, matrix)
    }
}

/// Gaussian elimination with partial pivoting; the solution replaces `b`.
#[inline(always)]
fn eliminate(a: &mut [Point; 4], b: &mut Point) {
    for k in 0..4 {
        let mut pivot = k;
        for i in k + 1..4 {
            if a[i][k].abs() > a[pivot][k].abs() {
                pivot = i;
            }
        }
        if pivot != k {
            a.swap(k, pivot);
            b.swap(k, pivot);
        }
        let reciprocal = 1.0 / a[k][k];
        for i in k + 1..4 {
            let factor = -(a[i][k] * reciprocal);
            for j in k + 1..4 {
                a[i][j] = fma(factor, a[k][j], a[i][j]);
            }
            b[i] = fma(factor, b[k], b[i]);
        }
    }
    for k in (0..4).rev() {
        for j in k + 1..4 {
            b[k] = fma(-a[k][j], b[j], b[k]);
        }
        b[k] /= a[k][k];
    }
}

/// The largest correction relative to what it corrects, or to a millionth of the largest of those.
#[inline(always)]
fn relative(delta: &Point, x: &Point, origin: &Point) -> f64 {
    let sizes: Point = std::array::from_fn(|i| origin[i].abs() + x[i].abs());
    let floor = 1e-6 * sizes.iter().fold(0.0, |a: f64, b| a.max(*b));
    let ratios: Point = std::array::from_fn(|i| delta[i].abs() / sizes[i].max(floor));
    ratios.iter().fold(0.0, |a: f64, b| a.max(*b))
}
