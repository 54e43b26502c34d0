//! Limits of series: poles, collisions, polynomials, conditions.

use geoint_runtime::Failure;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// x' = x² has x = 1/(1/x₀ − t).
#[vector_field]
fn pole(x: [f64; 1]) -> [f64; 1] {
    [x[0] * x[0]]
}

#[test]
fn a_pole_is_reached_and_not_passed() {
    for start in [0.3, 1.0, 7.0] {
        let end = 1.0 / start;
        let mut sim = Pole.taylor(Taylor::default(), FlowState::new([start]));
        let error = sim.advance_to(2.0 * end).unwrap_err();
        assert!(matches!(error, StepError { failure: Failure::Diverges, .. }), "{error}");
        assert!(sim.time() < end && end - sim.time() < 1e-12 * end, "{:e}", end - sim.time());
        let x = sim.state().x[0];
        assert!(x.is_finite() && x > 1e10);
        // The state is kept.
        assert!(sim.step().is_err());
        assert_eq!(sim.state().x[0], x);
    }
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
        assert!(error.is_shortest(), "{error}");
        assert!(sim.time() < 1.0 && 1.0 - sim.time() < 1e-12, "{:e}", 1.0 - sim.time());
    }
    // A large tolerance does not permit a jump over a pole.
    let mut sim = InTime.taylor(Taylor { tolerance: 0.99 }, FlowState::new([1.0]));
    assert!(sim.advance_to(2.0).is_err() && sim.time() < 1.0);
}

#[hamiltonian]
fn falling_together(q: f64, p: f64) -> f64 {
    p * p / 2.4 - 1.0 / q
}

#[test]
fn a_collision() {
    let mut sim = FallingTogether.taylor(Taylor::default(), State::new(1.0, 0.0));
    // The collision time is t = π/2·√(m/2)·q₀^(3/2) for an attraction 1/q and the mass m = 1.2.
    let end = std::f64::consts::FRAC_PI_2 * (0.6_f64).sqrt();
    let error = sim.advance_to(2.0).unwrap_err();
    assert!(error.is_shortest(), "{error}");
    assert!((sim.time() - end).abs() < 1e-12, "{:e}", sim.time() - end);
}

#[hamiltonian]
fn free_fall(q: f64, p: f64, m: f64, g: f64) -> f64 {
    p * p / (2.0 * m) + m * g * q
}

#[test]
fn polynomials_have_no_end() {
    let system = FreeFall { m: 2.3, g: 9.81 };
    let mut sim = system.taylor(Taylor::default(), State::new(1.0, 0.0));
    sim.advance_to(3.0).unwrap();
    assert_eq!(sim.steps(), 1);
    assert!((sim.state().q - (1.0 - 9.81 * 4.5)).abs() < 1e-14 * 43.0);
    // A body at rest without a force, and steps without a requested end.
    for state in [State::new(0.0, 0.0), State::new(1.0, 0.0)] {
        let mut sim = FreeFall { m: 2.3, g: 0.0 }.taylor(Taylor::default(), state);
        sim.advance(10).unwrap();
        assert_eq!((sim.state().q, sim.state().p), (state.q, state.p));
    }
    let mut sim = system.taylor(Taylor::default(), State::new(0.0, 0.0));
    sim.advance(3).unwrap();
    let t = sim.time();
    assert!(t > 0.5 && (sim.state().q + 9.81 * t * t / 2.0).abs() < 1e-14 * t * t * 9.81, "{t}");
}

/// A force that wakes up: zero to order 30 at t = 0.
#[hamiltonian]
fn waking(q: f64, p: f64, t: f64) -> f64 {
    p * p / 2.6 - q * t.powi(30)
}

#[test]
fn a_force_that_is_zero_at_first() {
    let mut sim = Waking.taylor(Taylor::default(), State::new(0.0, 0.0));
    sim.advance_to(2.0).unwrap();
    let exact = 2.0_f64.powi(31) / 31.0;
    assert!((sim.state().p / exact - 1.0).abs() < 1e-13, "{}", sim.state().p / exact - 1.0);
}

/// A spring on one side, a stiffer one on the other.
#[hamiltonian]
fn two_springs(q: f64, p: f64) -> f64 {
    p * p / 2.0 + if q > 0.0 { q * q / 2.0 } else { 2.0 * q * q }
}

/// q'' = −sgn q/m: parabolas.
#[hamiltonian]
fn wedge(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.abs()
}

