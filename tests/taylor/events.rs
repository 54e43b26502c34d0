//! Events where they are hard to see: at the start and at the end of a search, two within a step, behind a kink or a pole, in small units; and
//! input that is none.

use geoint_runtime::prelude::*;
use geoint_runtime::scalar::Real;
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

/// Runs that search in different ways.
macro_rules! every_run {
    ($system:expr, $state:expr, $h:expr, |$sim:ident| $body:expr) => {
        every_run!($system, $state, $h, 1e-13, |$sim| $body)
    };
    ($system:expr, $state:expr, $h:expr, $tolerance:expr, |$sim:ident| $body:expr) => {{
        let mut $sim = $system.taylor(Taylor::default(), $state);
        $body;
        let mut $sim = $system.taylor(TaylorFixed::<12> { h: $h }, $state);
        $body;
        let mut $sim = $system.integrator(Gauss::<3>, $h, $state);
        $body;
        let mut $sim = $system.adaptive(DOP853, $tolerance, $state);
        $body;
    }};
}

/// A search goes on from the event at which the one before has ended, and does not find it again, on whichever side of zero it is.
#[test]
fn one_event_after_the_other() {
    for sign in [1.0, -1.0] {
        every_run!(Oscillator, State::new(1.0, 0.0), sign * 0.1, |sim| {
            for n in 0..6 {
                let found = sim.until_event(sign * 100.0, Direction::Any, |s| s.q).unwrap().unwrap();
                assert!((found.state.t - sign * PI * (n as f64 + 0.5)).abs() < 1e-6, "{n}: {}", found.state.t / PI);
            }
        });
        // Of 10⁶ the tolerance of a step is 10⁻⁸.
        every_run!(Far, State::new(1e6 + 1.0, 0.0), sign * 0.1, 1e-14, |sim| {
            for n in 0..6 {
                let found = sim.until_event(sign * 100.0, Direction::Any, |s| s.q - 1e6).unwrap().unwrap();
                assert!((found.state.t - sign * PI * (n as f64 + 0.5)).abs() < 1e-5, "{n}: {}", found.state.t / PI);
            }
        });
    }
}

/// The same from many starts: what is left of a coordinate at an event is rounding, of either sign, and says nothing of how fast the state changes.
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

/// What is left of the search after an event may be short: the event is known no better for that.
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

/// 1/q changes sign at a pole: that is no zero. A jump is one, however high, and of a triple zero is found what rounding leaves.
#[test]
fn poles_jumps_and_flat_zeros() {
    let run = || Oscillator.taylor(Taylor::default(), State::new(1.0, 0.0));
    assert!(run().crossings(Direction::Any, |s| s.q.recip()).until(100.0).next().is_none());
    assert_eq!(run().crossings(Direction::Any, |s| s.p / s.q).until(100.0).count(), 31);
    let mut sim = run();
    let jumps = sim.crossings(Direction::Any, |s| (s.p * s.p * 1000.0 + 0.001) * s.q.signum());
    assert_eq!(jumps.until(100.0).count(), 32);
    for found in run().crossings(Direction::Any, |s| s.q * s.q * s.q).until(100.0) {
        let q = found.unwrap().state.q;
        assert!(q.abs() < 2e-5, "{q:e}");
    }
}

/// A function that is zero all along has no events also where the search has an end; one that is not zero all along has.
#[test]
fn zero_until_the_end() {
    every_run!(Oscillator, State::new(1.0, 0.0), 0.1, |sim| {
        let first = sim.crossings(Direction::Any, |s| s.q * 0.0).until(7.0).next();
        assert!(matches!(first, Some(Err(StepError::NoEvent { .. }))), "{first:?}");
        assert!((6.8..=7.0).contains(&sim.time()), "{}", sim.time());
        // Only one of them, and only in the end.
        let before = sim.time();
        let found: Vec<_> = sim.crossings(Direction::Any, |s| [s.q * 0.0, s.q]).until(14.0).collect();
        assert!(found.len() == 2 && found.iter().all(Result::is_ok), "{before}: {found:?}");
        // Nothing is left to be searched.
        let end = sim.time();
        assert_eq!(sim.until_event(end, Direction::Any, |s| s.q * 0.0), Ok(None));
    });
}

