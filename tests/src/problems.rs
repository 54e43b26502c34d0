//! Annotated energies, each with parameters other than 1, a start, and a scalar of choice.
//!
//! Together the problems have every structure that a method or the macro distinguishes. H is separable or not, T is quadratic or not, and time is
//! explicit or not. Some coordinates are cyclic, some energies have branches, and every shape of coordinates occurs.

use crate::scalars::Scalar;
pub use crate::scene::flat;
use geoint_runtime::private::Collocation;
use geoint_runtime::{Coordinates, Cotangent, Hamiltonian, State, hamiltonian, space::Array};
use nalgebra::{SVector, Vector2, Vector3};

/// Planar pendulum; q in rad.
#[hamiltonian]
pub fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}

/// Two bodies in relative coordinates, written in q·q so that angular momentum is seen.
#[hamiltonian]
pub fn kepler(q: [f64; 2], p: [f64; 2], mass: f64, mu: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * mass) - mu / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// The same with vectors of nalgebra.
#[hamiltonian]
pub fn kepler_vector(q: Vector2<f64>, p: Vector2<f64>, mass: f64, mu: f64) -> f64 {
    p.dot(&p) / (2.0 * mass) - mu / q.norm()
}

/// Two oscillators of different mass with a cubic coupling.
#[hamiltonian]
pub fn henon_heiles(q: [f64; 2], p: [f64; 2], m: [f64; 2], lambda: f64) -> f64 {
    let [x, y] = q;
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    kinetic + (x * x + y * y) / 2.0 + lambda * (x * x * y - y * y * y / 3.0)
}

/// Two masses on quartic springs; the parameters are reciprocal masses and stiffnesses, so `+ − ·` are enough.
#[hamiltonian]
pub fn quartic_chain(q: [f64; 2], p: [f64; 2], w: [f64; 2], k: [f64; 3]) -> f64 {
    let d = q[1] - q[0];
    let spring = |x: f64, k: f64| k * (0.5 * x * x + 0.25 * x * x * x * x);
    0.5 * (w[0] * p[0] * p[0] + w[1] * p[1] * p[1]) + spring(q[0], k[0]) + spring(d, k[1]) + spring(q[1], k[2])
}

/// Two rods; not separable.
#[hamiltonian]
pub fn double_pendulum(q: [f64; 2], p: [f64; 2], m1: f64, m2: f64, l1: f64, l2: f64, g: f64) -> f64 {
    let (sin, cos) = (q[0] - q[1]).sin_cos();
    let kinetic = (m2 * l2 * l2 * p[0] * p[0] + (m1 + m2) * l1 * l1 * p[1] * p[1]
        - 2.0 * m2 * l1 * l2 * p[0] * p[1] * cos)
        / (2.0 * m2 * l1 * l1 * l2 * l2 * (m1 + m2 * sin * sin));
    kinetic - (m1 + m2) * g * l1 * q[0].cos() - m2 * g * l2 * q[1].cos()
}

/// Separable with a T that is not quadratic: a relativistic particle tied to one with a quartic T.
#[hamiltonian]
pub fn relativistic(q: [f64; 2], p: [f64; 2], m: [f64; 2], k: f64) -> f64 {
    let d = q[1] - q[0];
    let kinetic = m[0] * (1.0 + p[0] * p[0] / (m[0] * m[0])).sqrt() + p[1] * p[1] / (2.0 * m[1]) + 0.3 * p[1].powi(4);
    kinetic + 0.5 * k * (q[0] * q[0] + d * d) + 0.2 * q[1].powi(4)
}

/// V depends on time.
#[hamiltonian]
pub fn driven_pendulum(t: f64, q: f64, p: f64, m: f64, g: f64, drive: f64, omega: f64) -> f64 {
    p * p / (2.0 * m) - m * g * q.cos() - drive * q * (omega * t).sin()
}

/// T and V depend on time, each in its own way.
#[hamiltonian]
pub fn breathing(q: [f64; 2], p: [f64; 2], t: f64, m: [f64; 2], omega: f64) -> f64 {
    let mass = 1.0 + 0.3 * (omega * t).sin();
    let stiffness = 1.0 + 0.4 * (1.7 * omega * t).cos();
    (p[0] * p[0] / m[0] + p[1] * p[1] / m[1]) / (2.0 * mass)
        + stiffness * (0.5 * q[0] * q[0] + 0.7 * q[1] * q[1] + 0.3 * q[0] * q[0] * q[1] * q[1])
}