#[test]
fn a_step_ends_where_a_condition_changes() {
    use std::f64::consts::PI;
    // Half a period of 2π, and half a period of π.
    for periods in [1, 10] {
        let mut sim = TwoSprings.taylor(Taylor::default(), State::new(1.0, 0.0));
        sim.advance_to(1.5 * PI * f64::from(periods)).unwrap();
        let end = sim.state();
        let tolerance = 3e-15 * f64::from(periods);
        assert!((end.q - 1.0).abs() < tolerance && end.p.abs() < tolerance, "{end:?}");
        assert!((sim.energy() - 0.5).abs() < tolerance);
    }
    // Starts on the condition, in both directions.
    for p in [1.0, -1.0] {
        let mut sim = TwoSprings.taylor(Taylor::default(), State::new(0.0, p));
        sim.advance_to(1.5 * PI).unwrap();
        assert!(sim.state().q.abs() < 4e-15 && (sim.state().p - p).abs() < 4e-15, "{:?}", sim.state());
    }
    // A quarter of a period is √(2m).
    let mut sim = Wedge { m: 1.7 }.taylor(Taylor::default(), State::new(1.0, 0.0));
    sim.advance_to(4.0 * (2.0 * 1.7_f64).sqrt()).unwrap();
    assert!((sim.state().q - 1.0).abs() < 1e-14 && sim.state().p.abs() < 1e-14, "{:?}", sim.state());
}

/// Dry friction, which holds what is slow: −0.5 sgn v beside a force of 0.2.
#[vector_field]
fn friction(x: [f64; 1]) -> [f64; 1] {
    [0.2 - 0.5 * x[0].signum()]
}

#[test]
fn what_slides_along_a_condition_is_refused() {
    let mut sim = Friction.taylor(Taylor::default(), FlowState::new([1.0]));
    let error = sim.advance_to(10.0).unwrap_err();
    assert!(matches!(error, StepError { failure: Failure::Sliding, .. }), "{error}");
    assert!((sim.time() - 1.0 / 0.3).abs() < 1e-12, "{}", sim.time());
}

#[test]
fn lower_precision() {
    #[hamiltonian]
    fn single(q: f32, p: f32) -> f32 {
        p * p / 2.0 - q.cos()
    }
    let mut sim = Single.taylor(Taylor::default(), State::new(1.5, 0.0));
    sim.advance_to(10.0).unwrap();
    assert!((sim.state().q + 1.054_049_2).abs() < 1e-6);
}

#[test]
fn output_of_every_run() {
    let mut sim = FreeFall { m: 1.0, g: 1.0 }.taylor(TaylorFixed::<4> { h: -0.25 }, State::new(0.0, 1.0));
    let states: Result<Vec<_>, _> = sim.until(-1.1).collect();
    let times: Vec<f64> = states.unwrap().iter().map(|state| state.t).collect();
    assert_eq!(times, [-0.25, -0.5, -0.75, -1.0, -1.1]);
    let mut sim = Wedge { m: 1.7 }.taylor(TaylorOrder::<6> { tolerance: 1e-6 }, State::new(1.0, 0.0));
    assert_eq!(sim.sampled(3).take(5).filter(Result::is_ok).count(), 5);
    assert_eq!(sim.states_at([10.0, 20.0]).map(|state| state.unwrap().t).collect::<Vec<_>>(), [10.0, 20.0]);
}

/// |q|^2.5 has two derivatives at q = 0, and (x² + y²)^1.5, and no series.
#[hamiltonian]
fn rough(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.abs().powf(2.5)
}

#[hamiltonian]
fn rough_centre(q: [f64; 2], p: [f64; 2], m: f64, w: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + (q[0] * q[0] + q[1] * q[1]).powf(w)
}

/// If a series ends at a power, the error names the power.
#[test]
fn a_power_that_has_no_series_is_named() {
    let named = |outcome: Result<(), StepError>, term: &str| match outcome {
        Err(StepError { failure: Failure::OutsideDomain { what }, .. }) => {
            assert!(
                what.starts_with("a power has no Taylor series where it vanishes") && what.contains(term),
                "{what}"
            );
        }
        outcome => panic!("{outcome:?}"),
    };
    let system = Rough { m: 1.3 };
    // The run starts at rest on this point, in motion, or on the way to it.
    for start in [State::new(0.0, 0.0), State::new(0.0, 0.3), State::new(1.0, 0.0), State::new(-1.0, 0.2)] {
        let mut sim = system.taylor(Taylor::default(), start);
        named(sim.advance_to(10.0), "abs(q)^(5/2)");
        assert!(sim.state().q.abs() < 1e-12, "{:?}", sim.state());
    }
    named(system.taylor(TaylorFixed::<8> { h: 0.1 }, State::new(0.0, 0.3)).step(), "abs(q)^(5/2)");
    let system = RoughCentre { m: 1.3, w: 1.6 };
    named(system.taylor(Taylor::default(), State::new([0.0; 2], [0.0, 0.3])).step(), "q[0]²");
    // Elsewhere the series continue.
    let mut sim = system.taylor(Taylor::default(), State::new([1.0, 0.0], [0.0, 0.3]));
    let energy = sim.energy();
    sim.advance_to(10.0).unwrap();
    assert!((sim.energy() - energy).abs() < 1e-14);
}