/// A zero at the end of one search is found once: not by none, and not by the next one, too.
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
    // Several at once, at the end of a step; the direction of a run with steps back in time, before the first of them.
    let mut sim = Uniform.taylor(TaylorFixed::<6> { h: -0.25 }, FlowState::new([0.0; 2]));
    let all = sim.crossings(Direction::Down, |s| [s.x[0] + 1.0, s.x[0] + 0.75, s.x[0] + 1.0]).take(3);
    let all: Vec<(f64, usize)> = all.map(|c| c.map(|c| (c.state.t, c.which)).unwrap()).collect();
    assert_eq!(all, [(-0.75, 1), (-1.0, 0), (-1.0, 2)]);
}

/// q = sin t is above 1 − e for 2√(2e): shorter than a step.
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
                // What moves the top by 10⁻¹⁰ moves these by that over √e.
                assert!(gap.abs() < 1e-6 + 1e-9 / e.sqrt() && crossing.rises == (n % 2 == 0), "{e}: {gap:e}");
            }
        });
    }
    // It only touches, or not even that.
    for top in [1.0 + 1e-7, 1.5] {
        every_run!(Oscillator, State::new(0.0, 1.0), 0.3, |sim| {
            assert_eq!(sim.crossings(Direction::Any, |s| s.q - top).until(18.0).count(), 0, "{top}");
        });
    }
}

/// Flights that are shorter than a step, down to 10⁻⁶ of it; q is left as it is found, at rounding on either side of the ground.
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

/// Functions whose series end before a step does, and those that have another one behind a kink or a jump.
#[test]
fn functions_that_are_no_polynomials() {
    let run = || Oscillator.taylor(Taylor::default(), State::new(1.0, 0.0));
    let check = |found: Vec<f64>, exact: &[f64]| {
        assert_eq!(found.len(), exact.len(), "{found:?} {exact:?}");
        for (found, exact) in found.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
    };
    let times = |c: Result<geoint_runtime::Crossing<State<f64>>, StepError>| c.unwrap().state.t;
    let third = PI / 3.0;
    let mut sim = run();
    check(
        sim.crossings(Direction::Any, |s| s.q.abs() - 0.5).until(7.0).map(times).collect(),
        &[1.0, 2.0, 4.0, 5.0].map(|n| n * third),
    );
    let at = ((-2.0_f64).exp() - 1.01).acos();
    let mut sim = run();
    check(
        sim.crossings(Direction::Any, |s| (s.q + 1.01).ln() + 2.0).until(7.0).map(times).collect(),
        &[at, 2.0 * PI - at],
    );
    let mut sim = run();
    check(sim.crossings(Direction::Any, |s| Real::signum(s.q)).until(7.0).map(times).collect(), &[0.5 * PI, 1.5 * PI]);
    // A pole is no zero.
    let state = State::new(1.0, 0.3);
    let zero = 0.5 * PI + 0.3_f64.atan();
    let mut sim = Oscillator.taylor(Taylor::default(), state);
    check(sim.crossings(Direction::Any, |s| s.q / s.p).until(7.0).map(times).collect(), &[zero, zero + PI]);
    let mut sim = Oscillator.integrator(Gauss::<6>, 0.1, state);
    check(sim.crossings(Direction::Any, |s| s.q / s.p).until(7.0).map(times).collect(), &[zero, zero + PI]);
    // √q is no number from π/2 on, where it ends with zero.
    let mut sim = run();
    let all: Vec<_> = sim.crossings(Direction::Any, |s| s.q.sqrt()).take(3).collect();
    assert!(matches!(all.last(), Some(Err(StepError::NoEvent { t })) if (t - 0.5 * PI).abs() < 1e-9), "{all:?}");
}

