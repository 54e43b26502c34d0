//! Times that are very short or very long relative to the time scale of the state.

use geoint_runtime::prelude::*;

#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) - k * q.cos()
}

#[hamiltonian]
fn two_bodies(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// At rest only the forces determine the length of a step.
#[test]
fn at_rest_in_any_unit_of_time() {
    for exponent in [0, 10, 15, 20, 30, 60, -10, -30, -60] {
        let w = 10_f64.powi(exponent);
        for (m, k) in [(1.0 / w, w), (1.0, w * w)] {
            let mut sim = Pendulum { m, k }.taylor(Taylor::default(), State::new(1.5, 0.0));
            sim.advance_to(10.0 / w).unwrap();
            assert!((sim.state().q + 1.0540491554508432).abs() < 1e-13, "{w:e}: {}", sim.state().q);
        }
        for length in [1e-30, 1.0, 1e30] {
            let (m, q) = (1e5, [length, 0.0]);
            let k = m * w * w * length * length * length;
            if !(k > 1e-290 && k < 1e290) {
                continue;
            }
            let mut sim = TwoBodies { m, k }.taylor(Taylor::default(), State::new(q, [0.0; 2]));
            sim.advance_to(0.5 / w).unwrap();
            let x = sim.state().q[0] / length;
            assert!((x - 0.869248697576108).abs() < 3e-15, "{w:e} {length:e}: {x}");
        }
    }
}

#[hamiltonian]
fn free_fall(q: f64, p: f64, g: f64) -> f64 {
    p * p / 2.0 + g * q
}

/// Steps of polynomials grow without limit, but time is finite. The last step is refused.
#[test]
fn time_ends() {
    for (g, state) in [(0.0, State::new(1.0, 0.0)), (0.0, State::new(1.0, 0.1)), (0.0, State::new(1.0, 1e-300))] {
        let mut sim = FreeFall { g }.taylor(Taylor::default(), state);
        let error = (0..5000).find_map(|_| sim.step().err()).unwrap();
        assert!(error.is_shortest(), "{error}");
        assert!(sim.time() > 1e308 && sim.time().is_finite() && sim.state().q.is_finite(), "{:?}", sim.state());
    }
    // A search without an end stops with the same error.
    let mut sim = FreeFall { g: 0.0 }.taylor(Taylor::default(), State::new(1.0, 0.0));
    let found = sim.crossings(Direction::Any, |state| state.q - 2.0).next();
    assert!(matches!(found, Some(Err(error)) if error.is_shortest()), "{found:?}");
    #[hamiltonian]
    fn single(q: f32, p: f32) -> f32 {
        p * p / 2.0 + 0.0 * q
    }
    let mut sim = Single.taylor(Taylor::default(), State::new(1.0, 0.1));
    assert!(sim.advance(5000).is_err() && sim.time().is_finite());
}

/// A polynomial reaches a far time in one step. An event just ahead lies in a small part of this step.
#[test]
fn events_just_ahead_of_a_far_end() {
    let (state, fall) = (State::new(1.0, 10.0), |h: f64| (10.0 - (100.0 - 2.0 * 9.81 * h).sqrt()) / 9.81);
    let ground = (10.0 + (100.0 + 2.0 * 9.81_f64).sqrt()) / 9.81;
    for end in [10.0, 1e3, 1e6, 1e8, 1e9, 1e12, 1e30] {
        let run = || FreeFall { g: 9.81 }.taylor(Taylor::default(), state);
        let ahead = run().until_event(end, Direction::Down, |s| s.q).unwrap().unwrap();
        assert!((ahead.state.t - ground).abs() < 1e-14, "{end:e}: {}", ahead.state.t);
        // Up through a height, and down again.
        let mut sim = run();
        let both: Vec<f64> =
            sim.crossings(Direction::Any, |s| s.q - 3.0).until(end).map(|found| found.unwrap().state.t).collect();
        assert_eq!(both.len(), 2, "{end:e}: {both:?}");
        assert!((both[0] - fall(2.0)).abs() < 1e-14 && (both[0] + both[1] - 20.0 / 9.81).abs() < 1e-14, "{both:?}");
        // A function that is not a polynomial.
        let mut sim = run();
        let both: Vec<f64> = sim
            .crossings(Direction::Any, |s| (s.q * s.q + 1.0).sqrt() - 10_f64.sqrt())
            .until(end.min(1e12))
            .map(|found| found.unwrap().state.t)
            .collect();
        assert_eq!(both.len(), 3, "{end:e}: {both:?}");
        assert!((both[0] - fall(2.0)).abs() < 1e-13, "{end:e}: {both:?}");
    }
    // A fly-by. Far away the function is almost constant.
    let mut sim = FreeFall { g: 0.0 }.taylor(Taylor::default(), State::new(-12.0, 1.3));
    let near: Vec<f64> = sim
        .crossings(Direction::Any, |s| (-s.q * s.q).exp() - 0.5)
        .until(20.0)
        .map(|found| found.unwrap().state.t)
        .collect();
    let half = 2_f64.ln().sqrt();
    assert_eq!(near.len(), 2, "{near:?}");
    assert!((near[0] - (12.0 - half) / 1.3).abs() < 1e-13 && (near[1] - (12.0 + half) / 1.3).abs() < 1e-13);
}

/// A refused step towards a time does not change the step size.
#[test]
fn the_length_of_steps_stays() {
    #[hamiltonian]
    fn logarithm(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q * q.ln()
    }
    let mut sim = Logarithm.integrator(StormerVerlet, 0.1, State::new(1.0, 0.0));
    assert!(sim.end_at(100.0).is_err() && sim.step_size() == 0.1);
    assert!(sim.end_at(f64::NAN).is_err() && sim.step_size() == 0.1 && sim.time() == 0.0);
    sim.end_at(0.05).unwrap();
    assert_eq!((sim.time(), sim.step_size()), (0.05, 0.1));
}
