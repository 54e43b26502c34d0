//! States within the last step of a run.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - m * q.cos()
}

/// A state within the last step has the accuracy of the method, for every pace, after steps one by one and in one call. The ends are those of the run.
#[test]
fn every_run_knows_its_last_step() {
    let (system, state) = (Pendulum { m: 1.7 }, State::new(1.0, 0.0));
    let exact = |t: f64| {
        let mut sim = system.taylor(Taylor::default(), state);
        sim.advance_to(t).unwrap();
        sim.state()
    };
    macro_rules! check {
        ($run:expr, $error:expr) => {{
            let mut sim = $run;
            assert_eq!(sim.at(0.0), Ok(state));
            assert!(sim.at(1e-3).is_err());
            for calls in [[1; 4], [3; 4], [700; 4]] {
                for steps in calls {
                    sim.advance(steps - 1).unwrap();
                    let before = sim.state();
                    sim.step().unwrap();
                    let after = sim.state();
                    assert_eq!([sim.at(before.t), sim.at(after.t)], [Ok(before), Ok(after)]);
                    let mut at_once = $run;
                    at_once.advance(sim.steps()).unwrap();
                    for part in [1e-6, 0.1, 0.5, 0.9] {
                        let t = before.t + part * (after.t - before.t);
                        for found in [sim.at(t), at_once.at(t)] {
                            let (found, exact) = (found.unwrap(), exact(t));
                            assert!(
                                (found.q - exact.q).abs() < $error && (found.p - exact.p).abs() < $error,
                                "{found:?} {exact:?}"
                            );
                            assert_eq!(found.t, t);
                        }
                    }
                    let (length, unknown) =
                        (after.t - before.t, Failure::NotInLastStep { from: before.t, to: after.t });
                    for t in [before.t - 0.01 * length, after.t + 0.01 * length, f64::NAN] {
                        assert_eq!(sim.at(t).unwrap_err().failure, unknown);
                    }
                }
            }
            // A given state has no last step.
            let State { t, q, p } = sim.state();
            sim.set_state(State { t, q, p });
            assert_eq!(sim.at(t), Ok(State { t, q, p }));
            assert_eq!(sim.at(t + 1e-3).unwrap_err().failure, Failure::NotInLastStep { from: t, to: t });
        }};
    }
    for h in [0.02, -0.02] {
        check!(system.integrator(BlanesMoan4, h, state), 1e-5);
        check!(system.integrator(BlanesMoan4, h, state).compensated(), 1e-5);
        check!(system.integrator(DiscreteGradient, h, state), 5e-2);
        check!(system.integrator(Gauss::<3>, h, state), 1e-8);
    }
    check!(system.integrator(Relaxation(RK4), 0.02, state), 1e-4);
    check!(system.adaptive(DOP853, 1e-10, state), 1e-6);
    check!(system.adaptive(DiscreteGradient, 1e-5, state).longest_step(0.01), 5e-2);
    check!(system.taylor(Taylor::default(), state), 1e-9);
    // The time at which a call has ended is the start of the next step.
    let mut sim = system.integrator(BlanesMoan4, 0.1, state);
    sim.advance_to(0.3).unwrap();
    let before = sim.state();
    sim.step().unwrap();
    assert_eq!((before.t, sim.at(before.t)), (0.3, Ok(before)));
    // After a change of the step size, the last step is not known.
    let mut sim = system.integrator(BlanesMoan4, 0.02, state);
    sim.advance(5).unwrap();
    sim.set_step_size(0.01);
    assert!(sim.at(0.09).is_err() && sim.at(sim.time()).is_ok());
    sim.step().unwrap();
    assert!(sim.at(0.105).is_ok());
}
