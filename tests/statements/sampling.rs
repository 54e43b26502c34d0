//! S17 and S60: contact flows with a known density, and thermostats for sampling. Numbers of steps were computed beforehand by another program.

use crate::derivative::Derivative;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Contact, Method};
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::Dual;
use geoint_tests::scenes::contact_field;

/// The logistic thermostat of a double well. x is (q, p, s, η), and η' is the divergence of the field.
#[contact_hamiltonian(
    lift,
    q = x,
    measure = (-beta * (x[1] * x[1] / 2.0 + x[0].powi(4) / 4.0 - x[0] * x[0] / 2.0)).exp() / (x[2] / (2.0 * width)).cosh().powi(2)
)]
fn logistic(x: [f64; 4], p: [f64; 4], _s: f64, beta: f64, width: f64) -> f64 {
    let g = -(x[2] / (2.0 * width)).tanh() / (beta * width);
    p[0] * x[1] + p[1] * (x[0] - x[0].powi(3) + g * x[1]) + p[2] * (x[1] * x[1] - 1.0 / beta) + p[3] * g
}

/// The same motion as a field. `energy` is E − ln(f)/β − η/β.
#[vector_field(
    keeps(energy = x[1] * x[1] / 2.0 + x[0].powi(4) / 4.0 - x[0] * x[0] / 2.0 + (2.0 * (x[2] / (2.0 * width)).cosh().ln() - x[3]) / beta),
    measure = (-beta * (x[1] * x[1] / 2.0 + x[0].powi(4) / 4.0 - x[0] * x[0] / 2.0)).exp() / (x[2] / (2.0 * width)).cosh().powi(2)
)]
fn logistic_field(x: [f64; 4], beta: f64, width: f64) -> [f64; 4] {
    let g = -(x[2] / (2.0 * width)).tanh() / (beta * width);
    [x[1], x[0] - x[0].powi(3) + g * x[1], x[1] * x[1] - 1.0 / beta, g]
}

/// Nosé–Hoover thermostat of an oscillator of mass m: f is Gauss' function of s.
#[vector_field(measure = (-beta * (x[1] * x[1] / (2.0 * m) + x[0] * x[0] / 2.0) - beta * x[2] * x[2] / (2.0 * inertia)).exp())]
fn nose_hoover(x: [f64; 3], m: f64, beta: f64, inertia: f64) -> [f64; 3] {
    [x[1] / m, -x[0] - x[2] / inertia * x[1], x[1] * x[1] / m - 1.0 / beta]
}

/// (ρf)^(−1/2) of the density ρ = e^(−βE), E = p²/2m + q⁴/4 − q²/2, and of f = 1/cosh²(s/2Q).
#[contact_hamiltonian]
fn density_dynamics(q: f64, p: f64, s: f64, m: f64, beta: f64, width: f64) -> f64 {
    (beta * (p * p / (2.0 * m) + q.powi(4) / 4.0 - q * q / 2.0) / 2.0).exp() * (s / (2.0 * width)).cosh()
}

/// (ρf)^(−1/n) with n = 1.
#[contact_hamiltonian]
fn generator(q: f64, p: f64, s: f64, m: f64, beta: f64, width: f64) -> f64 {
    (beta * (p * p / (2.0 * m) + q.powi(4) / 4.0 - q * q / 2.0)).exp() * (s / (2.0 * width)).cosh().powi(2)
}

const START: [f64; 3] = [0.3, 1.1, 0.15];

/// det D(q, p, s) = e^(Δη) of 15 steps of 0.1 with β = 1 and Q = 0.1.
const VOLUME: f64 = 0.551_477_888_86;

const KEPT: &str = "the density ρ is kept by the flow; steps keep it to their order";

/// Returns (q, p, s, η) after 15 steps of the lift.
fn steps<T: Real, M: Method<Logistic<T>, T>>(method: M, x: [T; 3]) -> [T; 4]
where
    Logistic<T>: Contact<T, Coordinates = [T; 4]>,
{
    let system = Logistic { beta: T::from_f64(1.0), width: T::from_f64(0.1) };
    let zero = T::from_f64(0.0);
    let start = ContactState { t: zero, q: [x[0], x[1], x[2], zero], p: [zero; 4], s: zero };
    let mut sim = system.integrator(method, T::from_f64(0.1), start);
    sim.advance(15).expect("fifteen steps");
    sim.state().q
}

/// Returns the derivative of (q, p, s), and η.
fn volume<M: Method<Logistic<Dual>, Dual> + Copy>(method: M) -> (Derivative, f64) {
    let map = Derivative::of(START.to_vec(), |x| steps(method, [x[0], x[1], x[2]])[..3].to_vec());
    (map, steps(method, START.map(Dual::from))[3].value())
}

#[test]
fn thermostats_keep_their_density() {
    for report in [Logistic::REPORT, LogisticField::REPORT, NoseHoover::REPORT] {
        assert!(report.contains(KEPT), "{report}");
    }
    assert!(LogisticField::REPORT.contains("kept, proven by multiplying out"), "{}", LogisticField::REPORT);
    assert!(Logistic::REPORT.contains("div(ρf) = 0, proven by multiplying out"), "{}", Logistic::REPORT);
}

