//! Poles in time alone, and times at which the energy is not defined. No step crosses such a time, whatever the method evaluates. The result does not
//! depend on the number of steps in a call.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Failure, Method};

/// Infinite at t = c, where only the time is read.
#[hamiltonian]
fn stiffening(q: f64, p: f64, t: f64, c: f64) -> f64 {
    p * p / 2.0 + q * q / (c - t)
}

/// The same in a kinetic energy, at every zero of a sine.
#[hamiltonian]
fn lightening(q: f64, p: f64, t: f64, c: f64) -> f64 {
    p * p / (2.0 * (c * t).sin()) + q * q / 2.0
}

#[vector_field]
fn driven(x: [f64; 2], t: f64, c: f64) -> [f64; 2] {
    [x[1], -x[0] + 1.0 / ((t - c) * (t - c))]
}

/// Not defined for a hundredth of a unit of time from t = c on.
#[hamiltonian]
fn interrupted(q: f64, p: f64, t: f64, c: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 * ((t - c) * (t - c - 0.01)).sqrt()
}

#[contact_hamiltonian]
fn interrupted_friction(q: f64, p: f64, s: f64, t: f64, c: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + 0.1 * s * ((t - c) * (t - c - 0.01)).powf(1.5)
}

/// Takes steps of length h from `t`, with 1, 7 or 400 steps in a call. The run must end in front of the pole, at the same step for each call length.
fn stops<S, M, X>(name: &str, system: S, method: M, [t, h, pole]: [f64; 3], start: X)
where
    S: PhaseSpace<State = X>,
    M: Method<S, f64>,
    X: Copy + std::fmt::Debug + PartialEq,
{
    let mut ends = vec![];
    for at_once in [1, 7, 400] {
        let mut sim = Integrator::new(system, method, h, start);
        let error = (0..5000).find_map(|_| sim.advance(at_once).err()).unwrap_or_else(|| panic!("{name}, {h}: no end"));
        let context = format!("{name} from {t} by {h}: {error} after {} steps", sim.steps());
        // The error of a piece whose flow meets the pole names the piece.
        assert!(
            matches!(error, StepError { failure: Failure::OutsideDomain { .. } | Failure::Pole { .. }, .. }),
            "{context}"
        );
        let left = (pole - sim.time()) / h;
        assert!((0.0..=1.0 + 1e-9).contains(&left), "{context}");
        ends.push(sim.steps());
    }
    assert!(ends.iter().all(|end| *end == ends[0]), "{name}: {ends:?}");
}

macro_rules! stop {
    ($system:expr, $pole:expr, $state:expr, $($method:expr),*) => { $(
        for h in [0.0731, 0.31, 0.001, -0.0731, -0.31, -0.001] {
            // The run starts before the pole in its direction.
            let t: f64 = $pole - 7.3_f64.copysign(h) * 0.1;
            stops(stringify!($method), $system, $method, [t, h, $pole], $state(t));
        }
    )* };
}

#[test]
fn no_step_leads_over_a_pole_in_time() {
    let state = |t: f64| State::at(t, 1e-3, 1e-3);
    stop!(Stiffening { c: 1.7 }, 1.7, state, StormerVerlet, BlanesMoan4, RK4, DOP853, ImplicitMidpoint);
    stop!(Lightening { c: 2.0 }, std::f64::consts::PI, state, StormerVerlet, RK4, DOP853);
    stop!(Driven { c: 1.7 }, 1.7, |t: f64| FlowState::at(t, [0.0; 2]), RK4, DOP853);
}

/// A run backwards in time meets the other end of the gap.
#[test]
fn nor_over_a_time_without_an_energy() {
    macro_rules! stop {
        ($system:expr, $state:expr, $($method:expr),*) => { $(
            for h in [0.0731, 0.31, 0.013] {
                stops(stringify!($method), $system, $method, [0.97, h, 1.7], $state(0.97));
                stops(stringify!($method), $system, $method, [2.44, -h, 1.71], $state(2.44));
            }
        )* };
    }
    let state = |t: f64| State::at(t, 0.3, 0.1);
    stop!(Interrupted { c: 1.7 }, state, StormerVerlet, BlanesMoan4, BlanesMoanSrkn14a, RK4, DOP853, ImplicitMidpoint);
    stop!(Interrupted { c: 1.7 }, state, DiscreteGradient, Gauss::<2>);
    let state = |t: f64| ContactState::at(t, 0.3, 0.1, 0.0);
    stop!(InterruptedFriction { c: 1.7 }, state, ContactSplitting, RK4, DOP853, ContactMidpoint);
    for h in [0.0731, 0.31] {
        let mut sim = Interrupted { c: 1.7 }.taylor(TaylorFixed::<8> { h }, State::at(0.97, 0.3, 0.1));
        let error = sim.advance(100).unwrap_err();
        assert!((0.0..=1.0 + 1e-9).contains(&((1.7 - sim.time()) / h)), "{h}: {error}, {}", sim.time());
    }
    let mut sim = Interrupted { c: 1.7 }.adaptive(DOP853, 0.5, State::at(0.97, 0.3, 0.1));
    let error = sim.advance_to(3.0).unwrap_err();
    assert!(matches!(error, StepError { failure: Failure::OutsideDomain { .. }, .. }), "{error}");
    // The radicand touches zero, and the energy is defined at all times.
    #[hamiltonian]
    fn touched(q: f64, p: f64, t: f64, c: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0 * (1.0 - (c * t).cos()).sqrt()
    }
    for h in [0.0731, 0.31] {
        Touched { c: 1.7 }.integrator(StormerVerlet, h, State::at(0.97, 0.3, 0.1)).advance(1000).unwrap();
    }
}

