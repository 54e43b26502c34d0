//! Damped systems, and the dissipation of each.

use super::ByHand;
use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{DiscreteField, SolvedByGauss};
use geoint_tests::scalars::Scalar;

/// Duffing's oscillator with the same damping everywhere.
#[hamiltonian(damping = c)]
pub(super) fn duffing(q: f64, p: f64, m: f64, k: f64, c: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0 + q.powi(4) / 4.0
}

/// Two masses, one of them in a medium that changes from place to place and with time.
#[hamiltonian(damping = [c * (1.0 + q[0] * q[0]) * (1.0 + 0.5 * (1.3 * t).sin()), 0.0])]
pub(super) fn medium(q: [f64; 2], p: [f64; 2], t: f64, m: [f64; 2], k: f64, c: f64) -> f64 {
    let d = q[1] - q[0];
    p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + k * (q[0] * q[0] + d * d) / 2.0 + q[1].powi(4) / 4.0
}

/// A mass that depends on position, and a full matrix that depends on momenta.
#[hamiltonian(damping = [[a, b], [b, d * (1.0 + p[0] * p[0])]])]
pub(super) fn swing(q: [f64; 2], p: [f64; 2], m: [f64; 2], a: f64, b: f64, d: f64) -> f64 {
    let kinetic = p[0] * p[0] / (2.0 * m[0] * (1.0 + q[1] * q[1])) + p[1] * p[1] / (2.0 * m[1]);
    kinetic + (q[0] * q[0] + q[1] * q[1]) / 2.0 + q[0] * q[0] * q[1] * q[1] + q[0].powi(4) / 4.0
}

/// Two masses on a spring between them that loses energy when it changes its length.
#[hamiltonian(damping = [[c, -c], [-c, c]])]
pub(super) fn shock_absorber(q: [f64; 2], p: [f64; 2], m: [f64; 2], c: f64) -> f64 {
    let d = q[1] - q[0];
    p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + d * d / 2.0 + d.powi(4) / 4.0
}

/// Everything is linear.
#[hamiltonian(damping = c)]
pub(super) fn oscillator(q: [f64; 2], p: [f64; 2], m: [f64; 2], k: [f64; 2], c: [f64; 2]) -> f64 {
    (0..2).map(|i| p[i] * p[i] / (2.0 * m[i]) + k[i] * q[i] * q[i] / 2.0).sum::<f64>()
}

/// Damping only beyond q = ±1; closer to the origin it would feed energy, as in van der Pol's oscillator.
#[hamiltonian(damping = c * (q * q - 1.0))]
pub(super) fn van_der_pol(q: f64, p: f64, m: f64, c: f64) -> f64 {
    p * p / (2.0 * m) + q * q / 2.0
}

/// Damping that feeds energy where coordinates are coupled by more than each is damped: beyond q[0] = ±1.
#[hamiltonian(damping = [[c, c * q[0]], [c * q[0], c]])]
pub(super) fn twist(q: [f64; 2], p: [f64; 2], m: [f64; 2], c: f64) -> f64 {
    p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + (q[0] * q[0] + q[1] * q[1]) / 2.0
}

/// A damped system, and the same system written by hand.
pub(super) trait Damped {
    type Over<R: Scalar>: DiscreteField<R> + Hamiltonian<R> + SolvedByGauss<R> + SolvedBy<DiscreteGradient, R>;
    const START: (&'static [f64], &'static [f64]);
    fn system<R: Scalar>() -> Self::Over<R>;
    fn by_hand<R: Scalar>(t: R, q: &[R], p: &[R]) -> ByHand<R>;
}

impl Damped for Duffing {
    type Over<R: Scalar> = Duffing<R>;
    const START: (&'static [f64], &'static [f64]) = (&[1.2], &[0.3]);
    fn system<R: Scalar>() -> Duffing<R> {
        Duffing { m: R::from_f64(1.3), k: R::from_f64(0.8), c: R::from_f64(0.1) }
    }
    fn by_hand<R: Scalar>(_: R, q: &[R], p: &[R]) -> ByHand<R> {
        let r = R::from_f64;
        (vec![p[0] / r(1.3)], vec![-(r(0.8) * q[0] + q[0] * q[0] * q[0])], vec![vec![r(0.1)]])
    }
}

impl Damped for Medium {
    type Over<R: Scalar> = Medium<R>;
    const START: (&'static [f64], &'static [f64]) = (&[0.7, -0.5], &[0.4, 0.9]);
    fn system<R: Scalar>() -> Medium<R> {
        Medium { m: [1.4, 0.6].map(R::from_f64), k: R::from_f64(1.1), c: R::from_f64(0.3) }
    }
    fn by_hand<R: Scalar>(t: R, q: &[R], p: &[R]) -> ByHand<R> {
        let r = R::from_f64;
        let stretch = r(1.1) * (q[1] - q[0]);
        let drag = r(0.3) * (r(1.0) + q[0] * q[0]) * (r(1.0) + r(0.5) * (r(1.3) * t).sin());
        (
            vec![p[0] / r(1.4), p[1] / r(0.6)],
            vec![stretch - r(1.1) * q[0], -stretch - q[1] * q[1] * q[1]],
            vec![vec![drag, r(0.0)], vec![r(0.0), r(0.0)]],
        )
    }
}

impl Damped for Swing {
    type Over<R: Scalar> = Swing<R>;
    const START: (&'static [f64], &'static [f64]) = (&[0.6, -0.8], &[0.5, -0.3]);
    fn system<R: Scalar>() -> Swing<R> {
        let [a, b, d] = [0.2, -0.1, 0.15].map(R::from_f64);
        Swing { m: [1.4, 0.7].map(R::from_f64), a, b, d }
    }
    fn by_hand<R: Scalar>(_: R, q: &[R], p: &[R]) -> ByHand<R> {
        let r = R::from_f64;
        let (x, y) = (q[0], q[1]);
        let swell = r(1.0) + y * y;
        let speed = p[0] / (r(1.4) * swell);
        (
            vec![speed, p[1] / r(0.7)],
            vec![-(x + r(2.0) * x * y * y + x * x * x), speed * p[0] * y / swell - y - r(2.0) * x * x * y],
            vec![vec![r(0.2), r(-0.1)], vec![r(-0.1), r(0.15) * (r(1.0) + p[0] * p[0])]],
        )
    }
}
