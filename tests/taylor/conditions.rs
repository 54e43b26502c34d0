//! Conditions whose series end before the series of the coordinates, and long steps: a free body flies as far as requested.

use geoint_runtime::Failure;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A disc that repels, by the square of the distance.
#[hamiltonian]
fn disc(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
    let square = q[0] * q[0] + q[1] * q[1];
    let potential = if square < 1.0 { k * (1.0 - square) * (1.0 - square) } else { 0.0 };
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + potential
}

/// The same by the distance, whose series ends as far ahead as the centre is off.
#[hamiltonian]
fn cut_off(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
    let r = (q[0] * q[0] + q[1] * q[1]).sqrt();
    let potential = if r < 1.0 { k * (1.0 - r) * (1.0 - r) } else { 0.0 };
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + potential
}

/// A hill that is not to be seen in the first digits from afar.
#[hamiltonian]
fn hill(q: f64, p: f64, k: f64) -> f64 {
    let height = (-q * q).exp();
    p * p / 2.0 + if height > 0.5 { k * (height - 0.5) } else { 0.0 }
}

/// Asserts that the motion of a free body after a condition does not depend on the requested time of flight.
macro_rules! scattered {
    ($system:expr, $start:expr, |$state:ident| $p:expr) => {{
        let mut near = $system.taylor(Taylor::default(), $start);
        let energy = near.energy();
        near.advance_to(10.0).unwrap();
        let $state = near.state();
        let exact = $p;
        // A reference with other steps.
        let mut other = $system.adaptive(DOP853, 1e-11, $start).steps_between(0.0, 0.05);
        other.advance_to(10.0).unwrap();
        let $state = other.state();
        for (found, exact) in $p.into_iter().zip(exact) {
            assert!((found - exact).abs() < 1e-7, "{found} {exact}");
        }
        for t in [30.0, 1e3, 1e6, 1e9] {
            let mut sim = $system.taylor(Taylor::default(), $start);
            sim.advance_to(t).unwrap();
            assert!((sim.energy() - energy).abs() < 1e-14, "{t}: {:e}", sim.energy() - energy);
            let $state = sim.state();
            for (found, exact) in $p.into_iter().zip(exact) {
                assert!((found - exact).abs() < 1e-13, "{t}: {found} {exact}");
            }
        }
    }};
}

#[test]
fn what_flies_freely_does_not_fly_through() {
    let start = State::new([-3.0, 0.3], [1.0, 0.0]);
    scattered!(Disc { k: 5.0 }, start, |state| state.p);
    scattered!(CutOff { k: 5.0 }, start, |state| state.p);
    scattered!(Hill { k: 1.9 }, State::new(-3.0, 1.3), |state| [state.p]);
    // A start from far away.
    let mut sim = Hill { k: 0.5 }.taylor(Taylor::default(), State::new(-12.0, 1.3));
    sim.advance_to(10.0).unwrap();
    let energy = |state: State<f64>| Hill { k: 0.5 }.energy(&state);
    assert!((energy(sim.state()) - 0.845).abs() < 1e-14 && sim.state().q < 0.9, "{:?}", sim.state());
}

/// Steps of fixed length, and a run backwards.
#[test]
fn and_not_with_steps_of_one_length() {
    let (start, system) = (State::new([-3.0, 0.3], [1.0, 0.0]), CutOff { k: 5.0 });
    let mut exact = system.taylor(Taylor::default(), start);
    exact.advance_to(10.0).unwrap();
    let mut sim = system.taylor(TaylorFixed::<16> { h: 0.05 }, start);
    sim.advance_to(10.0).unwrap();
    assert!((0..2).all(|i| (sim.state().p[i] - exact.state().p[i]).abs() < 1e-9), "{:?}", sim.state());
    exact.advance_to(0.0).unwrap();
    assert!((0..2).all(|i| (exact.state().q[i] - start.q[i]).abs() < 1e-12), "{:?}", exact.state());
}

/// x' = a − b·sgn(x − c), y' = 1: led to c from both sides if |a| < b.
#[vector_field]
fn friction(x: [f64; 2], a: f64, b: f64, c: f64) -> [f64; 2] {
    [a - b * (x[0] - c).signum(), 1.0 + 0.0 * x[1]]
}