/// Time-dependent and not separable.
#[hamiltonian]
pub fn swinging_mass(t: f64, q: f64, p: f64, m: f64, a: f64, omega: f64) -> f64 {
    p * p / (2.0 * m * (1.0 + a * q * q + 0.2 * (omega * t).sin())) + 0.5 * q * q + 0.25 * q.powi(4)
        - 0.3 * q * (omega * t).cos()
}

/// A spring that is harder on one side; the force is continuous.
#[hamiltonian]
pub fn one_sided(q: [f64; 2], p: [f64; 2], m: [f64; 2], k: [f64; 2]) -> f64 {
    let wall = if q[0] > q[1] { k[0] * (q[0] - q[1]).powi(3) } else { k[1] * (q[1] - q[0]).powi(4) };
    p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + 0.5 * (q[0] * q[0] + q[1] * q[1]) + wall
}

/// Gravity between three bodies in space.
#[hamiltonian]
pub fn three_bodies(q: [Vector3<f64>; 3], p: [Vector3<f64>; 3], m: [f64; 3], g: f64) -> f64 {
    let kinetic: f64 = p.iter().zip(m.iter()).map(|(p, m)| p.norm_squared() / (2.0 * m)).sum();
    let mut potential = 0.0;
    for i in 0..3 {
        for j in 0..i {
            potential -= g * m[i] * m[j] / (q[i] - q[j]).norm();
        }
    }
    kinetic + potential
}

/// A closed lattice of three masses in the plane with cubic and quartic springs.
#[hamiltonian]
pub fn lattice(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], k: f64) -> f64 {
    let mut h = 0.0;
    for i in 0..3 {
        for c in 0..2 {
            let d = q[(i + 1) % 3][c] - q[i][c];
            h += p[i][c] * p[i][c] / (2.0 * m[i]) + 0.5 * k * d * d + 0.1 * d * d * d + 0.25 * d * d * d * d;
        }
    }
    h
}

/// Toda's lattice with fixed ends and different masses.
#[hamiltonian]
pub fn toda(q: [f64; 3], p: [f64; 3], m: [f64; 3], a: f64) -> f64 {
    let kinetic = (0..3).map(|i| p[i] * p[i] / (2.0 * m[i])).sum::<f64>();
    let springs: f64 = q.windows(2).map(|pair| (a * (pair[0] - pair[1])).exp()).sum();
    kinetic + springs + (-a * q[0]).exp() + (a * q[2]).exp()
}

/// Predators eᵖ and prey e^q: separable, no quadratic part at all.
#[hamiltonian]
pub fn lotka_volterra(q: f64, p: f64, a: f64, b: f64, c: f64, d: f64) -> f64 {
    b * p.exp() - c * p + d * q.exp() - a * q
}

/// A charge in a magnetic field that is not uniform: p meets q in (p − A(q))².
#[hamiltonian]
pub fn magnetic(q: [f64; 3], p: [f64; 3], m: f64, b: f64, k: f64) -> f64 {
    let strength = b * (1.0 + 0.2 * q[0] * q[0]);
    let velocity = [p[0] + 0.5 * strength * q[1], p[1] - 0.5 * strength * q[0], p[2]];
    velocity.iter().map(|v| v * v).sum::<f64>() / (2.0 * m) + k * (q[2] * q[2] - 0.5 * (q[0] * q[0] + q[1] * q[1]))
}

/// Spherical coordinates (r, θ, φ): φ is cyclic, the potential logarithmic.
#[hamiltonian]
pub fn spherical(q: [f64; 3], p: [f64; 3], m: f64, v: f64) -> f64 {
    let [r, theta, _] = q;
    let transverse = p[1] * p[1] + p[2] * p[2] / (theta.sin() * theta.sin());
    (p[0] * p[0] + transverse / (r * r)) / (2.0 * m) + v * (r * r + 0.3 * r * theta.cos() + 0.5).ln()
}