#[test]
fn nor_one_of_a_taylor_series() {
    for h in [0.0731, 0.31, -0.31] {
        let t = 1.7 - 0.73_f64.copysign(h);
        let mut sim = Stiffening { c: 1.7 }.taylor(TaylorFixed::<8> { h }, State::at(t, 1e-3, 1e-3));
        let error = sim.advance(100).unwrap_err();
        assert!((0.0..=1.0 + 1e-9).contains(&((1.7 - sim.time()) / h)), "{h}: {error}, {}", sim.time());
        let mut sim = Driven { c: 1.7 }.taylor(TaylorFixed::<8> { h }, FlowState::at(t, [0.0; 2]));
        let error = sim.advance(100).unwrap_err();
        assert!((0.0..=1.0 + 1e-9).contains(&((1.7 - sim.time()) / h)), "{h}: {error}, {}", sim.time());
    }
}

#[test]
fn nor_one_of_a_length_of_its_own() {
    macro_rules! check {
        ($system:expr, $state:expr, $($method:expr),*) => { $(
            for tolerance in [1e-9, 1e-3, 0.5] {
                let mut sim = $system.adaptive($method, tolerance, $state);
                let error = sim.advance_to(3.0).unwrap_err();
                assert!(sim.time() < 1.7, "{}, {tolerance}: {error}", stringify!($method));
                assert!(error.is_shortest(), "{}: {error}", stringify!($method));
                let mut sim = $system.adaptive($method, tolerance, $state).steps_between(0.1, 0.5);
                let error = sim.advance_to(3.0).unwrap_err();
                assert!(sim.time() < 1.7, "{}, {tolerance}: {error}", stringify!($method));
                assert!(error.is_shortest(), "{}: {error}", stringify!($method));
                assert!(!matches!(error.failure, Failure::Inaccurate { error } if error <= 1.0), "{error}");
            }
        )* };
    }
    check!(Stiffening { c: 1.7 }, State::new(1e-3, 1e-3), StormerVerlet, BlanesMoan4, RK4, DOP853, ImplicitMidpoint);
    check!(Driven { c: 1.7 }, FlowState::new([0.0; 2]), RK4, DOP853);
}

/// Steps near a complex pole are accepted, even if the check of a stretch of twice their length can not exclude a pole.
#[test]
fn steps_go_on_where_there_is_no_pole() {
    #[hamiltonian]
    fn near(q: f64, p: f64, t: f64, gap: f64) -> f64 {
        p * p / 2.0 + q * q / ((t - 1.0) * (t - 1.0) + gap)
    }
    for h in [1e-3, 0.013, 0.4] {
        let mut sim = Near { gap: 1e-6 }.integrator(StormerVerlet, h, State::new(1e-3, 1e-3));
        let steps = (3.0 / h) as u64;
        sim.advance(steps).unwrap();
        assert_eq!(sim.steps(), steps);
        let mut sim = Near { gap: 1e-6 }.integrator(StormerVerlet, h, State::new(1e-3, 1e-3));
        (0..steps).for_each(|_| sim.step().unwrap());
    }
}

/// A run turns round and returns to the pole. A time after which no pole follows may have a pole before it.
#[test]
fn back_to_the_pole() {
    let mut sim = Stiffening { c: 1.7 }.integrator(StormerVerlet, 0.01, State::at(1.71, 1e-3, 1e-3));
    sim.advance(50).unwrap();
    sim.set_step_size(-0.01);
    let error = sim.advance(100).unwrap_err();
    assert!(matches!(error, StepError { failure: Failure::OutsideDomain { .. }, .. }) && sim.time() > 1.7, "{error}");

    #[contact_hamiltonian]
    fn lane_emden(q: f64, p: f64, s: f64, t: f64) -> f64 {
        p * p * 0.75 + q.cos() + 2.0 / t * s
    }
    let mut sim = LaneEmden.integrator(ContactSplitting, 0.125, ContactState::at(0.0, 0.3, 0.0, 0.0));
    sim.advance(4).unwrap();
    sim.set_step_size(-0.125);
    sim.advance(3).unwrap();
    let error = sim.step().unwrap_err();
    assert!(
        matches!(error, StepError { failure: Failure::OutsideDomain { .. } | Failure::Pole { .. }, .. }),
        "{error}"
    );
    assert_eq!(sim.time(), 0.125);
}

/// Single precision, with a unit of time in which products of two times underflow to zero.
#[test]
fn in_any_unit() {
    #[hamiltonian]
    fn single(q: f32, p: f32, t: f32, c: f32) -> f32 {
        p * p / 2.0 + q * q / (c - t)
    }
    for unit in [1e-27_f32, 1.0, 1e15] {
        for h in [0.07 * unit, 0.0013 * unit] {
            let mut sim = Single { c: 1.7 * unit }.integrator(StormerVerlet, h, State::at(0.9 * unit, 0.0, 0.0));
            let error = (0..1000).find_map(|_| sim.step().err()).unwrap_or_else(|| panic!("{unit}, {h}: no end"));
            let left = (1.7 * unit - sim.time()) / h;
            assert!(matches!(error, StepError { failure: Failure::OutsideDomain { .. }, .. }), "{error}");
            assert!((0.0..=1.001).contains(&left), "{unit}, {h}: {left}, {error}");
        }
    }
}
