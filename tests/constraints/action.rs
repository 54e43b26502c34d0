//! Constraints beside an action, H = H₀(q, p, t) + γ(t)·s. The references are angles of an extrapolation method with twenty digits, and the same system by an
//! angle.

use crate::systems::orders;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::bare::Bare;
use geoint_tests::measure::form_defect;
use geoint_tests::scalars::Dual;
use geoint_tests::scene::Scene;
use geoint_tests::scenes::{DampedEllipses, DampedSpheres};

/// A mass at a distance l of the origin, with friction.
#[contact_hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - l * l) / 2.0])]
fn slowed(q: [f64; 3], p: [f64; 3], s: f64, m: f64, l: f64, g: f64, gamma: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + m * g * q[2] + gamma * s
}

/// Units of length, mass and time.
#[derive(Clone, Copy)]
struct Units {
    l: f64,
    m: f64,
    t: f64,
}

const SI: Units = Units { l: 1.0, m: 1.0, t: 1.0 };
/// Powers of two, so that all numbers have the same digits.
const OTHERS: Units = Units { l: 8.0, m: 0.25, t: 0.5 };

fn slowed_in(Units { l, m, t }: Units, gamma: f64) -> Slowed {
    Slowed { m, l, g: 9.81 * l / (t * t), gamma: gamma / t }
}

/// A state from angles from below and about the vertical, and from their rates.
fn at_angles(Units { l, m, t }: Units, [a, b]: [f64; 2], [u, w]: [f64; 2], s: f64) -> ContactState<[f64; 3]> {
    let q = [a.sin() * b.cos(), a.sin() * b.sin(), -a.cos()];
    let v = [a.cos() * b.cos() * u - a.sin() * b.sin() * w, a.cos() * b.sin() * u + a.sin() * b.cos() * w, a.sin() * u];
    ContactState::new(q.map(|q| l * q), v.map(|v| m * l / t * v), m * l * l / t * s)
}

fn start_in(units: Units) -> ContactState<[f64; 3]> {
    at_angles(units, [1.0, 0.2], [0.3, 2.0], 0.5)
}

fn at_three() -> ContactState<[f64; 3]> {
    let (angles, rates) =
        ([0.530_691_021_707_529_6, 10.507_848_828_204_8], [0.814_352_688_140_840_7, 2.247_605_341_383_539_4]);
    at_angles(SI, angles, rates, 19.940_518_469_948_386)
}

/// Errors of q, p and s.
fn apart<const N: usize>(a: &ContactState<[f64; N]>, b: &ContactState<[f64; N]>) -> [f64; 3] {
    let largest = |a: [f64; N], b: [f64; N]| (0..N).fold(0.0, |far, i| f64::max(far, (a[i] - b[i]).abs()));
    [largest(a.q, b.q), largest(a.p, b.p), (a.s - b.s).abs()]
}

fn momentum(ContactState { q, p, .. }: &ContactState<[f64; 3]>) -> f64 {
    q[0] * p[1] - q[1] * p[0]
}

/// Largest defects of the length of the rod and of its rate.
fn departures(units: Units, ContactState { q, p, .. }: &ContactState<[f64; 3]>) -> [f64; 2] {
    let [square, rate] = [q, p].map(|x| (0..3).map(|i| q[i] * x[i]).sum::<f64>());
    [(square / (units.l * units.l) - 1.0).abs(), (rate * units.t / (units.m * units.l * units.l)).abs()]
}

/// Runs a test for every method.
macro_rules! every {
    ($visit:ident) => {
        $visit!(ContactSplitting, ContactLeapfrog, ContactDiscreteGradient);
        $visit!(Suzuki4.of(ContactSplitting), Suzuki4.of(ContactLeapfrog), Suzuki4.of(ContactDiscreteGradient));
    };
}