/// A pendulum of type `f32`.
#[hamiltonian]
pub fn short_pendulum(q: f32, p: f32, m: f32, l: f32, g: f32) -> f32 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}

/// A heavy body with two light ones, which move in Jacobi's coordinates where a method asks for that; and a force from outside.
#[hamiltonian(coordinates = jacobi)]
pub fn planets(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], g: f64, k: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
        for j in 0..i {
            energy -= g * m[i] * m[j] / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
        }
    }
    energy + k * q[2][0] * q[0][1]
}

/// An oscillator that hardens, and is driven.
#[hamiltonian]
pub fn driven_duffing(q: f64, p: f64, t: f64, m: f64, k: f64, lambda: f64, omega: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0 + lambda * (q.powi(4) / 4.0 - q * (omega * t).cos())
}

/// An energy with parameters and a start, over any scalar.
pub trait Problem {
    /// The system over another scalar.
    type Over<R: Scalar>: Collocation<R> + Hamiltonian<R>;
    /// The name of the function.
    const NAME: &'static str;
    /// Positions and momenta at the start.
    const START: (&'static [f64], &'static [f64]);

    /// The system with its parameters.
    fn system<R: Scalar>() -> Self::Over<R>;

    /// The function as the user wrote it.
    fn written(t: f64, q: &[f64], p: &[f64]) -> f64;

    /// The start at time `t`.
    fn initial<R: Scalar>(t: f64) -> State<Coords<Self, R>> {
        let (q, p) = Self::START;
        state::<Self::Over<R>, R>(t, q, p)
    }
}

/// Positions or momenta of a problem over `R`.
pub type Coords<P, R> = <<P as Problem>::Over<R> as Cotangent<R>>::Coordinates;

/// A point from plain numbers.
pub fn state<S: Hamiltonian<R>, R: Scalar>(t: f64, q: &[f64], p: &[f64]) -> State<S::Coordinates> {
    let shape = |x: &[f64]| {
        let mut array = S::Array::zero();
        assert_eq!(x.len(), S::Array::LEN);
        for (to, from) in array.as_mut_slice().iter_mut().zip(x) {
            *to = R::from_f64(*from);
        }
        S::Coordinates::from_array(array)
    };
    State::at(R::from_f64(t), shape(q), shape(p))
}

/// A parameter of another scalar.
pub(crate) trait Over<T> {
    fn over(self) -> T;
}

impl<R: Scalar> Over<R> for f64 {
    fn over(self) -> R {
        R::from_f64(self)
    }
}

impl<R: Scalar, const N: usize> Over<[R; N]> for [f64; N] {
    fn over(self) -> [R; N] {
        self.map(R::from_f64)
    }
}

/// Plain numbers in the shape of the user's function.
pub(crate) trait Shaped {
    fn shaped(x: &[f64]) -> Self;
}

impl Shaped for f64 {
    fn shaped(x: &[f64]) -> f64 {
        x[0]
    }
}

impl<T: Shaped + Copy, const N: usize> Shaped for [T; N] {
    fn shaped(x: &[f64]) -> [T; N] {
        let part = x.len() / N;
        core::array::from_fn(|i| T::shaped(&x[i * part..(i + 1) * part]))
    }
}

impl<const N: usize> Shaped for SVector<f64, N> {
    fn shaped(x: &[f64]) -> Self {
        SVector::from_column_slice(x)
    }
}

macro_rules! problems {
    ($t:ident $q:ident $p:ident: $($function:ident $System:ident { $($field:ident: $value:expr),* } ($($argument:ident),*) at $q0:expr, $p0:expr;)*) => { $(
        impl Problem for $System {
            type Over<R: Scalar> = $System<R>;
            const NAME: &'static str = stringify!($function);
            const START: (&'static [f64], &'static [f64]) = (&$q0, &$p0);

            fn system<R: Scalar>() -> $System<R> {
                $System { $($field: $value.over()),* }
            }
            #[allow(unused_variables, reason = "most energies do not depend on time")]
            fn written($t: f64, $q: &[f64], $p: &[f64]) -> f64 {
                $(let $field = $value;)*
                let ($q, $p) = (Shaped::shaped($q), Shaped::shaped($p));
                $function($($argument),*)
            }
        }
    )* };
}

pub(crate) use problems;

