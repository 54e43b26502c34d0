//! Events that are hard to find: at the start and at the end of a search, two events within a step, in small units.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::f64::consts::PI;

#[hamiltonian]
fn oscillator(q: f64, p: f64) -> f64 {
    (p * p + q * q) / 2.0
}

/// Around 10⁶, where rounding of q is 10⁻¹⁰.
#[hamiltonian]
fn far(q: f64, p: f64) -> f64 {
    p * p / 2.0 + (q - 1e6) * (q - 1e6) / 2.0
}

/// x' = 1, y' = 0.
#[vector_field]
fn uniform(x: [f64; 2]) -> [f64; 2] {
    [1.0 + 0.0 * x[0], 0.0 * x[1]]
}

#[hamiltonian]
fn ball(q: f64, p: f64, m: f64, g: f64) -> f64 {
    p * p / (2.0 * m) + m * g * q
}

/// A search continues from the last event and does not find it again, on either side of zero.
#[test]
fn one_event_after_the_other() {
    for sign in [1.0, -1.0] {
        every_run!(Oscillator, State::new(1.0, 0.0), sign * 0.1, |sim| {
            for n in 0..6 {
                let found = sim.until_event(sign * 100.0, Direction::Any, |s| s.q).unwrap().unwrap();
                assert!((found.state.t - sign * PI * (n as f64 + 0.5)).abs() < 1e-6, "{n}: {}", found.state.t / PI);
            }
        });
        // At q = 10⁶ the tolerance of a step is 10⁻⁸.
        every_run!(Far, State::new(1e6 + 1.0, 0.0), sign * 0.1, 1e-14, |sim| {
            for n in 0..6 {
                let found = sim.until_event(sign * 100.0, Direction::Any, |s| s.q - 1e6).unwrap().unwrap();
                assert!((found.state.t - sign * PI * (n as f64 + 0.5)).abs() < 1e-5, "{n}: {}", found.state.t / PI);
            }
        });
    }
}

/// Events from many starts. At an event only rounding is left of the coordinate. It has either sign, and gives no information on the time scale of the
/// state.
#[test]
fn events_are_found_once_whatever_their_rounding() {
    macro_rules! check {
        ($($method:expr),*) => { $( for k in 0..40 {
            let start = State::new(0.1 + 0.02 * f64::from(k), 1.0);
            let phase = start.q.atan2(start.p);
            let mut sim = Oscillator.taylor($method, start);
            for n in 1..=12 {
                let found = sim.until_event(100.0, Direction::Any, |s| s.q).unwrap().unwrap();
                let gap = found.state.t - (PI * f64::from(n) - phase);
                assert!(gap.abs() < 1e-3, "{}, from {}: event {n} is off by {gap}", stringify!($method), start.q);
            }
        } )* };
    }
    check!(
        Taylor::default(),
        Taylor { tolerance: 1e-6 },
        TaylorFixed::<12> { h: 0.1 },
        Projection(Taylor::default(), Energy)
    );
}

/// A search may end just after an event. The event is still not found again.
#[test]
fn an_end_just_behind_an_event() {
    macro_rules! check {
        ($($method:expr),*) => { $( for k in 0..40 {
            let level = 0.04 * f64::from(k / 2);
            let mut sim = Oscillator.taylor($method, State::new(1.0, 0.1 + 0.02 * f64::from(k)));
            for _ in 0..4 {
                let found = sim.until_event(100.0, Direction::Any, |s| s.q - level).unwrap().unwrap();
                for digits in 3..16 {
                    let end = found.state.t * (1.0 + 10_f64.powi(-digits));
                    let again = sim.clone().until_event(end, Direction::Any, |s| s.q - level).unwrap();
                    assert_eq!(again, None, "{}: {found:?}", stringify!($method));
                }
            }
        } )* };
    }
    check!(Taylor::default(), Taylor { tolerance: 1e-6 }, TaylorFixed::<16> { h: 0.4 });
}

/// A function that is zero everywhere has no events, also in a search with an end. A function that is not zero everywhere has events.
#[test]
fn zero_until_the_end() {
    every_run!(Oscillator, State::new(1.0, 0.0), 0.1, |sim| {
        let first = sim.crossings(Direction::Any, |s| s.q * 0.0).until(7.0).next();
        assert!(matches!(first, Some(Err(StepError { failure: Failure::NoEvent, .. }))), "{first:?}");
        assert!((6.8..=7.0).contains(&sim.time()), "{}", sim.time());
        // One of two functions is zero, and the search reports events of the other.
        let before = sim.time();
        let found: Vec<_> = sim.crossings(Direction::Any, |s| [s.q * 0.0, s.q]).until(14.0).collect();
        assert!(found.len() == 2 && found.iter().all(Result::is_ok), "{before}: {found:?}");
        // An empty search interval.
        let end = sim.time();
        assert_eq!(sim.until_event(end, Direction::Any, |s| s.q * 0.0), Ok(None));
    });
}