#[test]
fn errors_are_those_of_the_reference() {
    macro_rules! has {
        ($($method:expr => $order:literal, $errors:expr;)*) => { $(
            let errors = [0.02, 0.01, 0.005].map(|h| {
                let mut sim = slowed_in(SI, 0.3).integrator($method, h, start_in(SI));
                sim.advance((3.0 / h).round() as u64).expect("steps");
                apart(&sim.state(), &at_three())
            });
            for (k, expected) in $errors.into_iter().enumerate() {
                let all = errors.map(|error| error[k]);
                assert!(orders(&all).iter().all(|order| (order - $order).abs() < 0.15), "{all:?}");
                assert!((all[0] / expected - 1.0).abs() < 0.02, "{all:?}");
            }
        )* };
    }
    // Errors of the largest coordinates, and of s, at h = 0.02.
    has! {
        ContactSplitting => 2.0, [1.11e-3, 5.02e-3, 2.57e-5];
        ContactLeapfrog => 2.0, [1.11e-3, 5.02e-3, 8.83e-5];
        ContactDiscreteGradient => 2.0, [1.16e-3, 6.25e-3, 8.45e-3];
    }
    // Compositions, whose errors have no reference.
    macro_rules! composed {
        ($($method:expr => $order:literal;)*) => { $(
            let errors = [0.02, 0.01].map(|h| {
                let mut sim = slowed_in(SI, 0.3).integrator($method, h, start_in(SI));
                sim.advance((3.0 / h).round() as u64).expect("steps");
                apart(&sim.state(), &at_three())
            });
            for k in [0, 1, 2] {
                let order = orders(&errors.map(|error| error[k]))[0];
                assert!((order - $order).abs() < 0.2, "{errors:?}");
            }
        )* };
    }
    composed! {
        Suzuki4.of(ContactSplitting) => 4.0;
        Suzuki4.of(ContactLeapfrog) => 4.0;
        Suzuki4.of(ContactDiscreteGradient) => 4.0;
        Yoshida6a.of(ContactSplitting) => 6.0;
    }
}

/// The momentum about the vertical decays as the contact form, and H as in the flow. Constraint and rate hold to rounding, also after 10⁵ steps and
/// in other units.
#[test]
fn laws_hold_to_rounding() -> Result<(), StepError> {
    for units in [SI, OTHERS] {
        // Slow friction: the amplitude is above zero to the end.
        let (h, gamma) = (0.01, 1e-3);
        let (system, start) = (slowed_in(units, gamma), start_in(units));
        let step = h * units.t;
        let decayed = |steps: f64, factor: f64| (steps * factor.ln()).exp();
        let mut splitting = system.integrator(ContactSplitting, step, start);
        let mut leapfrog = system.integrator(ContactLeapfrog, step, start);
        let mut gradient = system.integrator(ContactDiscreteGradient, step, start);
        let energy = gradient.energy();
        for steps in [1_000, 10_000, 89_000] {
            splitting.advance(steps)?;
            leapfrog.advance(steps)?;
            gradient.advance(steps)?;
            let done = splitting.steps() as f64;
            // One rounding each step.
            let rounding = 1e-13 + 5e-17 * done;
            let kept = |momentum: f64, factor| (momentum / self::momentum(&start) / decayed(done, factor) - 1.0).abs();
            let cayley = (1.0 - h * gamma / 2.0) / (1.0 + h * gamma / 2.0);
            assert!(kept(momentum(&splitting.state()), (-h * gamma).exp()) < rounding);
            assert!(kept(momentum(&leapfrog.state()), cayley) < rounding);
            let law = gradient.energy() / energy / decayed(done, (-h * gamma).exp()) - 1.0;
            assert!(law.abs() < rounding, "{law:e}");
            for state in [splitting.state(), leapfrog.state(), gradient.state()] {
                let [length, rate] = departures(units, &state);
                assert!(length < 1e-15 && rate < 1e-14, "{length:e} {rate:e}");
            }
        }
        // Control: no other law holds.
        assert!((splitting.energy() / energy / (-1.0_f64).exp() - 1.0).abs() > 1e-8);
    }
    Ok(())
}

