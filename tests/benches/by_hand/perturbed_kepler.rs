//! H = |p|²/2 − μ/|q| + g(t)·s in the plane: half a damped drift, a kick, half a damped drift, with g in the middle of the step.

use super::fma;

/// Parameters.
pub(crate) struct PerturbedKepler {
    pub(crate) mu: f64,
    pub(crate) alpha: f64,
    pub(crate) omega: f64,
}

/// q₀, q₁, p₀, p₁, s.
type Point = [f64; 5];

impl PerturbedKepler {
    /// g = α sin(Ωt): one sine and one exponential a step.
    pub(crate) fn driven(&self, h: f64, steps: u64, mut z: Point) -> Point {
        for n in 0..steps {
            let middle = n as f64 * h + 0.5 * h;
            let damping = Damping::new(self.alpha * (self.omega * middle).sin(), 0.5 * h);
            damping.drift(&mut z);
            self.kick(h, &mut z);
            damping.drift(&mut z);
        }
        z
    }

    /// g = α: no exponential in the loop, and the drifts of neighbouring steps are one.
    pub(crate) fn damped(&self, h: f64, steps: u64, mut z: Point) -> Point {
        let [half, whole, back] = [0.5 * h, h, -0.5 * h].map(|h| Damping::new(self.alpha, h));
        half.drift(&mut z);
        for _ in 0..steps {
            self.kick(h, &mut z);
            whole.drift(&mut z);
        }
        back.drift(&mut z);
        z
    }

    /// g = α: a composition of K such steps with these weights. Neighbouring drifts are one, and exponentials are computed before the loop.
    pub(crate) fn composed<const K: usize>(&self, weights: &[f64; K], h: f64, steps: u64, mut z: Point) -> Point {
        let drift = |fraction: f64| Damping::new(self.alpha, fraction * h);
        // The drift after kick i. The last one is that of the next step as well.
        let drifts: [Damping; K] = std::array::from_fn(|i| drift(0.5 * (weights[i] + weights[(i + 1) % K])));
        drift(0.5 * weights[0]).drift(&mut z);
        for _ in 0..steps {
            for (weight, drift) in weights.iter().zip(&drifts) {
                self.kick(weight * h, &mut z);
                drift.drift(&mut z);
            }
        }
        drift(-0.5 * weights[0]).drift(&mut z);
        z
    }

    fn kick(&self, h: f64, [x, y, px, py, s]: &mut Point) {
        let squared = fma(*x, *x, *y * *y);
        let pull = h * self.mu / squared.sqrt();
        let force = -pull / squared;
        (*px, *py, *s) = (fma(force, *x, *px), fma(force, *y, *py), *s + pull);
    }
}

/// What a drift under friction multiplies by: w = (1 − e^(−gh))/g and g·w.
struct Damping {
    weight: f64,
    lost: f64,
}

impl Damping {
    fn new(g: f64, h: f64) -> Self {
        let z = -g * h;
        let change = z.exp_m1();
        Damping { weight: if z == 0.0 { h } else { h * (change / z) }, lost: -change }
    }

    #[inline(always)]
    fn drift(&self, [x, y, px, py, s]: &mut Point) {
        let kinetic = 0.5 * fma(*px, *px, *py * *py);
        let moved = fma(self.weight, kinetic, *s);
        (*x, *y, *s) = (fma(self.weight, *px, *x), fma(self.weight, *py, *y), fma(-self.lost, moved, moved));
        (*px, *py) = (fma(-self.lost, *px, *px), fma(-self.lost, *py, *py));
    }
}