/// A search with a function that has no events, at once or from some time on, leaves the run unchanged: it takes no step.
#[test]
fn what_has_no_events_moves_nothing() {
    for sign in [1.0, -1.0] {
        every_run!(Oscillator, State::new(1.0, 0.0), sign * 0.1, |sim| {
            sim.advance(3).unwrap();
            let (before, steps, mut other) = (sim.state(), sim.steps(), sim.clone());
            let to = before.t + sign * 7.0;
            let errors = [
                sim.clone().until_event(sign * 1e4, Direction::Any, |s| s.q * 0.0),
                sim.until_event(to, Direction::Any, |s| s.q * 0.0),
                sim.until_event(to, Direction::Any, |s| s.q * f64::NAN),
                // The function is a NaN from a later time on.
                sim.until_event(to, Direction::Any, |s| ((s.t - before.t) * -sign + 2.0).sqrt() + 1.0),
            ];
            for error in errors {
                assert!(matches!(error, Err(StepError { failure: Failure::NoEvent, .. })), "{error:?}");
            }
            assert_eq!((sim.state(), sim.steps()), (before, steps));
            // The run continues as without the searches.
            let [found, expected] = [&mut sim, &mut other].map(|sim| sim.until_event(to, Direction::Any, |s| s.q));
            assert!(found == expected && matches!(found, Ok(Some(_))), "{found:?} {expected:?}");
        });
    }
}

/// A zero at the end of one search is found exactly once: by this search, and not by the next one.
#[test]
fn where_one_search_ends_and_the_next_begins() {
    for sign in [1.0, -1.0] {
        let g = |sign: f64| move |s: &FlowState<[f64; 2]>| [sign * s.x[0] - 1.0, s.x[0] * 0.0 - 1.0];
        let mut sim = Uniform.integrator(RK4, sign * 0.25, FlowState::new([0.0; 2]));
        let counts: Vec<usize> =
            [0.5, 1.0, 1.5, 2.0].map(|t| sim.crossings(Direction::Any, g(sign)).until(sign * t).count()).to_vec();
        assert_eq!(counts, [0, 1, 0, 0], "{sign}");
        let mut sim = Uniform.taylor(TaylorFixed::<6> { h: sign * 0.25 }, FlowState::new([0.0; 2]));
        let counts: Vec<usize> = [0.5, 1.0, 1.5, 2.0]
            .map(|t| {
                sim.crossings(Direction::Any, |s| [s.x[0] * sign - 1.0, s.x[0] * 0.0 - 1.0]).until(sign * t).count()
            })
            .to_vec();
        assert_eq!(counts, [0, 1, 0, 0], "{sign}");
    }
    // Several events at the end of a step, in a run backwards in time. The first event precedes them.
    let mut sim = Uniform.taylor(TaylorFixed::<6> { h: -0.25 }, FlowState::new([0.0; 2]));
    let all = sim.crossings(Direction::Down, |s| [s.x[0] + 1.0, s.x[0] + 0.75, s.x[0] + 1.0]).take(3);
    let all: Vec<(f64, usize)> = all.map(|c| c.map(|c| (c.state.t, c.which)).unwrap()).collect();
    assert_eq!(all, [(-0.75, 1), (-1.0, 0), (-1.0, 2)]);
}

/// q = sin t exceeds 1 − e for a time of 2√(2e), which is shorter than a step.
#[test]
fn two_within_a_step() {
    for (e, tolerance) in [(0.1, 1e-13), (1e-2, 1e-13), (1e-4, 1e-13), (1e-8, 1e-13), (1e-8, 1e-11), (1e-6, 1e-9)] {
        let top: f64 = 1.0 - e;
        every_run!(Oscillator, State::new(0.0, 1.0), 0.3, tolerance, |sim| {
            let found = sim.crossings(Direction::Any, |s| s.q - top).until(18.0);
            let found: Vec<_> = found.map(Result::unwrap).collect();
            assert_eq!(found.len(), 6, "{e}");
            for (n, crossing) in found.iter().enumerate() {
                let half = if n % 2 == 0 { -top.acos() } else { top.acos() };
                let gap = crossing.state.t - (PI * (0.5 + 2.0 * (n / 2) as f64) + half);
                // An error of 10⁻¹⁰ in the maximum moves the events by 10⁻¹⁰/√e.
                assert!(gap.abs() < 1e-6 + 1e-9 / e.sqrt() && crossing.rises == (n % 2 == 0), "{e}: {gap:e}");
            }
        });
    }
    // The function does not reach zero.
    for top in [1.0 + 1e-7, 1.5] {
        every_run!(Oscillator, State::new(0.0, 1.0), 0.3, |sim| {
            assert_eq!(sim.crossings(Direction::Any, |s| s.q - top).until(18.0).count(), 0, "{top}");
        });
    }
}

