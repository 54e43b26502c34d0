//! A run continues from its own event, and from states within its last step.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A mass on a rod of length 1, in Cartesian coordinates.
#[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - 1.0])]
fn rod(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + 9.81 * q[1]
}

#[contact_hamiltonian]
fn damped_pendulum(q: f64, p: f64, s: f64) -> f64 {
    p * p / 2.0 - q.cos() + 0.1 * s
}

/// With constraints, discrete gradients have momenta that are tangent up to h² only. The run still continues.
#[test]
fn with_constraints() {
    let start = State::new([1.0, 0.0], [0.0, 0.5]);
    macro_rules! events {
        ($method:expr, $bar:expr) => {{
            let mut exact = Rod.integrator(Suzuki4.of(Rattle), 0.001, start);
            let mut sim = Rod.integrator($method, 0.01, start);
            for n in 0..6 {
                let exact = exact.until_event(100.0, Direction::Any, |s| s.q[0]).unwrap().unwrap().state;
                let found = sim.until_event(100.0, Direction::Any, |s| s.q[0]).unwrap().unwrap().state;
                assert!((found.t - exact.t).abs() < $bar, "{n}: {found:?} {exact:?}");
                assert!((sim.energy() - 0.125).abs() < 0.01 && sim.state() == found);
            }
            sim.advance(100).unwrap();
        }};
    }
    events!(DiscreteGradient, 1e-3);
    events!(Suzuki4.of(DiscreteGradient), 1e-5);
    events!(Rattle, 1e-3);
    // A state set by the user must fulfil all conditions.
    let mut sim = Rod.integrator(DiscreteGradient, 0.01, start);
    sim.set_state(State::new([1.0, 0.0], [0.1, 0.5]));
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::OffConstraint { .. }, .. })));
}

/// States within a step are close to the states at its ends, including momenta, at any small distance.
#[test]
fn next_to_the_ends_of_steps_with_constraints() {
    macro_rules! next_to {
        ($method:expr) => {
            for h in [0.01, -0.01] {
                let mut sim = Rod.integrator($method, h, State::new([1.0, 0.0], [0.0, 0.5]));
                sim.advance(37).unwrap();
                for part in [1e-14, 1e-12, 1e-9, 1e-6] {
                    let (here, t) = (sim.state(), sim.time() + part * h);
                    let [mut copy, mut next] = [sim.clone(), sim.clone()];
                    next.step().unwrap();
                    let states = [next.at(t), copy.sampled_at([t]).next().unwrap()];
                    for found in states.map(Result::unwrap) {
                        // Forces are below 30. The momentum has a normal part of order h².
                        let gap = (0..2).map(|i| (found.p[i] - here.p[i]).abs()).fold(0.0, f64::max);
                        assert!(gap < 30.0 * part * 0.01 + 4e-3, "{part}: {gap:e}");
                    }
                }
                // Times that are whole steps up to rounding.
                let mut sim = Rod.integrator($method, h, State::new([1.0, 0.0], [0.0, 0.5]));
                for state in sim.sampled_every(0.37 * h).take(1000) {
                    let State { q, p, .. } = state.unwrap();
                    assert!((q[0] * p[0] + q[1] * p[1]).abs() < 3e-3, "{q:?} {p:?}");
                }
            }
        };
    }
    next_to!(DiscreteGradient);
    next_to!(Suzuki4.of(DiscreteGradient));
    next_to!(Rattle);
}

/// Without the action, s is a NaN before and after an event.
#[test]
fn without_action() {
    let start = ContactState::new(1.2, 0.0, 0.0);
    let mut with = DampedPendulum.integrator(BlanesMoan6, 0.02, start);
    let mut sim = DampedPendulum.integrator(BlanesMoan6, 0.02, start).without_action();
    for _ in 0..4 {
        let exact = with.until_event(100.0, Direction::Any, |s| s.q).unwrap().unwrap().state;
        let found = sim.until_event(100.0, Direction::Any, |s| s.q).unwrap().unwrap().state;
        assert!((found.t - exact.t).abs() < 1e-12 && found.s.is_nan());
        // After an impact.
        sim.set_state(ContactState { p: -0.5 * found.p, ..found });
        with.set_state(ContactState { p: -0.5 * exact.p, ..exact });
        sim.step().unwrap();
    }
    assert!(sim.sampled_every(0.013).interpolated().nth(7).unwrap().is_ok());
}

/// Whole steps end before the requested time. The rest of the way is searched, too, and the run ends at the requested time.
#[test]
fn an_event_behind_the_last_whole_step() {
    let start = ContactState::new(1.2, 0.0, 0.0);
    macro_rules! behind {
        ($($method:expr),*) => { $( for h in [0.1, -0.1] {
            let mut sim = DampedPendulum.integrator($method, h, start);
            let event = sim.crossings(Direction::Any, |s| s.q).next().unwrap().unwrap().state;
            let whole = (event.t / h).floor() as u64;
            for (part, is_found) in [(-0.01, false), (0.0, true), (0.01, true)] {
                let mut sim = DampedPendulum.integrator($method, h, start);
                let found = sim.until_event(event.t + part * h, Direction::Any, |s| s.q).unwrap();
                assert_eq!(found.is_some(), is_found, "{} {part}", stringify!($method));
                match found {
                    Some(found) => {
                        assert!((found.state.t - event.t).abs() < 1e-13 && sim.state() == found.state);
                        let again = sim.until_event(event.t + 0.01 * h, Direction::Any, |s| s.q);
                        assert_eq!(again, Ok(None), "{}", stringify!($method));
                    }
                    None => {
                        // A search takes the steps of a run without one, to the last bit. The last step is shorter.
                        let end = event.t + part * h;
                        let mut plain = DampedPendulum.integrator($method, h, start);
                        plain.advance(whole).unwrap();
                        plain.end_at(end).unwrap();
                        assert!(sim.state() == plain.state() && sim.time() == end);
                        sim.step().unwrap();
                        plain.step().unwrap();
                        assert_eq!((sim.state(), sim.step_size()), (plain.state(), h));
                    }
                }
            }
            // Before the first step.
            let mut sim = DampedPendulum.integrator($method, h, start);
            let found = sim.until_event(0.05 * h, Direction::Any, |s| s.t - 0.02 * h).unwrap().unwrap();
            assert!((found.state.t - 0.02 * h).abs() < 1e-15, "{found:?}");
        } )* };
    }
    behind!(ContactSplitting, Suzuki4.of(ContactSplitting), ContactGauss::<2>, ContactDiscreteGradient, RK4);
}
