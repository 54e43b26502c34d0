//! Invalid input: the first step returns an error, and the state is kept.

use geoint_runtime::Failure;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::TaylorMethod;

/// ln q: the force is not defined for q ≤ 0.
#[hamiltonian]
fn logarithm(q: f64, p: f64) -> f64 {
    p * p / 2.0 + 0.1 * q + q * q.ln()
}

/// A refused attempt overwrites the series, so no state within a last step is available.
#[test]
fn a_refused_step_shows_nothing() {
    let mut sim = Logarithm.taylor(TaylorFixed::<8> { h: 0.05 }, State::new(1.0, 0.0));
    let mut before = None;
    let refused = loop {
        if let Err(error) = sim.step() {
            break error;
        }
        before = sim.at(sim.time() - 0.025).ok();
    };
    assert!(matches!(refused, StepError { failure: Failure::OutsideDomain { .. }, .. }), "{refused}");
    assert!(before.is_some_and(|state| state.q > 0.0 && state.p < 0.0));
    let t = sim.time();
    let unknown = Failure::NotInLastStep { from: t, to: t };
    assert!(matches!(sim.at(t - 0.025), Err(StepError { failure, .. }) if failure == unknown));
    assert!(sim.state().q > 0.0);
}

fn first_error<M: TaylorMethod<Logarithm>>(method: M, state: State<f64>) -> StepError {
    let mut sim = Logarithm.taylor(method, state);
    let error = sim.step().unwrap_err();
    assert!(sim.steps() == 0 && sim.time() == state.t || state.t.is_nan());
    error
}

#[test]
fn bad_input_is_refused() {
    let good = State::new(1.0, 0.0);
    for tolerance in [0.0, -1e-9, f64::NAN, f64::INFINITY] {
        let error = first_error(Taylor { tolerance }, good);
        assert!(matches!(error, StepError { failure: Failure::InvalidTolerance { .. }, .. }), "{error}");
        let error = first_error(TaylorOrder::<8> { tolerance }, good);
        assert!(matches!(error, StepError { failure: Failure::InvalidTolerance { .. }, .. }), "{error}");
    }
    for h in [0.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            first_error(TaylorFixed::<8> { h }, good),
            StepError { failure: Failure::InvalidStepSize { .. }, .. }
        ));
    }
    assert_eq!(first_error(TaylorOrder::<0> { tolerance: 1e-9 }, good).failure, Failure::InvalidOrder { order: 0 });
    assert_eq!(first_error(TaylorFixed::<1> { h: 0.1 }, good).failure, Failure::InvalidOrder { order: 1 });
    for state in [State::new(f64::NAN, 0.0), State::new(1.0, f64::INFINITY), State::at(f64::NAN, 1.0, 0.0)] {
        assert!(matches!(first_error(Taylor::default(), state), StepError { failure: Failure::NonFiniteState, .. }));
    }
    for q in [0.0, -1.0] {
        let error = first_error(Taylor::default(), State::new(q, 0.0));
        assert!(matches!(error, StepError { failure: Failure::OutsideDomain { .. }, .. }), "{error}");
    }
    let mut sim = Logarithm.taylor(Taylor::default(), good);
    assert!(matches!(sim.advance_to(f64::NAN), Err(StepError { failure: Failure::InvalidStepSize { .. }, .. })));
    assert!(matches!(sim.advance_to(f64::INFINITY), Err(StepError { failure: Failure::InvalidStepSize { .. }, .. })));
    let mut sim = Logarithm.taylor(Taylor::default(), good).steps_at_most(2);
    assert!(matches!(sim.advance_to(100.0), Err(StepError { failure: Failure::TooManySteps { steps: 2 }, .. })));
    let mut sim = Logarithm.taylor(Taylor::default(), good).steps_between(1.0, 0.5);
    assert_eq!(sim.step().unwrap_err().failure, Failure::InvalidBounds { shortest: 1.0, longest: 0.5 });
}

/// A shortest step set by the user is not reported as a pole of the solution.
#[test]
fn steps_that_are_not_short_enough() {
    #[hamiltonian]
    fn oscillator(q: f64, p: f64) -> f64 {
        (p * p + q * q) / 2.0
    }
    let mut sim = Oscillator.taylor(Taylor::default(), State::new(1.0, 0.0)).steps_between(3.0, 4.0);
    let error = sim.step().unwrap_err();
    assert!(matches!(error, StepError { failure: Failure::Inaccurate { error }, .. } if error > 10.0), "{error}");
    assert!(error.to_string().contains("times what is tolerated"), "{error}");
}

/// A parameter that is not a number has its name in the message. An infinite one leaves the solution without a series, which does not diverge.
#[test]
fn parameters_that_are_no_numbers() {
    let start = State::new([1.0, 0.0], [0.0, 1.0]);
    for m in [f64::NAN, f64::INFINITY] {
        let system = Weighed { m };
        let errors = [
            system.taylor(Taylor::default(), start).step(),
            system.taylor(TaylorFixed::<8> { h: 0.1 }, start).step(),
            system.taylor(Projection(Taylor::default(), Energy), start).step(),
        ];
        for error in errors.map(Result::unwrap_err) {
            if m.is_nan() {
                assert_eq!(error.failure, Failure::InvalidParameter { name: "m" });
                continue;
            }
            assert!(matches!(error, StepError { failure: Failure::NoRates, t: 0.0, .. }), "{m}: {error}");
            assert!(error.to_string().contains("the rates of the state there are not finite"), "{error}");
        }
    }
}

#[hamiltonian]
fn weighed(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - m / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// An invalid distance of samples is refused with its value, and no step is taken.
#[test]
fn distances_that_are_none() {
    for dt in [0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        every_run!(Logarithm, State::new(1.0, 0.0), 0.1, |sim| {
            let error = sim.sampled_every(dt).next().expect("an answer").unwrap_err();
            assert!(
                matches!(error, StepError { failure: Failure::InvalidStepSize { h }, .. } if h.to_bits() == dt.to_bits()),
                "{dt}: {error}"
            );
            assert_eq!(sim.state(), State::new(1.0, 0.0));
        });
    }
}