/// Units by powers of two change no digit, and many steps are as single ones.
#[test]
fn units_and_calls_change_nothing() -> Result<(), StepError> {
    macro_rules! same {
        ($($method:expr),*) => { $(
            let mut many = slowed_in(SI, 0.3).integrator($method, 0.02, start_in(SI));
            let mut single = slowed_in(OTHERS, 0.3).integrator($method, 0.02 * OTHERS.t, start_in(OTHERS));
            many.advance(500)?;
            for _ in 0..500 {
                single.step()?;
            }
            let Units { l, m, t } = OTHERS;
            let ContactState { q, p, s, .. } = many.state();
            let expected = (q.map(|q| l * q), p.map(|p| m * l / t * p), m * l * l / t * s);
            assert_eq!((single.state().q, single.state().p, single.state().s), expected);
        )* };
    }
    every!(same);
    Ok(())
}

#[test]
fn there_and_back() -> Result<(), StepError> {
    macro_rules! back {
        ($($method:expr),*) => { $(
            let mut sim = slowed_in(SI, 0.3).integrator($method, 0.02, start_in(SI));
            sim.advance(100)?;
            sim.set_step_size(-0.02);
            sim.advance(100)?;
            let errors = apart(&sim.state(), &start_in(SI));
            assert!(errors.iter().all(|error| *error < 1e-12), "{errors:?}");
        )* };
    }
    every!(back);
    Ok(())
}

/// Steps multiply ds − p·dq along the constraint by one number.
#[test]
fn the_contact_form_has_one_factor() {
    fn factor<P: Scene, M: Method<P::Over<Dual>, Dual>>(method: M, h: f64) -> f64 {
        let (t, x) = P::start();
        let last = x.len() - 1;
        let mut x: Vec<Dual> = x.into_iter().map(Dual::from).collect();
        x[last] = Dual::variable(x[last].value());
        let mut sim = Bare::<P, M, Dual>::new(method, h.into(), t.into(), &x);
        sim.advance(1).expect("a step");
        sim.state()[last].derivative()
    }
    // γ of the ellipse, and the time at its start.
    let (gamma, h, start) = (|t: f64| 0.3 + 0.2 * t.sin(), 0.375, 0.4);
    let middle: f64 = (-h * gamma(start + h / 2.0)).exp();
    let trapezoidal = (1.0 - h * gamma(start) / 2.0) / (1.0 + h * gamma(start + h) / 2.0);
    let constant: f64 = (-0.35 * h).exp();
    let cayley = (1.0 - 0.35 * h / 2.0) / (1.0 + 0.35 * h / 2.0);
    for (found, expected) in [
        (factor::<DampedSpheres, _>(ContactSplitting, h), constant),
        (factor::<DampedSpheres, _>(ContactLeapfrog, h), cayley),
        (factor::<DampedEllipses, _>(ContactSplitting, h), middle),
        (factor::<DampedEllipses, _>(ContactLeapfrog, h), trapezoidal),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
    }
    for defect in [
        form_defect::<DampedSpheres, _>(ContactSplitting, h, 1),
        form_defect::<DampedSpheres, _>(ContactLeapfrog, h, 1),
        form_defect::<DampedEllipses, _>(ContactSplitting, h, 1),
        form_defect::<DampedEllipses, _>(ContactLeapfrog, h, 1),
        form_defect::<DampedSpheres, _>(Suzuki4.of(ContactSplitting), h, 1),
    ] {
        let defect = defect.expect("a step");
        assert!(defect < 1e-12, "{defect:e}");
    }
    // Control: the discrete gradient is no contact map.
    assert!(form_defect::<DampedSpheres, _>(ContactDiscreteGradient, h, 1).expect("a step") > 1e-3);
}

/// A pendulum in a medium whose density changes. Its pivot is at the height 0.1 cos 5t.
#[lagrangian(constraint = [(q[0] * q[0] + (q[1] - 0.1 * (5.0 * t).cos()).powi(2) - l * l) / 2.0])]
fn shaken(q: [f64; 2], v: [f64; 2], s: f64, t: f64, m: f64, l: f64, g: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 - m * g * q[1] - (0.4 + 0.3 * (2.0 * t).sin()) * s
}

