//! Masses on surfaces: systems with one constraint, whose differential equation is written by hand.

use crate::scalars::Scalar;
use crate::scene::{Scene, canonical_defect, contact_defect_along};
use geoint_runtime::{Real, contact_hamiltonian, hamiltonian};

/// A mass at a distance l of the origin, in a field that is not uniform.
#[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - l * l) / 2.0])]
pub fn on_a_sphere(q: [f64; 3], p: [f64; 3], m: f64, l: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + m * g * q[2] + 0.3 * q[0].powi(4)
}

/// Two masses on a line each, that an ellipse ties to each other.
#[hamiltonian(constraint = [(q[0] * q[0] / (a * a) + q[1] * q[1] / (b * b) - 1.0) / 2.0])]
pub fn on_an_ellipse(q: [f64; 2], p: [f64; 2], m: [f64; 2], a: f64, b: f64, g: f64) -> f64 {
    p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + m[1] * g * q[1] + 0.2 * q[0].powi(4)
}

/// [`on_a_sphere`] with friction.
#[contact_hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - l * l) / 2.0])]
pub fn damped_on_a_sphere(q: [f64; 3], p: [f64; 3], s: f64, m: f64, l: f64, g: f64, gamma: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + m * g * q[2] + 0.3 * q[0].powi(4) + gamma * s
}

/// [`on_an_ellipse`] with friction that time changes.
#[contact_hamiltonian(constraint = [(q[0] * q[0] / (a * a) + q[1] * q[1] / (b * b) - 1.0) / 2.0])]
pub fn damped_on_an_ellipse(q: [f64; 2], p: [f64; 2], s: f64, t: f64, m: [f64; 2], a: f64, b: f64, g: f64) -> f64 {
    let still = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + m[1] * g * q[1] + 0.2 * q[0].powi(4);
    still + (0.3 + 0.2 * t.sin()) * s
}

/// T = Σ pᵢ²/2mᵢ with the constraint (Σ wᵢqᵢ² − const)/2 = 0.
struct Surface<R, const N: usize> {
    masses: [R; N],
    weights: [R; N],
}

impl<R: Real, const N: usize> Surface<R, N> {
    /// q' = p/m and p' = −∇V − λG with λ from G·v = 0 for all time.
    fn rate(&self, x: &[R], slopes: [R; N]) -> Vec<R> {
        let (q, p) = x.split_at(N);
        let velocity: [R; N] = core::array::from_fn(|i| p[i] / self.masses[i]);
        let normal: [R; N] = core::array::from_fn(|i| self.weights[i] * q[i]);
        let (mut push, mut inertia) = (R::from_f64(0.0), R::from_f64(0.0));
        for i in 0..N {
            push += self.weights[i] * velocity[i] * velocity[i] - normal[i] * slopes[i] / self.masses[i];
            inertia += normal[i] * normal[i] / self.masses[i];
        }
        let multiplier = push / inertia;
        let force = (0..N).map(|i| -slopes[i] - multiplier * normal[i]);
        velocity.into_iter().chain(force).collect()
    }

    /// Returns the momentum without its component that leads away from the surface: p − G (G·v)/(G·M⁻¹G).
    fn tangent(&self, mut x: Vec<R>) -> Vec<R> {
        let normal: [R; N] = core::array::from_fn(|i| self.weights[i] * x[i]);
        let (mut away, mut inertia) = (R::from_f64(0.0), R::from_f64(0.0));
        for i in 0..N {
            away += normal[i] * x[N + i] / self.masses[i];
            inertia += normal[i] * normal[i] / self.masses[i];
        }
        let multiplier = away / inertia;
        (0..N).for_each(|i| x[N + i] -= multiplier * normal[i]);
        x
    }

    /// Gradients by (q, p) of the constraint and of its rate.
    fn gradients(&self, x: &[R]) -> [Vec<R>; 2] {
        let (q, p) = x.split_at(N);
        let normal = || (0..N).map(|i| self.weights[i] * q[i]);
        let turned = (0..N).map(|i| self.weights[i] * p[i] / self.masses[i]);
        let along = (0..N).map(|i| self.weights[i] * q[i] / self.masses[i]);
        [normal().chain((0..N).map(|_| R::from_f64(0.0))).collect(), turned.chain(along).collect()]
    }
}