#[test]
fn input_that_is_none() {
    every_run!(Oscillator, State::new(1.0, 0.0), 0.1, |sim| {
        for t in [f64::NAN, f64::INFINITY] {
            let first = sim.crossings(Direction::Any, |s| s.q * t).next();
            assert!(matches!(first, Some(Err(StepError::NoEvent { .. }))), "{first:?}");
        }
        assert!(matches!(sim.until_event(f64::NAN, Direction::Any, |s| s.q), Err(StepError::InvalidStepSize { .. })));
        // Products of such values are zero.
        sim.set_state(State::new(1.0, 0.0));
        let first = sim.crossings(Direction::Any, |s| s.q * 1e-300).next().unwrap().unwrap();
        assert!((first.state.t - 0.5 * PI).abs() < 1e-6, "{}", first.state.t);
        sim.advance(2).unwrap();
        sim.set_state(State::new(f64::NAN, 0.0));
        assert!(matches!(sim.step(), Err(StepError::NonFiniteState { .. })));
        sim.set_state(State::at(f64::NAN, 1.0, 0.0));
        assert!(matches!(sim.step(), Err(StepError::NonFiniteState { .. })));
        sim.set_state(State::new(1.0, 0.0));
        sim.step().unwrap();
    });
    // Steps of one length lead the other way.
    let mut sim = Oscillator.integrator(RK4, 0.1, State::new(1.0, 0.0));
    assert!(matches!(sim.until_event(-1.0, Direction::Any, |s| s.q), Err(StepError::TimePassed { t: -1.0 })));
    let all: Vec<_> = sim.sampled_every(-0.1).collect();
    assert!(matches!(all[..], [Ok(_), Err(StepError::TimePassed { .. })]), "{all:?}");
}

/// Where a function changes sign from one end of a step to the other and is no number in between nobody knows when.
#[test]
fn what_is_no_number_within_a_step_is_refused() {
    let gap = |t: f64| if (1.2..1.4).contains(&t) { f64::NAN } else { t - 1.3 };
    let mut sim = Oscillator.integrator(RK4, 0.5, State::new(1.0, 0.0));
    let all: Vec<_> = sim.crossings(Direction::Any, |s| gap(s.t)).until(5.0).collect();
    assert!(matches!(all[..], [Err(StepError::NoEvent { t })] if (1.2..1.4).contains(&t)), "{all:?}");
}

/// A pole in time, which rates near it feel by the rounding of time.
#[vector_field]
fn in_time(x: [f64; 1], t: f64) -> [f64; 1] {
    [x[0] + 1.0 / (1.0 - t)]
}

#[test]
fn a_pole_in_time_is_reached() {
    for tolerance in [f64::EPSILON, 1e-9] {
        let mut sim = InTime.taylor(Taylor { tolerance }, FlowState::new([1.0]));
        let error = sim.advance_to(2.0).unwrap_err();
        assert!(matches!(error, StepError::StepTooSmall { .. }), "{error}");
        assert!(sim.time() < 1.0 && 1.0 - sim.time() < 1e-12, "{:e}", 1.0 - sim.time());
    }
    // A tolerance that asks for nothing is no leave to jump over a pole.
    let mut sim = InTime.taylor(Taylor { tolerance: 0.99 }, FlowState::new([1.0]));
    assert!(sim.advance_to(2.0).is_err() && sim.time() < 1.0);
}

/// In single precision an event at which a search ends is not found again either.
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

/// Functions of events are written as for numbers, in single precision too.
#[test]
fn functions_as_for_numbers() {
    #[hamiltonian]
    fn single(q: f32, p: f32) -> f32 {
        (p * p + q * q) / 2.0
    }
    let mut sim = Single.taylor(Taylor::default(), State::new(1.0, 0.0));
    let found = sim.crossings(Direction::Down, |s| 2.0 * s.q.sin() - 0.6).next().unwrap().unwrap();
    assert!((found.state.q - 0.3_f32.asin()).abs() < 1e-6, "{found:?}");
    let mut sim = Oscillator.taylor(Taylor::default(), State::new(1.0, 0.0));
    let g = |s: &State<geoint_runtime::scalar::Series<f64, 20>>| (s.q + 2.0).powf(1.5) - (s.q * 0.0 + 0.25).recip();
    let found = sim.crossings(Direction::Down, g).next().unwrap().unwrap();
    assert!((found.state.q - (4.0_f64.powf(2.0 / 3.0) - 2.0)).abs() < 1e-15, "{found:?}");
}