problems! { t q p:
    pendulum Pendulum { m: 1.3, l: 0.7, g: 9.81 } (q, p, m, l, g) at [1.1], [0.4];
    kepler Kepler { mass: 1.6, mu: 2.3 } (q, p, mass, mu) at [0.9, 0.2], [-0.3, 1.9];
    kepler_vector KeplerVector { mass: 1.6, mu: 2.3 } (q, p, mass, mu) at [0.9, 0.2], [-0.3, 1.9];
    henon_heiles HenonHeiles { m: [1.7, 0.6], lambda: 0.8 } (q, p, m, lambda) at [0.3, -0.2], [0.35, 0.25];
    quartic_chain QuarticChain { w: [0.6, 1.9], k: [1.2, 0.8, 1.5] } (q, p, w, k) at [0.5, -0.7], [0.4, 0.6];
    double_pendulum DoublePendulum { m1: 1.4, m2: 0.8, l1: 0.9, l2: 1.2, g: 3.0 } (q, p, m1, m2, l1, l2, g)
        at [0.7, -0.4], [0.3, 0.5];
    relativistic Relativistic { m: [0.8, 1.5], k: 1.3 } (q, p, m, k) at [0.6, -0.4], [0.7, 0.5];
    driven_pendulum DrivenPendulum { m: 1.4, g: 2.1, drive: 0.6, omega: 2.3 } (t, q, p, m, g, drive, omega) at [0.8], [0.5];
    breathing Breathing { m: [1.6, 0.7], omega: 2.1 } (q, p, t, m, omega) at [0.6, -0.5], [0.4, 0.7];
    swinging_mass SwingingMass { m: 1.3, a: 0.6, omega: 2.2 } (t, q, p, m, a, omega) at [0.7], [0.8];
    one_sided OneSided { m: [1.4, 0.7], k: [0.9, 1.6] } (q, p, m, k) at [0.5, -0.3], [-0.8, 0.4];
    three_bodies ThreeBodies { m: [1.8, 0.7, 1.2], g: 0.9 } (q, p, m, g)
        at [1.2, 0.1, -0.2, -0.9, 0.4, 0.3, 0.2, -1.3, 0.5], [0.1, 0.5, 0.2, -0.2, -0.6, 0.1, 0.4, 0.3, -0.3];
    lattice Lattice { m: [1.5, 0.6, 0.9], k: 1.3 } (q, p, m, k)
        at [0.3, -0.4, 0.7, 0.2, -0.5, 0.6], [0.2, 0.3, -0.4, 0.1, 0.5, -0.6];
    toda Toda { m: [1.5, 0.7, 1.1], a: 1.2 } (q, p, m, a) at [0.2, -0.3, 0.4], [0.3, 0.5, -0.6];
    lotka_volterra LotkaVolterra { a: 1.3, b: 0.9, c: 1.6, d: 0.7 } (q, p, a, b, c, d) at [0.3], [-0.4];
    magnetic Magnetic { m: 1.3, b: 1.7, k: 0.4 } (q, p, m, b, k) at [0.5, -0.3, 0.4], [0.4, 0.6, -0.3];
    planets Planets { m: [1.3, 0.02, 0.01], g: 1.1, k: 0.003 } (q, p, m, g, k)
        at [0.1, -0.2, 1.0, 0.1, -1.9, 0.4], [0.01, -0.02, 0.003, 0.023, -0.001, -0.0085];
    driven_duffing DrivenDuffing { m: 1.4, k: 1.7, lambda: 0.3, omega: 2.1 } (q, p, t, m, k, lambda, omega) at [0.6], [0.5];
    spherical Spherical { m: 1.4, v: 0.9 } (q, p, m, v) at [1.1, 1.0, 0.3], [0.2, -0.4, 0.7];
}

/// Calls a macro once for every problem: `$call!(System)`.
#[macro_export]
macro_rules! for_each_problem {
    ($call:ident) => {
        for_each_problem!($call: Pendulum Kepler KeplerVector HenonHeiles QuarticChain DoublePendulum Relativistic
            DrivenPendulum Breathing SwingingMass OneSided ThreeBodies Lattice Toda LotkaVolterra Magnetic Spherical);
    };
    ($call:ident: $($System:ident)*) => { $( $call!($System); )* };
}