/// Returns the unit vectors without their components along two gradients.
fn tangents(gradients: [Vec<f64>; 2]) -> Vec<Vec<f64>> {
    let without = |mut x: Vec<f64>, normal: &[f64]| {
        let along: f64 = x.iter().zip(normal).map(|(x, n)| x * n).sum();
        let square: f64 = normal.iter().map(|n| n * n).sum();
        x.iter_mut().zip(normal).for_each(|(x, n)| *x -= along / square * n);
        x
    };
    let [first, second] = gradients;
    let second = without(second, &first);
    let unit = |i: usize| (0..first.len()).map(|j| f64::from(u8::from(i == j))).collect::<Vec<f64>>();
    (0..first.len()).map(|i| without(without(unit(i), &first), &second)).collect()
}

/// [`OnASphere`] from a start.
#[derive(Clone, Copy, Debug)]
pub struct Spheres;

/// [`OnAnEllipse`] from a start.
#[derive(Clone, Copy, Debug)]
pub struct Ellipses;

/// [`DampedOnASphere`] from a start.
#[derive(Clone, Copy, Debug)]
pub struct DampedSpheres;

/// [`DampedOnAnEllipse`] from a start.
#[derive(Clone, Copy, Debug)]
pub struct DampedEllipses;

fn sphere<R: Real>() -> Surface<R, 3> {
    Surface { masses: [1.4; 3].map(R::from_f64), weights: [1.0; 3].map(R::from_f64) }
}

fn ellipse<R: Real>() -> Surface<R, 2> {
    Surface { masses: [1.7, 0.6].map(R::from_f64), weights: [1.0 / (1.3 * 1.3), 1.0 / (0.8 * 0.8)].map(R::from_f64) }
}

impl Scene for Spheres {
    type Over<R: Scalar> = OnASphere<R>;
    const NAME: &'static str = "OnASphere";

    fn over<R: Scalar>() -> OnASphere<R> {
        OnASphere { m: R::from_f64(1.4), l: R::from_f64(1.5), g: R::from_f64(2.1) }
    }
    fn start() -> (f64, Vec<f64>) {
        // 1² + 1² + ½² = 1.5²; the velocity is tangent.
        (0.4, vec![1.0, -1.0, -0.5, 0.7, 0.4, 0.6])
    }
    fn rate<R: Scalar>(system: &OnASphere<R>, _: R, x: &[R]) -> Vec<R> {
        let cubic = R::from_f64(1.2) * x[0] * x[0] * x[0];
        sphere().rate(x, [cubic, R::from_f64(0.0), system.m * system.g])
    }
    fn directions() -> Vec<Vec<f64>> {
        tangents(sphere().gradients(&Self::start().1))
    }
    fn compared<R: Scalar>(x: Vec<R>) -> Vec<R> {
        sphere().tangent(x)
    }
    fn form_defect(directions: &[Vec<f64>], images: &[Vec<f64>], _: &[f64], _: &[f64]) -> f64 {
        canonical_defect(directions, images)
    }
}

impl Scene for Ellipses {
    type Over<R: Scalar> = OnAnEllipse<R>;
    const NAME: &'static str = "OnAnEllipse";

    fn over<R: Scalar>() -> OnAnEllipse<R> {
        let m = [1.7, 0.6].map(R::from_f64);
        OnAnEllipse { m, a: R::from_f64(1.3), b: R::from_f64(0.8), g: R::from_f64(2.3) }
    }
    fn start() -> (f64, Vec<f64>) {
        // At (0.6 a, 0.8 b), with the velocity (−0.8 a, 0.6 b).
        (0.4, vec![0.78, 0.64, -1.04 * 1.7, 0.48 * 0.6])
    }
    fn rate<R: Scalar>(system: &OnAnEllipse<R>, _: R, x: &[R]) -> Vec<R> {
        let cubic = R::from_f64(0.8) * x[0] * x[0] * x[0];
        ellipse().rate(x, [cubic, system.m[1] * system.g])
    }
    fn directions() -> Vec<Vec<f64>> {
        tangents(ellipse().gradients(&Self::start().1))
    }
    fn compared<R: Scalar>(x: Vec<R>) -> Vec<R> {
        ellipse().tangent(x)
    }
    fn form_defect(directions: &[Vec<f64>], images: &[Vec<f64>], _: &[f64], _: &[f64]) -> f64 {
        canonical_defect(directions, images)
    }
}