/// The same by the angle from below.
#[lagrangian]
fn shaken_angle(q: f64, v: f64, s: f64, t: f64, m: f64, l: f64, g: f64) -> f64 {
    let (height, speed) = (0.1 * (5.0 * t).cos(), -0.5 * (5.0 * t).sin());
    let square = l * l * v * v + 2.0 * l * v * speed * q.sin() + speed * speed;
    m * square / 2.0 - m * g * (height - l * q.cos()) - (0.4 + 0.3 * (2.0 * t).sin()) * s
}

#[test]
fn a_pivot_that_moves() -> Result<(), StepError> {
    let (m, l, g) = (0.7, 1.3, 9.81);
    let (system, by_angle) = (Shaken { m, l, g }, ShakenAngle { m, l, g });
    let place = |t: f64, angle: f64, rate: f64, s: f64| {
        let (sin, cos) = angle.sin_cos();
        let (height, speed) = (0.1 * (5.0 * t).cos(), -0.5 * (5.0 * t).sin());
        system.at_time(t, [l * sin, height - l * cos], [l * rate * cos, speed + l * rate * sin], s)
    };
    let mut exact = by_angle.integrator(ContactGauss::<6>, 0.01, by_angle.at(2.0, 0.4, 0.3));
    exact.advance(200)?;
    let ContactState { t, q: angle, s, .. } = exact.state();
    let end = place(t, angle, by_angle.velocity(&exact.state()), s);
    let start = place(0.0, 2.0, 0.4, 0.3);
    macro_rules! second {
        ($($method:expr => $order:literal),*) => { $(
            let mut errors = vec![];
            for h in [0.02, 0.01, 0.005] {
                let mut sim = system.integrator($method, h, start);
                for _ in 0..(2.0 / h).round() as u64 {
                    sim.step()?;
                    let ContactState { t, q, p, .. } = sim.state();
                    let (y, speed) = (q[1] - 0.1 * (5.0 * t).cos(), p[1] / m + 0.5 * (5.0 * t).sin());
                    assert!((q[0].hypot(y) - l).abs() < 1e-15 && (q[0] * p[0] / m + y * speed).abs() < 1e-14);
                }
                errors.push(apart(&sim.state(), &end));
            }
            for k in [0, 1, 2] {
                let all: Vec<f64> = errors.iter().map(|error| error[k]).collect();
                assert!(orders(&all).iter().all(|order| (order - $order).abs() < 0.15), "{all:?}");
            }
        )* };
    }
    second!(ContactSplitting => 2.0, ContactLeapfrog => 2.0, ContactDiscreteGradient => 2.0);
    second!(Suzuki4.of(ContactSplitting) => 4.0, Suzuki4.of(ContactLeapfrog) => 4.0);
    Ok(())
}

/// A fast mass on a circle: T is not quadratic.
#[contact_hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1]).sqrt() - l])]
fn fast(q: [f64; 2], p: [f64; 2], s: f64, m: f64, c: f64, l: f64, g: f64, gamma: f64) -> f64 {
    c * (m * m * c * c + p[0] * p[0] + p[1] * p[1]).sqrt() + m * g * q[1] + gamma * s
}

/// The same by the angle from below.
#[contact_hamiltonian]
fn fast_angle(q: f64, p: f64, s: f64, m: f64, c: f64, l: f64, g: f64, gamma: f64) -> f64 {
    c * (m * m * c * c + p * p / (l * l)).sqrt() - m * g * l * q.cos() + gamma * s
}

