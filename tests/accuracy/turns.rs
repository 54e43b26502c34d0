//! Invariants with an angle `atan2(y, x)`: corrections follow it across its cut, up to half a turn a step.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Invariants, Method};

/// x = (cos t, sin t, t).
#[vector_field(keeps(ahead = x[1].atan2(x[0]) - x[2], square = x[0] * x[0] + x[1] * x[1]))]
fn helix(x: [f64; 3]) -> [f64; 3] {
    [-x[1], x[0], 1.0]
}

/// An energy that loses 2πk with each turn by its formula, and nothing along the motion.
#[hamiltonian]
fn swirl(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + q[1] * q[1]) / 2.0 + k * q[1].atan2(q[0])
}

/// The energy of this Lagrangian has no formula: its changes are differences of values.
#[lagrangian]
fn stiff_swirl(q: [f64; 2], v: [f64; 2], k: f64) -> f64 {
    let square = v[0] * v[0] + v[1] * v[1];
    square / 2.0 + square * square / 10.0 - (q[0] * q[0] + q[1] * q[1]) / 2.0 - k * q[1].atan2(q[0])
}

const START: FlowState<[f64; 3]> = FlowState { t: 0.0, x: [1.0, 0.0, 0.0] };

/// Returns the distance of a state from the helix.
fn error(state: &FlowState<[f64; 3]>) -> f64 {
    let FlowState { t, x } = state;
    (x[0] - t.cos()).abs().max((x[1] - t.sin()).abs()).max((x[2] - t).abs())
}

#[test]
fn projected_series_follow_turns() {
    let mut sim = Helix.taylor(Projection(Taylor::default(), Integrals), START);
    sim.advance_to(200.0).unwrap();
    assert!(error(&sim.state()) < 1e-12, "{:?}", sim.state());
    // Steps of a sixth of a turn, and of a whole number of them in half a turn.
    for h in [1.0, std::f64::consts::FRAC_PI_4] {
        let mut sim = Helix.taylor(Projection(TaylorFixed::<20> { h }, Integrals), START);
        sim.advance(100).unwrap();
        assert!(error(&sim.state()) < 1e-12, "{h}: {:?}", sim.state());
    }
}

/// Control: an invariant that takes the difference of two values is led back to the wrong turn.
#[test]
fn differences_of_values_do_not_follow_turns() {
    #[derive(Clone, Copy, Debug)]
    struct Values;
    impl Invariants<Helix> for Values {
        type Values = f64;
        fn changes(&self, _: &Helix, x: &[f64; 3], d: &[f64; 3]) -> f64 {
            let ahead = |x: [f64; 3]| x[1].atan2(x[0]) - x[2];
            ahead([0, 1, 2].map(|i| x[i] + d[i])) - ahead(*x)
        }
        fn gradients(&self, _: &Helix, x: &[f64; 3]) -> [f64; 3] {
            let square = x[0] * x[0] + x[1] * x[1];
            [-x[1] / square, x[0] / square, -1.0]
        }
    }
    let mut sim = Helix.taylor(Projection(Taylor::default(), Values), START);
    assert!(sim.advance_to(20.0).is_err() || error(&sim.state()) > 1.0, "{:?}", sim.state());
}

/// In a step above half a turn the ends tell another turn. Steps of 7 and 1 look alike.
#[test]
fn steps_above_half_a_turn_are_refused() {
    fn outcome<M: Method<Helix>>(method: M, h: f64) -> Result<f64, StepError> {
        let mut sim = Helix.integrator(method, h, START);
        sim.advance(7).map(|()| error(&sim.state()))
    }
    for h in [3.3, 4.0, 5.0, 6.2, 7.0, 11.0, -4.0] {
        for refused in [outcome(Projection(DOP853, Integrals), h), outcome(Relaxation(DOP853), h)] {
            assert_eq!(refused, Err(StepError::new(Failure::Turned { what: "atan2(x[1], x[0])" }, 0.0, h)), "{h}");
        }
    }
    for h in [1.0, 2.0, 3.0] {
        assert!(outcome(Projection(DOP853, Integrals), h).unwrap() < 1e-3, "{h}");
        assert!(outcome(Relaxation(DOP853), h).unwrap() < 0.1, "{h}");
    }
    let mut sim = Helix.taylor(Projection(TaylorFixed::<30> { h: 4.0 }, Integrals), START);
    assert!(matches!(sim.advance(7), Err(StepError { failure: Failure::Turned { .. }, .. })));
    // Adaptive runs shorten their steps.
    let mut sim = Helix.taylor(Projection(Taylor { tolerance: 0.05 }, Integrals), START);
    sim.advance_to(20.0).unwrap();
    assert!(error(&sim.state()) < 0.5, "{:?}", sim.state());
}

#[test]
fn energies_with_an_angle_are_followed() {
    let (swirl, start) = (Swirl { k: 0.1 }, State::new([1.0, 0.0], [0.0, 1.0]));
    let mut reference = swirl.taylor(Taylor::default(), start);
    reference.advance_to(20.0).unwrap();
    let reference = reference.state();
    let distance = |state: &State<[f64; 2]>| (state.q[0] - reference.q[0]).abs() + (state.q[1] - reference.q[1]).abs();
    let mut sim = swirl.taylor(Projection(Taylor::default(), Energy), start);
    sim.advance_to(20.0).unwrap();
    assert!(distance(&sim.state()) < 1e-12);
    let mut sim = swirl.integrator(Projection(DOP853, Energy), 0.01, start);
    sim.advance(2000).unwrap();
    assert!(distance(&sim.state()) < 1e-12);
    let mut sim = swirl.integrator(FourthOrder(DiscreteGradient), 0.01, start);
    sim.advance(2000).unwrap();
    assert!(distance(&sim.state()) < 1e-8);
}

/// Off by 0.9 if the jump of the value at the cut is corrected.
#[test]
fn energies_of_velocities_are_followed() {
    let swirl = StiffSwirl { k: 0.1 };
    let start = swirl.at([1.0, 0.0], [0.0, 1.0]);
    let mut reference = swirl.integrator(DOP853, 0.01, start);
    reference.advance(2000).unwrap();
    let mut sim = swirl.integrator(Projection(DOP853, Energy), 0.01, start);
    sim.advance(2000).unwrap();
    let [q, expected] = [sim.state().q, reference.state().q];
    assert!((q[0] - expected[0]).abs() + (q[1] - expected[1]).abs() < 1e-10, "{q:?}");
    let mut sim = swirl.adaptive(Relaxation(DOP853), 1e-8, start);
    sim.advance_to(20.0).unwrap();
    let q = sim.state().q;
    assert!((q[0] - expected[0]).abs() + (q[1] - expected[1]).abs() < 1e-7, "{q:?}");
}
