//! States as plain data: defaults, conversions, times of errors.

use geoint_runtime::prelude::*;

/// A pendulum.
#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - q.cos()
}

#[test]
fn defaults_are_origins() {
    assert_eq!(State::<[f64; 3]>::default(), State::at(0.0, [0.0; 3], [0.0; 3]));
    assert_eq!(ContactState::<f32>::default(), ContactState::at(0.0, 0.0, 0.0, 0.0));
    assert_eq!(FlowState::<[[f64; 2]; 3]>::default(), FlowState::at(0.0, [[0.0; 2]; 3]));
}

#[test]
fn tuples_are_states_at_time_zero() -> Result<(), StepError> {
    assert_eq!(State::from((1.0, 0.3)), State::new(1.0, 0.3));
    assert_eq!(ContactState::from(([1.0], [0.3], 0.2)), ContactState::new([1.0], [0.3], 0.2));
    assert_eq!(FlowState::from([1.0, 0.3]), FlowState::new([1.0, 0.3]));
    let mut sim = Pendulum { m: 0.7 }.integrator(StormerVerlet, 0.1, (1.0, 0.3).into());
    sim.step()?;
    assert!(sim.state().q > 1.0);
    Ok(())
}

#[test]
fn errors_know_their_time() {
    let start = State::at(2.5, f64::NAN, 0.3);
    let error = Pendulum { m: 0.7 }.integrator(StormerVerlet, 0.1, start).step().unwrap_err();
    assert_eq!(error.time(), Some(2.5), "{error}");
    let error = Pendulum { m: 0.7 }.integrator(StormerVerlet, 0.0, State::new(1.0, 0.3)).step().unwrap_err();
    assert_eq!(error.time(), None, "{error}");
    let error = Pendulum { m: f64::NAN }.integrator(StormerVerlet, 0.1, State::new(1.0, 0.3)).step().unwrap_err();
    assert_eq!(error.time(), None, "{error}");
}

#[test]
fn states_are_serialised() {
    macro_rules! back {
        ($($state:expr => $type:ty;)*) => { $(
            let text = serde_json::to_string(&$state).expect("numbers");
            assert_eq!(serde_json::from_str::<$type>(&text).expect("the text of a state"), $state, "{text}");
        )* };
    }
    back! {
        State::at(0.1, [1.0, -0.3], [1.0 / 3.0, 2e-300]) => State<[f64; 2]>;
        ContactState::at(0.1_f32, 1.0, -0.3, 1.0 / 3.0) => ContactState<f32>;
        FlowState::at(0.1, [[1.0, -0.3], [1.0 / 3.0, 2e-300]]) => FlowState<[[f64; 2]; 2]>;
    }
}
