//! A chain of point masses with its velocities as unknowns, by hand.
//!
//! With M_ij = a_ij cos(qᵢ − qⱼ), by addition theorems, and V = −Σ wᵢ cos qᵢ, at qᵢ + h/2 vᵢ:
//!
//! ```text
//! p̄ᵢ = Σ M_ij vⱼ,   fᵢ = −vᵢ Σ S_ij vⱼ − wᵢ sin qᵢ,   S_ij = a_ij sin(qᵢ − qⱼ)
//! midpoint rule:  p̄ − h/2 f = p₀
//! ```
//!
//! The discrete gradient takes slopes of sines and cosines between both ends, cos(b) − cos(a) = −2 sin(m) sin(d/2) for their mean m.

/// Parameters as the loop reads them.
pub(crate) struct Chain<const N: usize> {
    a: [[f64; N]; N],
    w: [f64; N],
}

type Point<const N: usize> = ([f64; N], [f64; N]);

impl<const N: usize> Chain<N> {
    pub(crate) fn new(m: [f64; N], l: [f64; N], g: f64) -> Self {
        let hanging = |i: usize| m[i..].iter().sum::<f64>();
        Chain {
            a: core::array::from_fn(|i| core::array::from_fn(|j| hanging(i.max(j)) * l[i] * l[j])),
            w: core::array::from_fn(|i| hanging(i) * g * l[i]),
        }
    }

    /// The midpoint rule.
    pub(crate) fn midpoint(&self, h: f64, steps: u64, (mut q, mut p): Point<N>) -> Point<N> {
        let half = 0.5 * h;
        let mut guess = Extrapolation::new();
        for _ in 0..steps {
            let mut v = guess.next().unwrap_or_else(|| self.velocity(&q, &p));
            let mut f = [0.0; N];
            for iteration in 1..=40 {
                let (mut residual, mut matrix, force, slopes) = self.stage(h, &q, &v);
                for i in 0..N {
                    residual[i] -= half * force[i] + p[i];
                }
                eliminate(&mut matrix, &mut residual);
                let mut correction = 0.0_f64;
                for i in 0..N {
                    v[i] -= residual[i];
                    correction = correction.max(residual[i].abs() / (v[i].abs() + (q[i] / h).abs()));
                }
                // What the correction changes the force by.
                f = force;
                for i in 0..N {
                    for k in 0..N {
                        f[i] -= slopes[i][k] * residual[k];
                    }
                }
                if correction * correction < 1e-21 || iteration > 3 {
                    break;
                }
            }
            for i in 0..N {
                q[i] += h * v[i];
                p[i] += h * f[i];
            }
            guess.push(v);
        }
        (q, p)
    }

    /// p̄, the derivative of p̄ − h/2 f by v, f and its derivative.
    #[inline(always)]
    fn stage(&self, h: f64, q: &[f64; N], v: &[f64; N]) -> (Vector<N>, Matrix<N>, Vector<N>, Matrix<N>) {
        let half = 0.5 * h;
        let (mut momentum, mut force) = ([0.0; N], [0.0; N]);
        let (mut matrix, mut slopes) = ([[0.0; N]; N], [[0.0; N]; N]);
        let turned: [(f64, f64); N] = core::array::from_fn(|i| (q[i] + half * v[i]).sin_cos());
        for i in 0..N {
            let (s, c) = turned[i];
            let (mut around, mut along) = (0.0, 0.0);
            for j in 0..N {
                let (t, d) = turned[j];
                let (cos, sin) = (self.a[i][j] * (c * d + s * t), self.a[i][j] * (s * d - c * t));
                momentum[i] += cos * v[j];
                if i != j {
                    around += sin * v[j];
                    along += cos * v[j];
                    let product = v[i] * v[j];
                    matrix[i][j] = cos * (1.0 - half * half * product) + half * sin * (v[i] + v[j]);
                    slopes[i][j] = half * cos * product - sin * v[i];
                } else {
                    matrix[i][i] = cos;
                }
            }
            force[i] = -v[i] * around - self.w[i] * s;
            let own = v[i] * along + self.w[i] * c;
            matrix[i][i] += half * half * own;
            slopes[i][i] = -around - half * own;
        }
        (momentum, matrix, force, slopes)
    }

