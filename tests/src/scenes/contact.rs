//! Contact systems: friction that is constant, comes and goes, or fades; with T + g·s + V and without.

use crate::scalars::Scalar;
use crate::scene::{Scene, contact_defect, point};
use geoint_runtime::space::{Array, Snapshot};
use geoint_runtime::{Contact, Real, contact_hamiltonian};

/// Kick and drift exact in time.
#[contact_hamiltonian]
pub fn swing(q: f64, p: f64, s: f64, t: f64, m: f64, g: f64, gamma: f64) -> f64 {
    p * p / (2.0 * m) - g * q.cos() + gamma * s + 0.3 * t.cos() * q
}

/// Coupled masses under friction that comes and goes: time is frozen.
#[contact_hamiltonian]
pub fn driven(q: [f64; 2], p: [f64; 2], s: f64, t: f64, a: f64) -> f64 {
    let kinetic = p[0] * p[0] / 3.4 + p[1] * p[1] / 1.2 + 0.3 * p[0] * p[1];
    kinetic + a * (0.7 + (1.3 * t).sin()) * s + q[0].powi(4) / 4.0 + (q[0] - q[1]).cosh() + t.cos() * q[1]
}

/// Coupled masses, whose mass matrix is not diagonal, under constant friction.
#[contact_hamiltonian]
pub fn coupled(q: [f64; 2], p: [f64; 2], s: f64, t: f64, a: f64) -> f64 {
    let kinetic = p[0] * p[0] / 3.4 + p[1] * p[1] / 1.2 + 0.3 * p[0] * p[1];
    kinetic + a * s + q[0].powi(4) / 4.0 + (q[0] - q[1]).cosh() + t.cos() * q[1]
}

/// Friction 2/t.
#[contact_hamiltonian]
pub fn star(q: f64, p: f64, s: f64, t: f64, k: f64) -> f64 {
    p * p / 2.0 + 2.0 / t * s + k * q.powi(4) / 4.0
}

/// Friction k/(t₀ + t) of a parameter.
#[contact_hamiltonian]
pub fn cooling(q: f64, p: f64, s: f64, t: f64, k: f64, since: f64) -> f64 {
    p * p / 3.4 + k / (since + t) * s + 0.35 * q.powi(4) + 0.2 * t.sin() * q
}

/// A relativistic oscillator with friction: T is not quadratic.
#[contact_hamiltonian]
pub fn relativistic_with_friction(q: f64, p: f64, s: f64, m: f64, gamma: f64) -> f64 {
    (m * m + p * p).sqrt() + q * q / 2.0 + 0.1 * q.powi(4) + gamma * s
}

/// Quartic kinetic energies under friction and forces that come and go.
#[contact_hamiltonian]
pub fn quartic(q: [f64; 2], p: [f64; 2], s: f64, t: f64, a: f64) -> f64 {
    let kinetic = (1.0 + 0.2 * t.cos()) * p[0].powi(4) / 4.0 + (p[0] - p[1]).powi(2) / 3.4 + (0.3 * p[1]).cosh();
    kinetic + a * (0.7 + (1.3 * t).sin()) * s + q[0].powi(4) / 4.0 + (q[0] - q[1]).cosh() + t.cos() * q[1]
}

/// A wind that carries along, and friction 1.7/(t₀ + t).
#[contact_hamiltonian]
pub fn blown(q: f64, p: f64, s: f64, t: f64, wind: f64, since: f64) -> f64 {
    p * p / 3.4 + wind * p + 1.7 * s / (t + since) - 1.3 * q.cos()
}

/// Three pieces, none of which is a drift or a kick.
#[contact_hamiltonian]
pub fn tangled(q: f64, p: f64, s: f64, t: f64, a: f64) -> f64 {
    a * p * s + (0.3 + q * q) * s + q.sin() + 0.2 * (1.0 + 0.4 * (t * t).sin()) * p * p * q * q + 0.3 * p * p
}

/// A charge in a magnetic field and a trap, with friction: squares of sums.
#[contact_hamiltonian]
pub fn charge(q: [f64; 2], p: [f64; 2], s: f64, b: f64, g: f64) -> f64 {
    let kinetic = (p[0] + b * q[1]).powi(2) / 3.4 + (p[1] - b * q[0]).powi(2) / 3.4;
    kinetic + (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2) / 4.0 + g * s
}

/// [q', p', s'] of a contact system.
pub fn contact_field<S: Contact<R>, R: Real>(system: &S, t: R, x: &[R]) -> Vec<R> {
    let (_, z, s) = point::<S::State>(t, x).parts();
    let energy = system.hamiltonian(t, &z, &s);
    let (mut slopes, mut ds) = (S::Phase::zero(), R::from_f64(0.0));
    system.gradient(t, &z, &s, &mut slopes, &mut ds);
    let (p, dq, dp) = (z[1].as_slice(), slopes[0].as_slice(), slopes[1].as_slice());
    let power = p.iter().zip(dp).fold(R::from_f64(0.0), |sum, (p, rate)| sum + *p * *rate);
    let forces = p.iter().zip(dq).map(|(p, slope)| -*slope - *p * ds);
    dp.iter().copied().chain(forces).chain([power - energy]).collect()
}

macro_rules! scenes {
    ($($scene:ident $System:ident { $($field:ident: $value:expr),* } from $t:expr, $x:expr $(, decaying by $rate:expr)?;)*) => { $(
        #[doc = concat!("[`", stringify!($System), "`] from a start.")]
        #[derive(Clone, Copy, Debug)]
        pub struct $scene;

        impl Scene for $scene {
            type Over<R: Scalar> = $System<R>;
            const NAME: &'static str = stringify!($System);

            fn over<R: Scalar>() -> $System<R> {
                $System { $($field: R::from_f64($value)),* }
            }
            fn start() -> (f64, Vec<f64>) {
                ($t, $x.to_vec())
            }
            fn rate<R: Scalar>(system: &$System<R>, t: R, x: &[R]) -> Vec<R> {
                contact_field(system, t, x)
            }
            fn form_defect(_: &[Vec<f64>], images: &[Vec<f64>], before: &[f64], after: &[f64]) -> f64 {
                contact_defect(images, before, after)
            }
            $(fn energy_after(duration: f64, energy: f64) -> f64 {
                energy * (-$rate * duration).exp()
            })?
        }
    )* };
}

scenes! {
    Swings Swing { m: 1.7, g: 1.3, gamma: 0.4 } from 0.2, [1.1, 0.6, 0.3];
    Drives Driven { a: 0.6 } from 0.2, [0.7, -0.4, 0.5, 0.8, 0.3];
    Coolings Cooling { k: 1.7, since: 0.4 } from 0.2, [1.0, -0.2, 0.1];
    Relativists RelativisticWithFriction { m: 0.8, gamma: 0.4 } from 0.2, [0.7, 0.5, 0.3], decaying by 0.4;
    Quartics Quartic { a: 0.6 } from 0.2, [0.7, -0.4, 0.5, 0.8, 0.3];
    Blows Blown { wind: 0.6, since: 0.4 } from 0.2, [0.7, 0.5, 0.3];
    Masses Coupled { a: 0.4 } from 0.2, [0.7, -0.4, 0.5, 0.8, 0.3];
    Stars Star { k: 1.4 } from 0.6, [1.0, -0.2, 0.1];
    Charges Charge { b: 0.8, g: 0.4 } from 0.0, [0.7, -0.4, 0.5, 0.8, 0.3], decaying by 0.4;
    Tangles Tangled { a: 0.7 } from 0.2, [0.6, 0.4, 0.3];
}
