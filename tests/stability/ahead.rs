//! Barriers and pulses ahead of a run. A long step detects them, although the force vanishes at the start of the step.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A hill of height 1; a body of energy 1/2 is reflected.
#[hamiltonian]
fn hill(q: f64, p: f64, w: f64, c: f64) -> f64 {
    p * p / 2.0 + (-((q - c) / w).powi(2)).exp()
}

/// A pulse in time: it gives a momentum of a·w·√π.
#[hamiltonian]
fn pulse(q: f64, p: f64, t: f64, a: f64, c: f64, w: f64) -> f64 {
    p * p / 2.0 - a * (-((t - c) / w).powi(2)).exp() * q
}

/// The hill with friction that is too weak to stop the body.
#[contact_hamiltonian]
fn hill_with_friction(q: f64, p: f64, s: f64, w: f64, gamma: f64) -> f64 {
    p * p / 2.0 + (-(q / w).powi(2)).exp() + gamma * s
}

/// The hill in single precision.
#[hamiltonian]
fn single_hill(q: f32, p: f32, w: f32) -> f32 {
    p * p / 2.0 + (-(q / w).powi(2)).exp()
}

/// Asserts that a hill reflects free flights. They start 12, 30 or 100 widths away and last 1.5, 3 or 10 times the way to the hill.
macro_rules! reflected {

    (|$w:ident, $start:ident| $($run:expr),*) => {
        for $w in [0.01, 0.1, 1.0, 10.0] {
            for widths in [12.0, 30.0, 100.0] {
                for times in [1.5, 3.0, 10.0] {
                    let $start = State::new(-widths * $w, 1.0);
                    $( {
                        let mut run = $run;
                        assert_eq!(run.advance_to(times * widths * $w), Ok(()), "{} {} {widths}", stringify!($run), $w);
                        let p = run.state().p;
                        assert!((p + 1.0).abs() < 1e-2, "{} w = {} from {widths} w to {times}: {p}", stringify!($run), $w);
                    } )*
                }
            }
        }
    };
}

#[test]
fn taylor_series_are_reflected_by_hills() {
    reflected!(
        |w, start| Hill { w, c: 0.0 }.taylor(Taylor::default(), start),
        Hill { w, c: 0.0 }.taylor(Taylor { tolerance: 1e-6 }, start),
        Hill { w, c: 0.0 }.taylor(Projection(Taylor::default(), Energy), start)
    );
}

#[test]
fn adaptive_steps_are_reflected_by_hills() {
    reflected!(
        |w, start| Hill { w, c: 0.0 }.adaptive(DOP853, 1e-6, start),
        Hill { w, c: 0.0 }.adaptive(DOP853, 1e-9, start),
        Hill { w, c: 0.0 }.adaptive(Gauss::<3>, 1e-9, start),
        Hill { w, c: 0.0 }.adaptive(BlanesMoanSrkn14a, 1e-9, start),
        Hill { w, c: 0.0 }.adaptive(BlanesMoan6, 1e-9, start),
        Hill { w, c: 0.0 }.adaptive(DiscreteGradient, 1e-5, start)
    );
}

#[test]
fn no_event_is_found_behind_a_hill() {
    let mut run = Hill { w: 1.0, c: 0.0 }.taylor(Taylor::default(), State::new(-12.0, 1.0));
    assert!(run.until_event(36.0, Direction::Up, |state| state.q).expect("all steps are taken").is_none());
}

#[test]
fn contact_runs_and_single_precision_are_reflected() {
    let start = ContactState::new(-30.0, 1.0, 0.0);
    let system = HillWithFriction { w: 1.0, gamma: 1e-4 };
    let mut run = system.taylor(Taylor::default(), start);
    assert_eq!(run.advance_to(90.0), Ok(()));
    assert!(run.state().p < -0.9, "{:?}", run.state());
    let mut run = system.adaptive(DOP853, 1e-9, start);
    assert_eq!(run.advance_to(90.0), Ok(()));
    assert!(run.state().p < -0.9, "{:?}", run.state());
    let mut run = SingleHill { w: 1.0 }.adaptive(DOP853, 1e-5, State::new(-40.0, 1.0));
    assert_eq!(run.advance_to(120.0), Ok(()));
    assert!(run.state().p < -0.9, "{:?}", run.state());
}

