//! Contact systems with their equations written by hand, and measurements of methods for them.

use crate::measure;
pub(super) use crate::measure::flat;
use geoint_runtime::prelude::*;
use geoint_runtime::{Contact, Cotangent};
use geoint_tests::measure::{LOOKS, distance, extrapolated, observed_order};
use geoint_tests::scalars::{Double, Dual, Scalar};

/// A pendulum with damping that grows with s.
#[contact_hamiltonian]
pub(super) fn pendulum(q: f64, p: f64, s: f64, g: f64, e: f64) -> f64 {
    p * p / 2.0 - q.cos() + g * s + e * s * s / 2.0
}

/// Two masses, coupled, under damping that depends on time.
#[contact_hamiltonian]
pub(super) fn coupled(q: [f64; 2], p: [f64; 2], s: f64, t: f64, m: [f64; 2], w: f64) -> f64 {
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    kinetic - 0.6 * (q[0] - q[1]).cos() + 0.25 * q[1].powi(4) + (0.3 + 0.2 * (w * t).sin()) * s + 0.1 * s * s
}

/// No sum of pieces with known flows.
#[contact_hamiltonian]
pub(super) fn entangled(q: f64, p: f64, s: f64, m: f64) -> f64 {
    p * p / (2.0 * m) * (q * s).cosh() + 0.3 * (q * p).sin() * s + 0.5 * q * q
}

/// A system, where it starts, and its equation written by hand.
pub(super) trait Case {
    const NAME: &'static str;
    const LEN: usize;
    type Over<R: Scalar>: Contact<R>;
    fn system<R: Scalar>() -> Self::Over<R>;
    fn start() -> Vec<f64>;
    fn field<R: Scalar>(t: R, x: &[R]) -> Vec<R>;
}

pub(super) type Point<S, R> = geoint_runtime::ContactState<<S as Cotangent<R>>::Coordinates>;

pub(super) fn real<R: Scalar>(x: f64) -> R {
    R::from_f64(x)
}

/// The pendulum with constant damping.
pub(super) struct PendulumCase;
impl Case for PendulumCase {
    const NAME: &'static str = "pendulum";
    const LEN: usize = 1;
    type Over<R: Scalar> = Pendulum<R>;
    fn system<R: Scalar>() -> Pendulum<R> {
        Pendulum { g: real(0.4), e: real(0.0) }
    }
    fn start() -> Vec<f64> {
        vec![1.0, 0.5, 0.3]
    }
    fn field<R: Scalar>(_: R, x: &[R]) -> Vec<R> {
        let ([q, p, s], half, g) = ([x[0], x[1], x[2]], real::<R>(0.5), real::<R>(0.4));
        vec![p, -q.sin() - p * g, half * p * p + q.cos() - g * s]
    }
}

pub(super) struct CoupledCase;
impl Case for CoupledCase {
    const NAME: &'static str = "coupled";
    const LEN: usize = 2;
    type Over<R: Scalar> = Coupled<R>;
    fn system<R: Scalar>() -> Coupled<R> {
        Coupled { m: [real(1.3), real(0.7)], w: real(1.7) }
    }
    fn start() -> Vec<f64> {
        vec![0.9, -0.4, 0.5, 0.8, 0.3]
    }
    fn field<R: Scalar>(t: R, x: &[R]) -> Vec<R> {
        let [q0, q1, p0, p1, s] = [x[0], x[1], x[2], x[3], x[4]];
        let c = |x: f64| real::<R>(x);
        let drag = c(0.3) + c(0.2) * (c(1.7) * t).sin();
        let sigma = drag + c(0.2) * s;
        let twist = c(0.6) * (q0 - q1).sin();
        let kinetic = p0 * p0 / c(2.6) + p1 * p1 / c(1.4);
        let rest = c(0.25) * q1 * q1 * q1 * q1 - c(0.6) * (q0 - q1).cos() + drag * s + c(0.1) * s * s;
        vec![p0 / c(1.3), p1 / c(0.7), -twist - p0 * sigma, twist - q1 * q1 * q1 - p1 * sigma, kinetic - rest]
    }
}