/// Adds the friction γ and the action to the rates of a scene without them: p' − γp and s' = p·q' − H. Tangent momenta need no other multiplier.
fn with_friction<R: Real>(mut rate: Vec<R>, x: &[R], gamma: R, energy: R) -> Vec<R> {
    let n = rate.len() / 2;
    let mut power = -energy;
    for i in 0..n {
        power += x[n + i] * rate[i];
        rate[n + i] -= gamma * x[n + i];
    }
    rate.push(power);
    rate
}

/// Applies a map of (q, p) to a state, or a displacement, with an action.
fn beside_action<R: Real>(mut x: Vec<R>, map: impl Fn(Vec<R>) -> Vec<R>) -> Vec<R> {
    let s = x.pop();
    map(x).into_iter().chain(s).collect()
}

/// The directions of (q, p), then that of s.
fn with_action(directions: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let length = directions.first().map_or(0, Vec::len);
    let last = [vec![0.0; length], vec![1.0]].concat();
    directions.into_iter().map(|direction| [direction, vec![0.0]].concat()).chain([last]).collect()
}

/// The friction of [`DampedSpheres`].
const FRICTION: f64 = 0.35;

impl Scene for DampedSpheres {
    type Over<R: Scalar> = DampedOnASphere<R>;
    const NAME: &'static str = "DampedOnASphere";

    fn over<R: Scalar>() -> DampedOnASphere<R> {
        let OnASphere { m, l, g } = Spheres::over();
        DampedOnASphere { m, l, g, gamma: R::from_f64(FRICTION) }
    }
    fn start() -> (f64, Vec<f64>) {
        let (t, x) = Spheres::start();
        (t, [x, vec![0.4]].concat())
    }
    fn rate<R: Scalar>(system: &DampedOnASphere<R>, t: R, x: &[R]) -> Vec<R> {
        let DampedOnASphere { m, l, g, gamma } = *system;
        let free = Spheres::rate(&OnASphere { m, l, g }, t, &x[..6]);
        let kinetic = (x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / (R::from_f64(2.0) * m);
        let quartic = R::from_f64(0.3) * x[0] * x[0] * x[0] * x[0];
        with_friction(free, x, gamma, kinetic + m * g * x[2] + quartic + gamma * x[6])
    }
    fn directions() -> Vec<Vec<f64>> {
        with_action(Spheres::directions())
    }
    fn compared<R: Scalar>(x: Vec<R>) -> Vec<R> {
        beside_action(x, Spheres::compared)
    }
    fn form_defect(directions: &[Vec<f64>], images: &[Vec<f64>], before: &[f64], after: &[f64]) -> f64 {
        contact_defect_along(directions, images, before, after)
    }
    fn energy_after(duration: f64, energy: f64) -> f64 {
        energy * (-FRICTION * duration).exp()
    }
}

impl Scene for DampedEllipses {
    type Over<R: Scalar> = DampedOnAnEllipse<R>;
    const NAME: &'static str = "DampedOnAnEllipse";

    fn over<R: Scalar>() -> DampedOnAnEllipse<R> {
        let OnAnEllipse { m, a, b, g } = Ellipses::over();
        DampedOnAnEllipse { m, a, b, g }
    }
    fn start() -> (f64, Vec<f64>) {
        let (t, x) = Ellipses::start();
        (t, [x, vec![-0.3]].concat())
    }
    fn rate<R: Scalar>(system: &DampedOnAnEllipse<R>, t: R, x: &[R]) -> Vec<R> {
        let DampedOnAnEllipse { m, a, b, g } = *system;
        let free = Ellipses::rate(&OnAnEllipse { m, a, b, g }, t, &x[..4]);
        let half = R::from_f64(0.5);
        let kinetic = half * x[2] * x[2] / m[0] + half * x[3] * x[3] / m[1];
        let quartic = R::from_f64(0.2) * x[0] * x[0] * x[0] * x[0];
        let gamma = R::from_f64(0.3) + R::from_f64(0.2) * t.sin();
        with_friction(free, x, gamma, kinetic + m[1] * g * x[1] + quartic + gamma * x[4])
    }
    fn directions() -> Vec<Vec<f64>> {
        with_action(Ellipses::directions())
    }
    fn compared<R: Scalar>(x: Vec<R>) -> Vec<R> {
        beside_action(x, Ellipses::compared)
    }
    fn form_defect(directions: &[Vec<f64>], images: &[Vec<f64>], before: &[f64], after: &[f64]) -> f64 {
        contact_defect_along(directions, images, before, after)
    }
}
