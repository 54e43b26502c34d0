//! Runs that meet a condition again and again. Runs that come to rest at it, or bounce ever lower, are refused. Other runs continue.

use geoint_runtime::Failure;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A wedge at c.
#[hamiltonian]
fn wedge(q: f64, p: f64, m: f64, k: f64, c: f64) -> f64 {
    p * p / (2.0 * m) + k * (q - c).abs()
}

/// The same with friction.
#[contact_hamiltonian]
fn rubbed(q: f64, p: f64, s: f64, k: f64, g: f64, c: f64) -> f64 {
    p * p / 2.0 + k * (q - c).abs() + g * s
}

/// Dry friction in a wedge: bounces become shorter by a constant factor.
#[vector_field]
fn dry(x: [f64; 2], k: f64, f: f64, c: f64) -> [f64; 2] {
    [x[1], -k * (x[0] - c).signum() - f * x[1].signum()]
}

/// Led to a corner along one of two lines, or both.
#[vector_field]
fn corner(x: [f64; 2], a: f64) -> [f64; 2] {
    [-x[0].signum(), -a * x[1].signum()]
}

/// Wedges side by side, and a spring.
#[hamiltonian]
fn wedges(q: [f64; 24], p: [f64; 24], k: f64) -> f64 {
    let mut sum = 0.0;
    for i in 0..24 {
        sum += p[i] * p[i] / 2.0 + k * q[i].abs();
    }
    sum
}

#[hamiltonian]
fn beside(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + k * q[0].abs() + q[1] * q[1] / 2.0
}

fn slides(outcome: &Result<(), StepError>) -> bool {
    matches!(outcome, Err(StepError { failure: Failure::Sliding, .. }))
}

/// A body rests at the minimum, in three unit systems, at nonzero times, and at places away from zero.
#[test]
fn what_rests_at_a_wedge_is_refused() {
    for (k, m, c) in
        [(1.0, 1.3, 0.0), (1e-20, 1.0, 0.0), (1e20, 1e-6, 0.0), (1.0, 0.7, 1.0), (2.0, 1.0, -1e-3), (1.0, 1.0, 1e6)]
    {
        for t in [0.0, 1e3] {
            let start = State::at(t, c, 0.0);
            let mut sim = Wedge { k, m, c }.taylor(Taylor::default(), start).steps_at_most(1000);
            let outcome = sim.advance_to(2.0 * t + 1.0);
            assert!(slides(&outcome), "{k} {c} {t}: {outcome:?} after {} steps", sim.steps());
            assert!(
                (sim.state().q - c).abs() <= 1e-15 * (c.abs() + k / m) && sim.time() - t < 1e-2,
                "{:?}",
                sim.state()
            );
            assert!(outcome.unwrap_err().to_string().contains("does not leave the place"));
        }
        let mut sim = Wedge { k, m, c }.taylor(TaylorFixed::<8> { h: 0.1 }, State::new(c, 0.0)).steps_at_most(1000);
        assert!(slides(&sim.advance_to(1.0)), "{k} {c}");
    }
}

/// The body comes to rest at the time at which bounces accumulate.
#[test]
fn what_comes_to_rest_is_refused() {
    let most = 1_000_000;
    for c in [0.0, 1.0] {
        let mut sim =
            Dry { k: 1.0, f: 0.5, c }.taylor(Taylor::default(), FlowState::new([c + 1.0, 0.0])).steps_at_most(most);
        let outcome = sim.advance_to(100.0);
        // The fall from height 1 takes two units of time and ends with speed 1. Each bounce reduces the speed by the factor r. It takes v/(k + f) up and r
        // v/(k − f) down.
        let r = (1.0_f64 / 3.0).sqrt();
        let end = 2.0 + (1.0 / 1.5 + r / 0.5) / (1.0 - r);
        assert!(slides(&outcome), "{c}: {outcome:?} {}", sim.steps());
        assert!((sim.state().x[0] - c).abs() < 1e-12 && (sim.time() - end).abs() < 1e-5, "{:?}, {end}", sim.state());
    }
    // Strong friction stops the body at once.
    let mut sim =
        Dry { k: 1.0, f: 1.5, c: 1.0 }.taylor(Taylor::default(), FlowState::new([2.0, 1.0])).steps_at_most(most);
    assert!(slides(&sim.advance_to(100.0)) && sim.state().x[1].abs() < 1e-12, "{:?}", sim.state());
    for a in [1.0, 0.3] {
        let mut sim = Corner { a }.taylor(Taylor::default(), FlowState::new([1.0, 1.0])).steps_at_most(most);
        assert!(slides(&sim.advance_to(100.0)) && (sim.time() - 1.0).abs() < 1e-12, "{:?}", sim.state());
    }
}