/// det DΦ · ρ(Φ)/ρ = 1 for the flow of Nosé and Hoover, and to order 4 for steps of RK4.
#[test]
fn flows_keep_their_density_and_steps_to_their_order() {
    let (m, beta, inertia, start) = (1.3, 0.8, 0.6, [0.9, 0.4, -0.3]);
    let density =
        |x: &[f64]| (-beta * (x[1] * x[1] / (2.0 * m) + x[0] * x[0] / 2.0 + x[2] * x[2] / (2.0 * inertia))).exp();
    let defect = |map: &Derivative| (map.volume() * density(&map.after) / density(&map.before) - 1.0).abs();
    let field = |_: Dual, x: &[Dual]| vec![x[1] / m, -x[0] - x[2] / inertia * x[1], x[1] * x[1] / m - 1.0 / beta];
    let flow = Derivative::of(start.to_vec(), |x| extrapolated(field, 0.0.into(), x.to_vec(), 1.5.into(), 12));
    assert!(defect(&flow) < 1e-11 && (flow.volume() - 1.0).abs() > 0.05, "{:e} {}", defect(&flow), flow.volume());
    let [long, short] = [30_u32, 60].map(|steps| {
        defect(&Derivative::of(start.to_vec(), |x| {
            let system = NoseHoover { m: Dual::from(m), beta: beta.into(), inertia: inertia.into() };
            let mut sim =
                system.integrator(RK4, Dual::from(1.5 / f64::from(steps)), FlowState::new([x[0], x[1], x[2]]));
            sim.advance(steps.into()).expect("steps");
            sim.state().x.to_vec()
        }))
    });
    let order = (long / short).log2();
    // Another program has 1.449e-6 for the defect of 60 steps.
    assert!((order - 4.0).abs() < 0.05 && (short / 1.449e-6 - 1.0).abs() < 1e-3, "{order} {short:e}");
}

/// The volume of (q, p, s) changes by e^(Δη) exactly, so a step can be accepted or refused by the change of E − ln(f)/β − η/β alone.
#[test]
fn a_step_of_the_thermostat_has_an_exact_volume() {
    let (map, eta) = volume(ContactSplitting);
    let found = map.volume();
    assert!((found - VOLUME).abs() < 1e-11 && (found / eta.exp() - 1.0).abs() < 1e-13, "{found} {}", eta.exp());
    let (map, eta) = volume(Suzuki4.of(ContactSplitting));
    assert!((map.volume() / eta.exp() - 1.0).abs() < 1e-12, "{} {}", map.volume(), eta.exp());
    // Control: RK4 has this volume to its order only.
    let (map, eta) = volume(RK4);
    assert!((map.volume() / eta.exp() - 1.0).abs() > 1e-5, "{} {}", map.volume(), eta.exp());
}

#[test]
fn steps_of_the_thermostat_are_reversible() {
    fn off<M: Method<Logistic<f64>> + Copy>(method: M) -> f64 {
        let back = |[q, p, s]: [f64; 3]| {
            let [q, p, s, _] = steps(method, [q, p, s]);
            [q, -p, -s]
        };
        let returned = back(back(START));
        (0..3).map(|i| (returned[i] - START[i]).abs()).fold(0.0, f64::max)
    }
    assert!(off(ContactSplitting) < 2e-15, "{:e}", off(ContactSplitting));
    // Control.
    assert!(off(RK4) > 1e-5, "{:e}", off(RK4));
}

/// S17: h = (ρf)^(−1/(n+1)) has the density ρf.
#[test]
fn density_dynamics_keeps_the_density_it_is_made_from() {
    let (m, beta, width) = (1.3, 0.8, 0.6);
    assert!(DensityDynamics::REPORT.contains("|H|^−2 is the density of an invariant measure where H ≠ 0"));
    let density = |x: &[f64]| {
        let energy = x[1] * x[1] / (2.0 * m) + x[0].powi(4) / 4.0 - x[0] * x[0] / 2.0;
        (-beta * energy).exp() / (x[2] / (2.0 * width)).cosh().powi(2)
    };
    let system = DensityDynamics { m: m.into(), beta: beta.into(), width: width.into() };
    let flow = Derivative::of(START.to_vec(), |x| {
        extrapolated(|t, x: &[Dual]| contact_field(&system, t, x), 0.0.into(), x.to_vec(), 1.5.into(), 12)
    });
    let weight = density(&flow.after) / density(&flow.before);
    assert!((flow.volume() * weight - 1.0).abs() < 1e-10, "{} {weight}", flow.volume());
    // Control: neither the volume nor ρ without f is kept.
    assert!((flow.volume() - 1.0).abs() > 0.05, "{}", flow.volume());
}

/// S17: X_h/h with h = (ρf)^(−1/n) is the thermostat in the time τn/β, and keeps ρf as well.
#[test]
fn thermostats_are_contact_systems_in_another_time() {
    let (m, beta, width) = (1.3, 0.8, 0.6);
    let system = Generator { m, beta, width };
    for [q, p, s] in [[0.3, 1.1, 0.15], [-1.2, 0.4, -0.9], [2.0, -0.7, 1.6]] {
        let h = system.energy(&ContactState::new(q, p, s));
        let field = contact_field(&system, 0.0, &[q, p, s]);
        let g = -f64::tanh(s / (2.0 * width)) / (beta * width);
        let thermostat = [p / m, q - q * q * q + g * p, p * p / m - 1.0 / beta];
        for (found, expected) in field.iter().zip(thermostat) {
            assert!((found / (h * beta) - expected).abs() < 1e-13, "{found} {h} {expected}");
        }
    }
}