    /// The polarised discrete gradient, for v at the end.
    pub(crate) fn discrete_gradient(&self, h: f64, steps: u64, (mut q, mut p): Point<N>) -> Point<N> {
        let half = 0.5 * h;
        let mut guess = Extrapolation::new();
        let mut start = self.velocity(&q, &p);
        for _ in 0..steps {
            let before: [(f64, f64); N] = core::array::from_fn(|i| q[i].sin_cos());
            let mut d = guess.next().unwrap_or([0.0; N]);
            let mut impulse = [0.0; N];
            for iteration in 1..=40 {
                let v: [f64; N] = core::array::from_fn(|i| start[i] + d[i]);
                let (change, end) = self.ends(h, &q, &start, &v);
                // The mean of both ends in each product, and the slope of each factor.
                let mut residual = [0.0; N];
                let mut matrix = [[0.0; N]; N];
                let mut slopes = [[0.0; N]; N];
                for i in 0..N {
                    let ((s, c), (t, u)) = (before[i], end[i]);
                    let mut force = self.w[i] * change[i].1;
                    let mut by_own = self.w[i] * change[i].3;
                    for j in 0..N {
                        let ((s2, c2), (t2, u2)) = (before[j], end[j]);
                        let entry = self.a[i][j] * (u * u2 + t * t2);
                        residual[i] += entry * v[j];
                        matrix[i][j] += entry;
                        if i == j {
                            continue;
                        }
                        // ∂M(q₁)v₁ by positions at the end.
                        let turning = self.a[i][j] * (t * u2 - u * t2);
                        matrix[i][i] -= half * turning * v[j];
                        matrix[i][j] += half * turning * v[j];
                        let pair = 0.5 * (start[i] * v[j] + start[j] * v[i]);
                        let (mean_c, mean_s) = (0.5 * (c2 + u2), 0.5 * (s2 + t2));
                        let slope = self.a[i][j] * (change[i].1 * mean_c + change[i].0 * mean_s);
                        force += pair * slope;
                        by_own += pair * self.a[i][j] * (change[i].3 * mean_c + change[i].2 * mean_s);
                        let by_other = pair * self.a[i][j] * 0.5 * (change[i].0 * u2 - change[i].1 * t2);
                        // By q₁ⱼ, and by v₁.
                        slopes[i][j] += half * by_other + 0.5 * start[i] * slope;
                        slopes[i][i] += 0.5 * start[j] * slope;
                    }
                    slopes[i][i] += half * by_own;
                    impulse[i] = h * force;
                    residual[i] -= p[i] + impulse[i];
                    for j in 0..N {
                        matrix[i][j] -= h * slopes[i][j];
                    }
                    let _ = (s, c);
                }
                eliminate(&mut matrix, &mut residual);
                let mut correction = 0.0_f64;
                for i in 0..N {
                    d[i] -= residual[i];
                    correction = correction.max(residual[i].abs() / (start[i].abs() + d[i].abs() + 1e-300));
                    for k in 0..N {
                        impulse[i] -= h * slopes[i][k] * residual[k];
                    }
                }
                if correction * correction < 1e-21 || iteration > 3 {
                    break;
                }
            }
            for i in 0..N {
                q[i] += h * (start[i] + 0.5 * d[i]);
                p[i] += impulse[i];
                start[i] += d[i];
            }
            guess.push(d);
        }
        (q, p)
    }

    /// Slopes of sine and cosine between both ends with their derivatives by the end, and sine and cosine there.
    #[inline(always)]
    #[allow(clippy::type_complexity, reason = "names would be longer than the lines that use them")]
    fn ends(&self, h: f64, q: &[f64; N], v0: &[f64; N], v1: &[f64; N]) -> ([(f64, f64, f64, f64); N], [(f64, f64); N]) {
        let mut change = [(0.0, 0.0, 0.0, 0.0); N];
        let mut end = [(0.0, 0.0); N];
        for i in 0..N {
            let d = 0.5 * h * (v0[i] + v1[i]);
            let (s, c) = (q[i] + 0.5 * d).sin_cos();
            let x = 0.25 * d * d;
            // sin(d/2)/(d/2) and its derivative by d, and cos(d/2).
            let sinc = 1.0 - x / 6.0 * (1.0 - x / 20.0 * (1.0 - x / 42.0 * (1.0 - x / 72.0)));
            let slope = -d / 12.0 * (1.0 - x / 10.0 * (1.0 - x / 28.0 * (1.0 - x / 54.0)));
            let cos = 1.0 - x / 2.0 * (1.0 - x / 12.0 * (1.0 - x / 30.0 * (1.0 - x / 56.0)));
            let sin = 0.5 * d * sinc;
            change[i] = (c * sinc, -s * sinc, c * slope - 0.5 * s * sinc, -s * slope - 0.5 * c * sinc);
            end[i] = (s * cos + c * sin, c * cos - s * sin);
        }
        (change, end)
    }

    /// v of momenta.
    fn velocity(&self, q: &[f64; N], p: &[f64; N]) -> [f64; N] {
        let mut matrix = core::array::from_fn(|i| core::array::from_fn(|j| self.a[i][j] * (q[i] - q[j]).cos()));
        let mut v = *p;
        eliminate(&mut matrix, &mut v);
        v
    }
}

type Vector<const N: usize> = [f64; N];
type Matrix<const N: usize> = [[f64; N]; N];

/// A polynomial through the last nine terms.
struct Extrapolation<const N: usize> {
    terms: [[f64; N]; 9],
    started: bool,
}

impl<const N: usize> Extrapolation<N> {
    fn new() -> Self {
        Extrapolation { terms: [[0.0; N]; 9], started: false }
    }

    #[inline(always)]
    fn next(&self) -> Option<[f64; N]> {
        const WEIGHTS: [f64; 9] = [9.0, -36.0, 84.0, -126.0, 126.0, -84.0, 36.0, -9.0, 1.0];
        self.started.then(|| {
            core::array::from_fn(|i| self.terms.iter().zip(WEIGHTS).map(|(term, weight)| weight * term[i]).sum())
        })
    }

    #[inline(always)]
    fn push(&mut self, term: [f64; N]) {
        if !self.started {
            (self.terms, self.started) = ([term; 9], true);
        }
        self.terms.copy_within(0..8, 1);
        self.terms[0] = term;
    }
}

/// Elimination without exchanges: the matrix is near a positive definite one.
#[inline(always)]
fn eliminate<const N: usize>(a: &mut [[f64; N]; N], b: &mut [f64; N]) {
    for k in 0..N {
        let reciprocal = 1.0 / a[k][k];
        for i in k + 1..N {
            let factor = a[i][k] * reciprocal;
            for j in k + 1..N {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
        a[k][k] = reciprocal;
    }
    for k in (0..N).rev() {
        for j in k + 1..N {
            b[k] -= a[k][j] * b[j];
        }
        b[k] *= a[k][k];
    }
}
