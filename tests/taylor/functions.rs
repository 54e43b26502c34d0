//! Event functions: zeros behind a kink, a jump or a pole, flat zeros, other scalars, and invalid input.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::scalar::Real;
use std::f64::consts::PI;

#[hamiltonian]
fn oscillator(q: f64, p: f64) -> f64 {
    (p * p + q * q) / 2.0
}

/// 1/q changes its sign at a pole, which is not a zero. A jump through zero counts as a zero, for any height. A triple zero is found up to rounding.
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

/// (t − 0.02)/(t − 0.05) falls through zero and rises at a pole, within one step.
#[test]
fn a_zero_next_to_a_pole() {
    let mut sim = Oscillator.integrator(RK4, 0.1, State::new(1.0, 0.0));
    let found: Vec<_> = sim.crossings(Direction::Any, |s| (s.t - 0.02) / (s.t - 0.05)).until(1.0).collect();
    assert!(matches!(found[..], [Ok(c)] if (c.state.t - 0.02).abs() < 1e-12 && !c.rises), "{found:?}");
}

/// Functions whose series end before a step, and functions with another series behind a kink or a jump.
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
    // A pole is not a zero.
    let state = State::new(1.0, 0.3);
    let zero = 0.5 * PI + 0.3_f64.atan();
    let mut sim = Oscillator.taylor(Taylor::default(), state);
    check(sim.crossings(Direction::Any, |s| s.q / s.p).until(7.0).map(times).collect(), &[zero, zero + PI]);
    let mut sim = Oscillator.integrator(Gauss::<6>, 0.1, state);
    check(sim.crossings(Direction::Any, |s| s.q / s.p).until(7.0).map(times).collect(), &[zero, zero + PI]);
    // √q ends with zero at π/2, and is undefined afterwards.
    let mut sim = run();
    let all: Vec<_> = sim.crossings(Direction::Any, |s| s.q.sqrt()).take(3).collect();
    assert!(
        matches!(all.last(), Some(Err(StepError { t, failure: Failure::NoEvent, .. })) if (t - 0.5 * PI).abs() < 1e-9),
        "{all:?}"
    );
}

/// q·|q| is flat at q = 0, and its series on one side does not describe the other side. Each zero is found once, at the right time, also with steps of
/// fixed length.
#[test]
fn flat_zeros_behind_a_kink() {
    macro_rules! check {
        ($($method:expr),*) => { $(
            let mut sim = Oscillator.taylor($method, State::new(1.0, 0.0));
            let found = sim.crossings(Direction::Any, |s| s.q * s.q.abs()).until(40.0);
            let found: Vec<(f64, bool)> = found.map(|c| c.map(|c| (c.state.t, c.rises)).unwrap()).collect();
            assert_eq!(found.len(), 13, "{}: {found:?}", stringify!($method));
            for (n, (t, rises)) in found.iter().enumerate() {
                let gap = t - PI * (0.5 + n as f64);
                // Bound: q² exceeds eight roundings of its terms, which are below 10.
                assert!(gap.abs() < 2e-7 && *rises == (n % 2 == 1), "{}: event {n} is off by {gap:e}", stringify!($method));
            }
        )* };
    }
    check!(
        Taylor::default(),
        Taylor { tolerance: 1e-9 },
        TaylorFixed::<20> { h: 0.1 },
        TaylorFixed::<20> { h: 0.3 },
        TaylorFixed::<20> { h: 0.07 }
    );
}

#[test]
fn input_that_is_none() {
    every_run!(Oscillator, State::new(1.0, 0.0), 0.1, |sim| {
        for t in [f64::NAN, f64::INFINITY] {
            let first = sim.crossings(Direction::Any, |s| s.q * t).next();
            assert!(matches!(first, Some(Err(StepError { failure: Failure::NoEvent, .. }))), "{first:?}");
        }
        assert!(matches!(
            sim.until_event(f64::NAN, Direction::Any, |s| s.q),
            Err(StepError { failure: Failure::InvalidStepSize { .. }, .. })
        ));
        // Products of such small values underflow to zero.
        sim.set_state(State::new(1.0, 0.0));
        let first = sim.crossings(Direction::Any, |s| s.q * 1e-300).next().unwrap().unwrap();
        assert!((first.state.t - 0.5 * PI).abs() < 1e-6, "{}", first.state.t);
        sim.advance(2).unwrap();
        sim.set_state(State::new(f64::NAN, 0.0));
        assert!(matches!(sim.step(), Err(StepError { failure: Failure::NonFiniteState, .. })));
        sim.set_state(State::at(f64::NAN, 1.0, 0.0));
        assert!(matches!(sim.step(), Err(StepError { failure: Failure::NonFiniteState, .. })));
        sim.set_state(State::new(1.0, 0.0));
        sim.step().unwrap();
    });
    // Steps of fixed length lead in the other direction.
    let mut sim = Oscillator.integrator(RK4, 0.1, State::new(1.0, 0.0));
    assert!(matches!(
        sim.until_event(-1.0, Direction::Any, |s| s.q),
        Err(StepError { t: -1.0, failure: Failure::TimePassed, .. })
    ));
    let all: Vec<_> = sim.sampled_every(-0.1).collect();
    assert!(matches!(all[..], [Ok(_), Err(StepError { failure: Failure::TimePassed, .. })]), "{all:?}");
}

/// The function changes its sign between the ends of a step and is a NaN in between. The time of the event is unknown, so the search is refused.
#[test]
fn what_is_no_number_within_a_step_is_refused() {
    let gap = |t: f64| if (1.2..1.4).contains(&t) { f64::NAN } else { t - 1.3 };
    let mut sim = Oscillator.integrator(RK4, 0.5, State::new(1.0, 0.0));
    let all: Vec<_> = sim.crossings(Direction::Any, |s| gap(s.t)).until(5.0).collect();
    assert!(
        matches!(all[..], [Err(StepError { t, failure: Failure::NoEvent, .. })] if (1.2..1.4).contains(&t)),
        "{all:?}"
    );
}

/// Functions of events are written like functions of numbers, in single precision, too.
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

/// Steps end at a condition of the energy, and an event coincides with the condition. The event is found once, whatever the rounding at the joint is. The
/// step may be as short as rounding permits.
#[test]
fn events_at_the_joints_of_steps() {
    #[hamiltonian]
    fn wall(q: f32, p: f32, k: f32) -> f32 {
        p * p / 2.0 + q + if q < 0.0 { k * q * q / 2.0 } else { 0.0 }
    }
    for k in [1.0_f32, 100.0] {
        for start in [0.5_f32, 0.53, 0.8, 1.0, 1.1] {
            let mut sim = Wall { k }.taylor(Taylor::default(), State::new(start, 0.1));
            let found = sim.crossings(Direction::Any, |s| s.q).until(20.0).take(100);
            let found: Vec<(f32, bool)> = found.map(|c| c.map(|c| (c.state.t, c.rises)).unwrap()).collect();
            // The distance is half an oscillation, or a flight.
            let apart = |w: &[(f32, bool)]| w[1].0 - w[0].0 > f32::min(3.0 / k.sqrt(), 1.9) && w[0].1 != w[1].1;
            assert!(found.len() >= 5 && !found[0].1 && found.windows(2).all(apart), "{k} {start}: {found:?}");
        }
    }
}