#[test]
fn pulses_are_felt() {
    for (c, w) in [(10.0, 1.0), (10.0, 0.1), (1.0, 0.1), (1.0, 0.01)] {
        for p in [0.0, 0.3] {
            let (system, expected) = (Pulse { a: 1.0, c, w }, p + w * core::f64::consts::PI.sqrt());
            let start = State::new(0.0, p);
            macro_rules! rows {
                ($($bound:literal $run:expr),*) => { $( {
                    let mut run = $run.steps_at_most(10_000);
                    assert_eq!(run.advance_to(2.0 * c), Ok(()), "{} {c} {w} {p}", stringify!($run));
                    let error = (run.state().p - expected).abs();
                    assert!(error < $bound, "{} c = {c}, w = {w}, p = {p}: {error:.1e}", stringify!($run));
                } )* };
            }
            rows!(
                1e-13 system.taylor(Taylor::default(), start),
                1e-6 system.adaptive(DOP853, 1e-9, start),
                1e-6 system.adaptive(BlanesMoanSrkn14a, 1e-9, start),
                1e-6 system.adaptive(BlanesMoan6, 1e-9, start)
            );
        }
    }
}

/// At q = 0 the coordinate has no size, so the size cannot give a time scale of the motion.
#[test]
fn series_that_begin_at_zero_feel_pulses() {
    for w in [0.5, 0.2, 0.05] {
        for v in [0.0, 0.321, -0.321] {
            for c in [3.1, 5.42, 7.9] {
                let mut run = Pulse { a: 1.0, c, w }.taylor(Taylor::default(), State::new(0.0, v));
                assert_eq!(run.advance_to(12.0), Ok(()));
                let gained = run.state().p - v;
                let error = (gained - w * std::f64::consts::PI.sqrt()).abs();
                assert!(error < 1e-12, "w = {w}, v = {v}, c = {c}: {gained}");
            }
        }
    }
}

/// A run without a bound on steps passes a hill that is narrower than the distance of all evaluations. A bound on the step reveals the hill.
#[test]
fn a_bound_on_steps_shows_what_is_too_narrow_to_be_seen() {
    let (system, start) = (Hill { w: 1e-4, c: 1.0 }, State::new(-9.0, 1.0));
    let mut run = system.adaptive(DOP853, 1e-6, start);
    assert_eq!(run.advance_to(20.0), Ok(()));
    assert!(run.state().p > 0.9, "{:?}", run.state());
    let mut run = system.adaptive(DOP853, 1e-6, start).longest_step(1e-4);
    assert_eq!(run.advance_to(20.0), Ok(()));
    assert!(run.state().p < -0.9, "{:?}", run.state());
    let mut run = system.taylor(Taylor::default(), start).longest_step(1e-3);
    assert_eq!(run.advance_to(20.0), Ok(()));
    assert!(run.state().p < -0.9, "{:?}", run.state());
}

/// A free flight without an obstacle ahead takes few steps. The search for obstacles does not shorten them.
#[test]
fn free_flights_take_few_steps() {
    let system = Pulse { a: 0.0, c: 0.0, w: 1.0 };
    let mut run = system.taylor(Taylor::default(), State::new(1.0, 1.0));
    assert_eq!(run.advance_to(1e6), Ok(()));
    assert!(run.steps() < 30 && (run.state().q - 1e6 - 1.0).abs() < 1e-8, "{} {:?}", run.steps(), run.state());
    let mut run = system.adaptive(DOP853, 1e-9, State::new(1.0, 1.0));
    assert_eq!(run.advance_to(1e6), Ok(()));
    assert!(run.steps() < 40, "{}", run.steps());
}