/// Far from zero, a step ends beside the condition, at the distance of the rounding of coordinates. Sliding is still refused.
#[test]
fn what_slides_far_from_zero_is_refused_too() {
    let sliding = |outcome| matches!(outcome, Err(StepError { failure: Failure::Sliding, .. }));
    for c in [0.0, 1.0, -1e-3, 1e3, 1e6] {
        let (system, start) = (Friction { a: -0.1, b: 0.3, c }, FlowState::new([c + 1.0, 0.0]));
        let mut sim = system.taylor(Taylor::default(), start).steps_at_most(1000);
        let outcome = sim.advance_to(10.0);
        assert!(sliding(outcome), "{c}: {outcome:?}");
        assert!((sim.time() - 2.5).abs() < 1e-14 * c.abs().max(100.0), "{c}: {}", sim.time());
        let mut sim = system.taylor(TaylorFixed::<8> { h: 0.1 }, start).steps_at_most(1000);
        let outcome = sim.advance_to(10.0);
        assert!(sliding(outcome), "{c}: {outcome:?}");
        // The run continues from another state.
        sim.set_state(FlowState::at(5.0, [c - 1.0, 0.0]));
        sim.advance_to(6.0).unwrap();
        assert!((sim.state().x[0] - (c - 0.8)).abs() < 1e-9, "{:?}", sim.state());
        sim.set_state(FlowState::at(5.0, [c, 0.0]));
        assert!(sliding(sim.advance_to(10.0)));
        // A crossing of a condition is not taken for sliding.
        let mut sim = Friction { a: 1.0, b: 0.3, c }.taylor(Taylor::default(), FlowState::new([c - 1.3, 0.0]));
        sim.advance_to(2.0).unwrap();
        assert!((sim.state().x[0] - (c + 0.7)).abs() < 1e-15 * c.abs().max(1.0), "{c}: {:?}", sim.state());
    }
}

/// Free fall below the height `c`, and a spring above it.
#[hamiltonian]
fn spring_above(q: f64, p: f64, c: f64, k: f64) -> f64 {
    p * p / 2.0 + q + k * (q - c).max(0.0).powi(2) / 2.0
}

/// A body rises to the height of a condition, up to rounding, and falls back. No step searches for the other side beyond its end, or without end.
#[test]
fn what_only_touches_a_condition_turns_back() {
    let throws = [
        (0.6098852380221516, 0.43736482594440723),
        (1.387623704308215, 1.1262985640923604),
        (0.4342042864274873, 1.664824223418748),
        (1.5081122377312046, 1.3306841340357058),
        (1.9036058282846953, 1.5651754624209682),
        (0.24175166876427712, 0.228907384221198),
    ];
    for (q, p) in throws {
        let system = SpringAbove { c: q + p * p / 2.0, k: 5.0 };
        for end in [1.1 * p, 1.9 * p, 2.388_484_4 * p] {
            let mut run = system.taylor(Taylor::default(), State::new(q, p));
            while run.step_towards(end).expect("a step") {
                assert!(run.time() <= end && run.steps() < 100, "{run:?}");
            }
            let exact = [q + p * end - end * end / 2.0, p - end];
            let State { q, p, .. } = run.state();
            assert!((q - exact[0]).abs() < 1e-6 && (p - exact[1]).abs() < 1e-6, "{q} {p} {exact:?}");
        }
    }
}

/// x' = k, and a clock that starts where √x = 1.
#[vector_field]
fn gate(x: [f64; 2], k: f64) -> [f64; 2] {
    [k, if x[0].sqrt() < 1.0 { 0.0 } else { 1.0 }]
}

/// The condition has no series if the run starts on the boundary of its domain. Its change in the first step is still detected.
#[test]
fn a_condition_without_a_series_is_not_passed() {
    let counted = |t: f64| t - 1.0 / 3.0;
    for h in [0.5, 5.0, 50.0] {
        let mut sim = Gate { k: 3.0 }.taylor(TaylorFixed::<12> { h }, FlowState::new([0.0; 2]));
        sim.advance(8).expect("steps");
        let state = sim.state();
        // Bound: the accuracy of 12 terms within half of their radius of convergence.
        assert!((state.x[1] - counted(state.t)).abs() < 1e-5, "{h}: {state:?}");
    }
    for tolerance in [0.05, 1e-6, 1e-15] {
        let mut sim = Gate { k: 3.0 }.taylor(Taylor { tolerance }, FlowState::new([0.0; 2]));
        sim.advance_to(2.0).expect("steps");
        assert!((sim.state().x[1] - counted(2.0)).abs() < tolerance.max(1e-14), "{tolerance}: {:?}", sim.state());
    }
}