#[test]
fn energies_that_are_not_quadratic() -> Result<(), StepError> {
    let (m, c, l, g, gamma) = (0.7, 3.0, 1.3, 9.81, -0.2);
    let (system, free) = (Fast { m, c, l, g, gamma }, FastAngle { m, c, l, g, gamma });
    let place = |angle: f64, p: f64, s: f64| {
        let (sin, cos) = angle.sin_cos();
        ContactState::new([l * sin, -l * cos], [p / l * cos, p / l * sin], s)
    };
    let mut exact = free.integrator(ContactGauss::<6>, 0.01, ContactState::new(0.5, 0.8, -0.4));
    exact.advance(100)?;
    let ContactState { q, p, s, .. } = exact.state();
    let (start, end) = (place(0.5, 0.8, -0.4), place(q, p, s));
    macro_rules! second {
        ($($method:expr),*) => { $(
            let errors: Vec<[f64; 3]> = [0.02, 0.01].iter().map(|h| {
                let mut sim = system.integrator($method, *h, start);
                sim.advance((1.0 / h).round() as u64).expect("steps");
                apart(&sim.state_on_constraint().expect("a state"), &end)
            }).collect();
            for k in [0, 1, 2] {
                let order = (errors[0][k] / errors[1][k]).log2();
                assert!((order - 2.0).abs() < 0.1, "{errors:?}");
            }
        )* };
    }
    second!(ContactSplitting, ContactLeapfrog, ContactDiscreteGradient);
    let mut sim = system.integrator(ContactDiscreteGradient, 0.05, start);
    let energy = sim.energy();
    sim.advance(200)?;
    assert!((sim.energy() / (energy * 2.0_f64.exp()) - 1.0).abs() < 1e-13);
    Ok(())
}

/// One precision less.
#[contact_hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] - l * l) / 2.0])]
fn rough(q: [f32; 2], p: [f32; 2], s: f32, m: f32, l: f32, g: f32, gamma: f32) -> f32 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1] + gamma * s
}

#[test]
fn single_precision() -> Result<(), StepError> {
    let system = Rough { m: 0.6, l: 1.5, g: 9.81, gamma: 0.2 };
    let start = ContactState::new([0.9, -1.2], [0.4, 0.3], 0.0);
    macro_rules! holds {
        ($($method:expr),*) => { $(
            let mut sim = system.integrator($method, 0.01, start);
            sim.advance(3000)?;
            let ContactState { q, p, .. } = sim.state();
            assert!((q[0].hypot(q[1]) - 1.5).abs() < 5e-7 && (q[0] * p[0] + q[1] * p[1]).abs() < 2e-6);
        )* };
    }
    holds!(ContactSplitting, ContactLeapfrog, ContactDiscreteGradient);
    Ok(())
}

/// Leapfrog stops where its factor would not be positive, the others do not. γ may be negative, and steps far too long are refused or keep their laws.
#[test]
fn friction_that_is_strong_or_negative() -> Result<(), StepError> {
    let strong = slowed_in(SI, 30.0);
    let mut leapfrog = strong.integrator(ContactLeapfrog, 0.1, start_in(SI));
    assert!(leapfrog.step().is_err());
    assert_eq!(leapfrog.state(), start_in(SI));
    let mut splitting = strong.integrator(ContactSplitting, 0.1, start_in(SI));
    splitting.advance(10)?;
    assert!((momentum(&splitting.state()) - momentum(&start_in(SI)) * (-30.0_f64).exp()).abs() < 1e-15);

    let driven = slowed_in(SI, -0.1);
    let mut sim = driven.integrator(ContactDiscreteGradient, 0.02, start_in(SI));
    let energy = sim.energy();
    sim.advance(100)?;
    assert!((sim.energy() / energy / 0.2_f64.exp() - 1.0).abs() < 1e-13);
    // Back in time through strong friction there is no step that is continuous in h, beyond hγ = −2.
    for (h, steps) in [(-0.06, true), (-0.07, false)] {
        assert_eq!(strong.integrator(ContactDiscreteGradient, h, start_in(SI)).step().is_ok(), steps, "{h}");
    }
    for gamma in [-3.0, 0.0, 0.3, 30.0] {
        for h in [0.3, 1.0, 10.0, -1.0] {
            let system = slowed_in(SI, gamma);
            let mut sim = system.integrator(ContactDiscreteGradient, h, start_in(SI));
            let (energy, before) = (sim.energy(), sim.state());
            match sim.step() {
                Ok(()) => {
                    let size = energy.abs() + system.energy(&sim.state()).abs();
                    assert!((sim.energy() - energy * (-h * gamma).exp()).abs() < 1e-10 * size, "{gamma} {h}");
                    let [length, _] = departures(SI, &sim.state());
                    // Increments of the longest steps are a hundred times as large as positions.
                    assert!(length < 2e-13, "{gamma} {h}: {length:e}");
                }
                Err(_) => assert_eq!(sim.state(), before),
            }
        }
    }
    Ok(())
}