/// Under friction like γp the n-th bounce takes a time like 1/n, so the bounces never end. After many of them the run returns an error. The user can
/// continue it.
#[test]
fn low_bounces_end_a_run() {
    let mut sim =
        Rubbed { k: 1.0, g: 3.0, c: 0.0 }.taylor(Taylor { tolerance: 1e-6 }, ContactState::new(1.0, 0.0, 0.0));
    let mut sim = {
        sim.advance_to(1.0).unwrap();
        sim.steps_at_most(2_000_000)
    };
    let outcome = sim.advance_to(100.0);
    assert!(slides(&outcome), "{outcome:?} after {} steps", sim.steps());
    assert!(sim.state().q.abs() < 1e-8 && sim.time() < 20.0, "{:?}", sim.state());
    let (t, steps) = (sim.time(), sim.steps());
    sim.advance(1000).unwrap();
    assert!(sim.time() > t && sim.steps() == steps + 1000);
}

/// Runs that continue are never refused. Cases: thousands of bounces, fast bounces in slow units, many conditions that change at once, a small motion
/// beside a large one.
#[test]
fn what_goes_on_does_so() {
    for (k, m) in [(1.0, 1.0), (1e20, 1e-3), (1e-12, 1e5)] {
        let period = 4.0 * (2.0_f64 * m / k).sqrt();
        let mut sim = Wedge { k, m, c: 0.0 }.taylor(TaylorOrder::<6>::default(), State::new(1.0, 0.0));
        sim.advance_to(2e3 * period).unwrap();
        assert!((sim.energy() / k - 1.0).abs() < 1e-10, "{:e}", sim.energy() / k - 1.0);
    }
    for alternating in [false, true] {
        // Rounding makes all amplitudes different.
        let side = |i: usize| if alternating && i % 2 == 1 { -1.0 } else { 1.0 };
        let q = std::array::from_fn(|i| side(i) * (1.0 + i as f64 * f64::EPSILON));
        let system = Wedges { k: 1.3 };
        let mut sim = system.taylor(TaylorOrder::<6>::default(), State::new(q, [0.0; 24]));
        sim.advance_to(100.0).unwrap();
        assert!((sim.energy() / (24.0 * 1.3) - 1.0).abs() < 1e-12);
    }
    let mut sim = Beside { k: 1.0 }.taylor(TaylorOrder::<6>::default(), State::new([1e-8, 1.0], [0.0, 0.0]));
    sim.advance_to(1.0).unwrap();
    assert!((sim.state().q[1] - 1.0_f64.cos()).abs() < 1e-11 && sim.steps() > 1000);
}

/// A run saved in the middle of bounces continues in the same way.
#[test]
fn saved_between_bounces() {
    let run = || {
        Dry { k: 1.0, f: 0.5, c: 0.0 }.taylor(Taylor::default(), FlowState::new([1.0, 0.0])).steps_at_most(1_000_000)
    };
    let (mut whole, mut first, mut second) = (run(), run(), run());
    assert!(slides(&whole.advance_to(100.0)));
    first.advance(100).unwrap();
    second.resume(&first.saved()).unwrap();
    assert!(slides(&second.advance_to(100.0)));
    assert_eq!((whole.state(), whole.steps()), (second.state(), second.steps()));
}
