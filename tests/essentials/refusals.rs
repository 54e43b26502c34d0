//! Every kind of run refuses a step that it can not take, and keeps the last good state. The control takes shorter steps, or another start, and
//! goes on.

use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Trajectory, hamiltonian};

/// A slope that ends at q = 0, where the energy is not defined any more.
#[hamiltonian]
fn slope(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.sqrt()
}

const SLOPE: Slope = Slope { m: 1.3 };

fn start() -> State<f64> {
    State::new(1.0, 0.2)
}

/// Steps to the end of the slope: the run stops there with an error, says so again, and holds a state from which the energy is defined.
fn stops_at_the_edge(mut run: impl Trajectory<State = State<f64>>) {
    let mut last = run.state();
    let error = loop {
        match run.step() {
            Ok(()) => last = run.state(),
            Err(error) => break error,
        }
        assert!(run.steps() < 100_000, "the run passed the edge: {last:?}");
    };
    assert!(!error.to_string().is_empty());
    assert_eq!(run.state(), last, "the last good state is kept");
    assert!(run.step().is_err(), "a refused step is refused again");
    assert!(last.q >= 0.0 && last.q < 1.0, "{last:?}");
}

#[test]
fn every_kind_of_run_stops_at_the_edge() {
    stops_at_the_edge(SLOPE.integrator(StormerVerlet, 0.07, start()));
    stops_at_the_edge(SLOPE.integrator(DiscreteGradient, 0.07, start()));
    stops_at_the_edge(SLOPE.integrator(Gauss::<2>, 0.07, start()));
    stops_at_the_edge(SLOPE.integrator(Projection(RK4, Energy), 0.07, start()));
    stops_at_the_edge(SLOPE.adaptive(DOP853, 1e-8, start()));
    stops_at_the_edge(SLOPE.taylor(Taylor::default(), start()));
    stops_at_the_edge(SLOPE.taylor(TaylorFixed::<8> { h: 0.07 }, start()));
    let by_name: Box<dyn Trajectory<State = State<f64>>> = Box::new(SLOPE.integrator(BlanesMoan4, 0.07, start()));
    stops_at_the_edge(by_name);
}

/// The control: before the edge every step is taken.
#[test]
fn runs_before_the_edge_go_on() {
    SLOPE.integrator(DiscreteGradient, 0.07, start()).advance(10).expect("the edge is far away");
    SLOPE.adaptive(DOP853, 1e-8, start()).advance_to(0.7).expect("the edge is far away");
    SLOPE.taylor(Taylor::default(), start()).advance_to(0.7).expect("the edge is far away");
}

#[test]
fn bad_input_is_refused() {
    for h in [0.0, f64::NAN, f64::INFINITY] {
        let mut run = SLOPE.integrator(StormerVerlet, h, start());
        assert!(matches!(run.step(), Err(StepError { failure: Failure::InvalidStepSize { .. }, .. })), "h = {h}");
        assert_eq!(run.state(), start());
        run.set_step_size(0.01);
        run.step().expect("a good step length is taken afterwards");
    }
    for bad in [State::new(f64::NAN, 0.0), State::new(1.0, f64::INFINITY)] {
        assert!(matches!(
            SLOPE.integrator(StormerVerlet, 0.1, bad).step(),
            Err(StepError { failure: Failure::NonFiniteState, .. })
        ));
        assert!(SLOPE.adaptive(DOP853, 1e-8, bad).step().is_err());
        assert!(SLOPE.taylor(Taylor::default(), bad).step().is_err());
    }
}

/// A start off a constraint is refused; the same start put onto it is not.
#[test]
fn a_start_off_a_constraint() {
    let off = State::new([1.0, -1.0, -0.6], [0.7, 0.4, 0.6]);
    assert!(matches!(
        ON_A_SPHERE.integrator(Rattle, 0.02, off).step(),
        Err(StepError { failure: Failure::OffConstraint { .. }, .. })
    ));
    let on = State::new([1.0, -1.0, -0.5], [0.7, 0.4, 0.6]);
    ON_A_SPHERE.integrator(Rattle, 0.02, on).step().expect("the start is on the sphere");
}

/// Friction that would feed energy is refused where the parameter says so, with a contact step as the control.
#[test]
fn a_parameter_that_feeds_energy() {
    let feeding = Braked { c: -0.4, ..BRAKED };
    let outcome = feeding.integrator(DiscreteGradient, 0.1, State::new(1.1, 0.6)).step();
    assert!(outcome.is_err(), "C must be positive semidefinite");
    BRAKED.integrator(DiscreteGradient, 0.1, State::new(1.1, 0.6)).step().expect("friction brakes");
}