/// λ balances what the rod carries: weight along the rod, and the centripetal force. Friction is across the rod.
#[test]
fn the_tension_of_the_rod() -> Result<(), StepError> {
    let (m, l, g) = (0.7, 1.3, 9.81);
    let units = Units { l, m, t: 1.0 };
    let system = Slowed { m, l, g, gamma: 0.3 };
    let mut sim = system.integrator(ContactSplitting, 0.01, at_angles(units, [1.0, 0.2], [0.3, 2.0], 0.5));
    sim.advance(120)?;
    let (ContactState { q, p, .. }, [tension]) = (sim.state(), sim.multipliers());
    let square = p.iter().map(|p| p * p).sum::<f64>() / m;
    assert!((tension * l * l - square + m * g * q[2]).abs() < 1e-13);
    assert_eq!(system.multipliers(&sim.state()), [tension]);
    Ok(())
}

#[test]
fn a_start_off_the_constraint() -> Result<(), StepError> {
    let (system, start) = (slowed_in(SI, 0.3), start_in(SI));
    let longer = ContactState { q: [start.q[0] + 1e-9, start.q[1], start.q[2]], ..start };
    macro_rules! refuses {
        ($($method:expr),*) => { $(
            let mut sim = system.integrator($method, 0.01, longer);
            let what = "(q[0]² + q[1]² + q[2]² - l²)/2";
            assert_eq!(sim.step(), Err(StepError::new(Failure::OffConstraint { what }, 0.0, 0.01)));
            assert_eq!(sim.state(), longer);
        )* };
    }
    every!(refuses);
    let near = system.state_on_constraint(&longer)?;
    assert!(system.state_on_constraint(&ContactState { s: f64::NAN, ..start }).is_err());
    assert!(near.s == longer.s && apart(&near, &start)[0] < 2e-9);
    system.integrator(ContactSplitting, 0.01, near).step()?;
    Ok(())
}

/// A bead on a wire at which its constraint loses its gradient.
#[contact_hamiltonian(constraint = [q[0] * q[1]])]
fn crossing(q: [f64; 2], p: [f64; 2], s: f64, gamma: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + gamma * s
}

#[test]
fn a_crossing_of_wires_is_refused() -> Result<(), StepError> {
    let start = ContactState::new([-0.505, 0.0], [1.0, 0.0], 0.0);
    macro_rules! refuses {
        ($($method:expr),*) => { $(
            let mut sim = Crossing { gamma: 0.1 }.integrator($method, 0.1, start);
            let error = sim.advance(20).expect_err("no way on");
            let (dependent, unsolved) = (matches!(error.failure, Failure::DependentConstraints { .. }), error.to_string());
            assert!(dependent || unsolved.contains("no solution"), "{error}");
            assert!(sim.state().q[0] < 0.0);
        )* };
    }
    every!(refuses);
    Ok(())
}

#[test]
fn reports() {
    let report = Slowed::<f64>::REPORT;
    for line in [
        "Constraints: p' = −∂H/∂q − p ∂H/∂s − Gᵀλ with G = ∂g/∂q",
        "Decaying by the factor e^(−(gamma)·t), all alike, so that quotients are constant",
        "- H: it does not read time",
        "In a step of a contact map (`ContactSplitting`, `ContactLeapfrog`) momenta are multiplied by one number, to rounding",
        "- all may be composed: `Suzuki4.of(ContactSplitting)`",
    ] {
        assert!(report.contains(line), "{line}\n{report}");
    }
    let report = Shaken::<f64>::REPORT;
    assert!(report.contains("this constraint does work") && !report.contains("H: it does not read time"), "{report}");
}
