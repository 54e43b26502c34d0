//! Errors of runs have the time of the last good state, and the length of the step that was refused.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A particle that falls towards the wall q = 0, through a logarithm.
#[hamiltonian]
fn falling(q: f64, p: f64, k: f64) -> f64 {
    p * p / 2.0 - k * q.ln() + q
}

const SYSTEM: Falling = Falling { k: 0.05 };

fn start() -> State<f64> {
    State::new(2.0, -1.0)
}

/// The error of a fixed step is the sentence of its failure.
#[test]
fn a_fixed_step_in_the_middle_of_a_run() {
    for (h, p) in [(0.31, -1.0), (-0.31, 1.0)] {
        let mut sim = SYSTEM.integrator(StormerVerlet, h, State::new(2.0, p));
        let error = sim.advance(1000).unwrap_err();
        assert!(sim.steps() > 2 && matches!(error.failure, Failure::OutsideDomain { .. }), "{error}");
        assert_eq!((error.t, error.h, error.time()), (sim.time(), h, Some(sim.time())));
        assert!(!error.is_shortest() && error.to_string().starts_with("the step from t = "), "{error}");
        assert_eq!(sim.step(), Err(error));
    }
}

/// The error of a run that has shortened its steps states the shortest length.
#[test]
fn the_shortest_step_of_an_adaptive_run() {
    for end in [10.0, -10.0] {
        let mut sim = SYSTEM.adaptive(DOP853, 1e-13, start()).steps_between(0.25, 1.0).first_step(1.0);
        let error = sim.advance_to(end).unwrap_err();
        let h = 0.25_f64.copysign(end);
        assert!(error.is_shortest() && matches!(error.failure, Failure::Inaccurate { .. }), "{error}");
        assert_eq!((error.t, error.h, error.time()), (sim.time(), h, Some(sim.time())));
        let expected = format!("from t = {} not even a step of {h:.1e} can be taken: {}", error.t, error.failure);
        assert_eq!(error.to_string(), expected);
    }
}

/// Series of an adaptive run are shortened, those of fixed length are not.
#[test]
fn steps_of_series() {
    let mut sim = SYSTEM.taylor(Taylor::default(), start()).steps_between(3.0, 4.0);
    let error = sim.step().unwrap_err();
    assert!(error.is_shortest() && error.t == 0.0 && error.h > 0.0, "{error:?}");
    // A force without a bound has no series.
    let mut sim = Falling { k: f64::INFINITY }.taylor(TaylorFixed::<8> { h: -0.1 }, start());
    let error = sim.step().unwrap_err();
    assert_eq!(error, StepError::new(Failure::NoRates, 0.0, -0.1));
    assert!(error.to_string().starts_with("from t = 0 no step of -1.0e-1 can be taken: "), "{error}");
}

/// Errors of settings have no time. Their length is that of the run, if it is known.
#[test]
fn settings() {
    let state = State::at(3.0, 2.0, -1.0);
    let errors = [
        (SYSTEM.integrator(RK4, 0.0, state).step(), 0.0),
        (SYSTEM.integrator(RK4, f64::INFINITY, state).step(), f64::INFINITY),
        (Falling { k: f64::NAN }.integrator(RK4, 0.1, state).step(), 0.1),
        (SYSTEM.adaptive(RK4, -1.0, state).first_step(0.5).step(), 0.5),
        (SYSTEM.adaptive(RK4, 1e-6, state).first_step(0.5).steps_between(2.0, 1.0).step(), 1.0),
        (SYSTEM.adaptive(RK4, 1e-6, state).first_step(0.0).step(), 0.0),
        (SYSTEM.taylor(TaylorOrder::<8> { tolerance: 2.0 }, state).step(), 0.0),
        (SYSTEM.taylor(TaylorFixed::<1> { h: 0.1 }, state).step(), 0.1),
    ];
    for (outcome, h) in errors {
        let error = outcome.unwrap_err();
        assert_eq!((error.time(), error.t, error.h, error.is_shortest()), (None, 3.0, h, false), "{error:?}");
    }
}

/// Requests and events have a time, and no length.
#[test]
fn requests() {
    let mut sim = SYSTEM.integrator(RK4, 0.1, start());
    sim.advance(5).unwrap();
    let passed = sim.sampled_at([0.25]).next().unwrap().unwrap_err();
    assert_eq!(passed, StepError::new(Failure::TimePassed, 0.25, 0.0));
    let mut sim = SYSTEM.adaptive(RK4, 1e-9, start()).steps_at_most(3);
    let late = sim.advance_to(1.5).unwrap_err();
    assert_eq!(late, StepError::new(Failure::TooManySteps { steps: 3 }, sim.time(), 0.0));
}