/// Flights shorter than a step, down to 10⁻⁶ of a step. The position of an impact keeps its rounding error, on either side of the ground.
#[test]
fn many_impacts() {
    let (system, state) = (Ball { m: 2.3, g: 9.81 }, State::new(1.0, 0.0));
    let fall = (2.0 / 9.81_f64).sqrt();
    every_run!(system, state, 0.01, |sim| {
        for n in 0..20 {
            let impact = sim.until_event(100.0, Direction::Down, |s| s.q).unwrap().unwrap();
            let exact = fall + (1..=n).map(|k| 2.0 * fall * 0.5_f64.powi(k)).sum::<f64>();
            assert!((impact.state.t - exact).abs() < 1e-8, "{n}: {} {exact}", impact.state.t);
            sim.set_state(State { p: -0.5 * impact.state.p, ..impact.state });
        }
    });
}

/// In single precision an event at the end of a search is not found again, either.
#[test]
fn events_in_single_precision_are_found_once() {
    #[hamiltonian]
    fn spring(q: f32, p: f32, k: f32) -> f32 {
        (p * p + k * q * q) / 2.0
    }
    for start in [0.3_f32, 0.9, 1.0, 1.7] {
        let mut sim = Spring { k: 2.0 }.taylor(Taylor::default(), State::new(start, 0.4));
        let mut last = None;
        for _ in 0..60 {
            let t = sim.until_event(1e6, Direction::Any, |s| s.q).unwrap().unwrap().state.t;
            let passed = last.map_or(PI, |last: f32| f64::from(t - last) * 2.0_f64.sqrt());
            assert!((passed - PI).abs() < 1e-4, "{start}: {passed} before {t}");
            last = Some(t);
        }
    }
}

/// q = cos t passes six zeros of sin(40 q) until t = 1.05. They are π/40 apart in q.
#[test]
fn zeros_that_are_closer_than_a_step() {
    let count = |h: f64| {
        let mut sim = Oscillator.integrator(DOP853, h, State::new(1.0, 0.0));
        sim.crossings(Direction::Any, |s| (40.0 * s.q).sin()).until(1.05).count()
    };
    for h in [0.07, 0.05, 0.02, 0.003] {
        assert_eq!(count(h), 6, "{h}");
    }
    // Longer steps miss pairs.
    assert!(count(0.25) < 6);
    let mut sim = Oscillator.taylor(Taylor::default(), State::new(1.0, 0.0));
    assert_eq!(sim.crossings(Direction::Any, |s| [(s.q * 40.0).sin()]).until(1.05).count(), 6);
}

/// A jump is one event, however often a search starts there. The function is not zero on either side.
#[test]
fn a_jump_is_found_once() {
    macro_rules! check {
        ($sim:expr, $until:expr) => {{
            let mut sim = $sim;
            let mut times = vec![];
            while let Some(found) = sim.until_event($until, Direction::Any, |s| Real::signum(s.q)).unwrap() {
                times.push(found.state.t);
                assert!(times.len() < 10, "{times:?}");
            }
            assert_eq!(sim.time(), $until);
            for (n, t) in times.iter().enumerate() {
                let exact = PI * (0.5 + n as f64) * f64::signum($until);
                assert!((t - exact).abs() < 1e-2, "{times:?}");
            }
            assert_eq!(times.len(), 4);
        }};
    }
    for (h, end) in [(0.1, 13.0), (-0.1, -13.0)] {
        check!(Oscillator.integrator(StormerVerlet, h, State::new(1.0, 0.0)), end);
        check!(Oscillator.integrator(BlanesMoan4, h, State::new(1.0, 0.0)), end);
    }
    check!(Oscillator.adaptive(DOP853, 1e-9, State::new(1.0, 0.0)), 13.0);
    // The end of the search lies just behind the jump, so that time is rounded by a large part of the step.
    for gap in [1e-11, 3e-11, 3e-10] {
        let mut sim = Oscillator.integrator(StormerVerlet, 0.1, State::new(1.0, 0.3));
        let jump = sim.clone().until_event(13.0, Direction::Any, |s| Real::signum(s.q)).unwrap().expect("a jump").state;
        let end = jump.t + gap;
        let found = (0..3).map(|_| sim.until_event(end, Direction::Any, |s| Real::signum(s.q)).unwrap());
        assert_eq!(found.map(|found| found.is_some()).collect::<Vec<_>>(), [true, false, false]);
    }
}

/// In single precision and after a long time, time is rounded by a large part of a step.
#[test]
fn a_jump_in_single_precision_is_found_once() {
    #[hamiltonian]
    fn spring(q: f32, p: f32) -> f32 {
        (p * p + q * q) / 2.0
    }
    for i in 0..30 {
        let start = State::at(0.0_f32, 1.0 + 0.01 * i as f32, 0.3);
        let mut sim = Spring.integrator(StormerVerlet, 0.1, start);
        let (mut jumps, end) = (0, 120.0);
        while sim.until_event(end, Direction::Any, |s| Real::signum(s.q)).unwrap().is_some() {
            jumps += 1;
            assert!(jumps < 100, "{start:?}");
        }
        // Half a period is 3.14.
        assert!((37..=39).contains(&jumps), "{jumps} from {start:?}");
    }
}