pub(super) struct EntangledCase;
impl Case for EntangledCase {
    const NAME: &'static str = "entangled";
    const LEN: usize = 1;
    type Over<R: Scalar> = Entangled<R>;
    fn system<R: Scalar>() -> Entangled<R> {
        Entangled { m: real(1.6) }
    }
    fn start() -> Vec<f64> {
        vec![0.8, -0.5, 0.4]
    }
    fn field<R: Scalar>(_: R, x: &[R]) -> Vec<R> {
        let [q, p, s] = [x[0], x[1], x[2]];
        let c = |x: f64| real::<R>(x);
        let (cosh, sinh) = ((q * s).cosh(), (q * s).sinh());
        let (sin, cos) = ((q * p).sin(), (q * p).cos());
        let energy = p * p / c(3.2) * cosh + c(0.3) * sin * s + c(0.5) * q * q;
        let along_p = p / c(1.6) * cosh + c(0.3) * q * cos * s;
        let along_q = p * p / c(3.2) * s * sinh + c(0.3) * p * cos * s + q;
        let along_s = p * p / c(3.2) * q * sinh + c(0.3) * sin;
        vec![along_p, -along_q - p * along_s, p * along_p - energy]
    }
}

pub(super) fn state<S: Contact<R>, R: Scalar>(t: f64, x: &[R]) -> Point<S, R> {
    measure::state(real(t), x)
}

pub(super) fn over<R: Scalar>(x: Vec<f64>) -> Vec<R> {
    x.into_iter().map(real).collect()
}

pub(super) const FROM: f64 = 0.4;
pub(super) const FOR: f64 = 1.9;

/// The error in double-double, in the root-mean-square of all looks.
pub(super) fn error<P: Case, M: Method<P::Over<Double>, Double>>(method: M, n: u64, expected: &[Vec<Double>]) -> f64 {
    let start = state::<P::Over<Double>, Double>(FROM, &over(P::start()));
    let mut sim = P::system::<Double>().integrator(method, Double::from(FOR) / n as f64, start);
    let mut sum = 0.0;
    for expected in expected {
        if sim.advance(n / LOOKS).is_err() {
            return f64::INFINITY;
        }
        sum += distance(&flat(&sim.state()), expected).powi(2);
    }
    (sum / LOOKS as f64).sqrt()
}

pub(super) fn solutions<P: Case>() -> Vec<Vec<Double>> {
    let solve = |look: u64| {
        let part = Double::from(FOR) * look as f64 / LOOKS as f64;
        extrapolated(P::field::<Double>, FROM.into(), over(P::start()), part, 6 * look as usize)
    };
    (1..=LOOKS).map(solve).collect()
}

pub(super) fn has_order<P: Case, M: Method<P::Over<Double>, Double>>(name: &str, method: M, expected: &[Vec<Double>]) {
    let order = observed_order(|n| error::<P, M>(method, n, expected));
    let claimed = f64::from(method.claims().order);
    assert!((order - claimed).abs() < 0.15, "{name} on {}: order {order:.3}, not {claimed}", P::NAME);
}
pub(super) fn symmetric<P: Case, M: Method<P::Over<f64>, f64>>(method: M) {
    for h in [0.02, 0.15] {
        let start = state::<P::Over<f64>, f64>(FROM, &P::start());
        let mut sim = P::system::<f64>().integrator(method, h, start);
        sim.advance(3).unwrap();
        let away = distance(&flat(&sim.state()), &P::start());
        sim.set_step_size(-h);
        sim.advance(3).unwrap();
        let defect = distance(&flat(&sim.state()), &P::start());
        assert!(away > 0.01 && defect <= 1e-14, "{}: {away}, {defect:.1e}", P::NAME);
    }
}
/// The largest entry of φ*(ds − p dq) − λ (ds − p dq) with λ from ∂/∂s, and λ.
pub(super) fn contact_defect<P: Case, M: Method<P::Over<Dual>, Dual>>(method: M, steps: u64) -> (f64, f64) {
    let n = P::LEN;
    let form = |seed: usize| {
        let mut x = over::<Dual>(P::start());
        x[seed] = Dual::variable(x[seed].value());
        let mut sim = P::system::<Dual>().integrator(method, 0.15.into(), state::<P::Over<Dual>, Dual>(FROM, &x));
        sim.advance(steps).unwrap();
        let end = flat(&sim.state());
        let work: f64 = (0..n).map(|i| end[n + i].value() * end[i].derivative()).sum();
        end[2 * n].derivative() - work
    };
    let (start, factor) = (P::start(), form(2 * n));
    let along_q = (0..n).map(|i| (form(i) + factor * start[n + i]).abs());
    let along_p = (0..n).map(|i| form(n + i).abs());
    (along_q.chain(along_p).fold(0.0, f64::max), factor)
}
