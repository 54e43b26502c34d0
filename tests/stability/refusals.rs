//! Bad input and refused steps at run time. A step returns an error with a reason, the state is the last good state bit for bit, and the run can
//! continue with a usable step size.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Hamiltonian, Method};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;

/// A logarithmic wall at q = 0. Its force k/q − 1 is finite for q < 0, too, so a finite force does not show that the logarithm is undefined.
#[hamiltonian]
fn wall(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) - k * q.ln() + q
}

/// A root that is undefined for |q| > 1.
#[hamiltonian]
fn rim(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - (1.0 - q * q).sqrt()
}

/// A logarithm that depends on q and p together.
#[hamiltonian]
fn joint_rim(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + (q * p + 1.0).ln() + q * q
}

/// Asserts for each method that unusable step sizes are refused and leave state and step count unchanged.
struct BadSteps;

impl Visitor<HenonHeiles, f64> for BadSteps {
    fn visit<M: Method<HenonHeiles, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let mut sim = HenonHeiles::system::<f64>().integrator(method, 0.01, HenonHeiles::initial(0.2));
        sim.advance(5).unwrap();
        let good = sim.state();
        for h in [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            sim.set_step_size(h);
            let expected = |error: StepError| matches!(error, StepError { failure: Failure::InvalidStepSize { h: seen }, .. } if seen == h || h.is_nan());
            assert!(expected(sim.step().unwrap_err()), "{name}: {h}");
            assert!(expected(sim.advance(3).unwrap_err()), "{name}: {h}");
            assert_eq!((sim.state().q, sim.state().p), (good.q, good.p), "{name}: {h}");
            assert_eq!(sim.steps(), 5);
        }
    }
}

/// Every method refuses the step sizes 0, NaN and ±∞.
#[test]
fn unusable_step_sizes() {
    methods::general(&mut BadSteps);
    methods::discrete_gradient(&mut BadSteps);
    methods::projected(&mut BadSteps);
    methods::relaxed(&mut BadSteps);
    methods::separable(&mut BadSteps);
    methods::nystrom(&mut BadSteps);
    methods::force_gradient(&mut BadSteps);
}

/// An unusable step size does not change the time. A usable step size then continues the run.
#[test]
fn time_survives_unusable_step_sizes() {
    for h in [0.0, f64::NAN, f64::INFINITY] {
        let mut sim = Pendulum::system::<f64>().integrator(StormerVerlet, 0.01, Pendulum::initial(0.2));
        sim.advance(5).unwrap();
        let good = sim.state();
        sim.set_step_size(h);
        assert!(sim.step().is_err());
        sim.set_step_size(0.02);
        assert_eq!(sim.state(), good, "after h = {h}");
        sim.step().unwrap();
        assert_eq!(sim.time(), good.t + 0.02);
    }
}

/// A start with NaN or ±∞ in q, p or t is refused. `sampled` yields the error once.
#[test]
fn states_that_are_not_finite() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (t, q, p) in [(0.0, bad, 0.0), (0.0, 0.0, bad), (bad, 0.0, 0.0)] {
            let mut sim = Pendulum::system::<f64>().integrator(StormerVerlet, 0.01, State::at(t, q, p));
            assert!(matches!(sim.step(), Err(StepError { failure: Failure::NonFiniteState, .. })), "{t} {q} {p}");
            let mut sim = Pendulum::system::<f64>().integrator(ImplicitMidpoint, 0.01, State::at(t, q, p));
            assert!(matches!(sim.advance(10), Err(StepError { failure: Failure::NonFiniteState, .. })), "{t} {q} {p}");
            assert_eq!(sim.sampled(1).count(), 1, "one item, the error");
        }
    }
}

/// Asserts that an error in a long `advance` leaves the state before the failing step, bit for bit as single steps do. After `OutsideDomain`, a smaller
/// step continues. Returns the error.
fn stops_at_the_last_good_state<S, M>(
    name: &str,
    system: S,
    method: M,
    h: f64,
    start: State<S::Coordinates>,
) -> StepError
where
    S: Hamiltonian<f64>,
    M: Method<S, f64>,
    S::Coordinates: PartialEq,
{
    let mut single = system.integrator(method, h, start);
    let mut last = single.state();
    let reason = loop {
        match single.step() {
            Ok(()) => last = single.state(),
            Err(reason) => break reason,
        }
        assert!(single.steps() < 3000, "{name}: no error in 3000 steps, now at {last:?}");
    };
    assert_eq!(single.state(), last);
    assert_eq!(single.time(), start.t + single.steps() as f64 * h);

    let mut bulk = system.integrator(method, h, start);
    assert_eq!(bulk.advance(5000).unwrap_err(), reason);
    assert_eq!(bulk.state(), last, "`advance` stops where single steps stop");
    assert_eq!(bulk.steps(), single.steps());
    // A second attempt returns the same error and leaves the same state.
    assert_eq!(bulk.step().unwrap_err(), reason);
    assert_eq!(bulk.state(), last);

    if matches!(reason, StepError { failure: Failure::OutsideDomain { .. }, .. }) {
        let smaller = 1e-6 * h;
        bulk.set_step_size(smaller);
        assert_eq!(bulk.step(), Ok(()), "{name}: a smaller step from {last:?}");
        // The time is exact before rounding, so it may differ from this sum in its last digit.
        assert!((bulk.time() - (last.t + smaller)).abs() <= f64::EPSILON * last.t.abs());
    }
    reason
}

/// A particle falls towards the wall. A long step would end behind the wall, at a negative argument of the logarithm.
#[test]
fn a_logarithm_of_a_negative_number() {
    fn check<M: Method<Wall, f64>>(name: &str, method: M) {
        let system = Wall { m: 1.3, k: 0.05 };
        let reason = stops_at_the_last_good_state(name, system, method, 0.31, State::new(2.0, -1.0));
        let StepError { t, failure: Failure::OutsideDomain { what }, .. } = reason else { panic!("{name}: {reason}") };
        assert!(what.contains("ln") && t >= 0.0, "{name}: {reason}");
    }
    check("StormerVerlet", StormerVerlet);
    check("PositionVerlet", PositionVerlet);
    check("SymplecticEuler", SymplecticEuler);
    check("ExplicitEuler", ExplicitEuler);
    check("BlanesMoan4", BlanesMoan4);
}

/// A particle runs over the point where the root becomes undefined.
#[test]
fn a_root_of_a_negative_number() {
    fn check<M: Method<Rim, f64>>(name: &str, method: M) {
        let reason = stops_at_the_last_good_state(name, Rim { m: 1.4 }, method, 0.1, State::new(0.2, 2.0));
        let StepError { t, failure: Failure::OutsideDomain { what }, .. } = reason else { panic!("{name}: {reason}") };
        assert!(what.contains("sqrt") || what.contains("root"), "{name}: {reason}");
        assert!(t > 0.0, "{name}: {reason}");
    }
    check("StormerVerlet", StormerVerlet);
    check("BlanesMoanSrkn14a", BlanesMoanSrkn14a);
    check("ExplicitEuler", ExplicitEuler);
    check("ImplicitMidpoint", ImplicitMidpoint);
    check("Gauss", Gauss::<3>);
    check("DiscreteGradient", DiscreteGradient);
    check("composition", Yoshida4.of(ImplicitMidpoint));
}

/// A start where the energy is undefined is refused at the first step.
#[test]
fn a_start_outside_the_domain() {
    let mut sim = Rim { m: 1.4 }.integrator(StormerVerlet, 0.1, State::new(1.5, 0.0));
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })));
    let mut sim = Wall { m: 1.4, k: 1.0 }.integrator(StormerVerlet, 0.01, State::new(-1.0, 0.0));
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })), "{:?}", sim.state());
    let mut sim = JointRim { m: 1.4 }.integrator(ImplicitMidpoint, 0.01, State::new(2.0, -1.0));
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })), "{:?}", sim.state());
}

/// The potential q₁² − exp(q₀ + 0.1 q₁) accelerates a particle without limit. The equations of long implicit steps have no solution.
#[hamiltonian]
fn cliff(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + q[1] * q[1] - (q[0] + 0.1 * q[1]).exp()
}

/// Newton's method returns an error if an implicit step has no solution. A smaller step succeeds.
#[test]
fn newton_that_does_not_converge() {
    fn check<M: Method<Cliff>>(name: &str, method: M) {
        let start = State::new([0.3, 0.2], [0.4, -0.1]);
        for h in [3.0, 10.0, 30.0, 1e3, 1e6] {
            let mut sim = Cliff { m: 1.3 }.integrator(method, h, start);
            let before = sim.energy();
            let Err(error) = sim.step() else {
                // The equations of methods of order 4 have a solution at h = 3.
                assert!(h == 3.0 && method.claims().order == 4, "{name}: h = {h}: {:?}", sim.state());
                assert!((sim.energy() - before).abs() < 1e-14, "{name}: h = {h}: {:?}", sim.state());
                continue;
            };
            assert!(
                matches!(error, StepError { t: 0.0, failure: Failure::NotConverged { .. } | Failure::Singular, .. }),
                "{name}: h = {h}: {error}"
            );
            assert_eq!(sim.state(), start, "{name}: h = {h}");
            sim.set_step_size(0.01);
            assert_eq!(sim.step(), Ok(()), "{name}: h = {h}");
        }
        // An adaptive run reduces its first step and reaches t = 1. The exact solution diverges at a finite time, so the run can not reach t = 10.
        let mut sim = Cliff { m: 1.3 }.adaptive(method, 1e-6, start).first_step(30.0);
        assert_eq!(sim.advance_to(1.0), Ok(()), "{name}");
        assert!(sim.rejections() > 0);
        let reason = sim.advance_to(10.0).unwrap_err();
        assert!(reason.is_shortest(), "{name}: {reason}");
    }
    check("ImplicitMidpoint", ImplicitMidpoint);
    check("Gauss", Gauss::<2>);
    check("DiscreteGradient", DiscreteGradient);
    check("MeanValue", MeanValue::<3>);
    check("Gonzalez", Gonzalez);
    check("SymmetrisedItohAbe", SymmetrisedItohAbe);
    check("ItohAbePair", ItohAbePair);
    check("FourthOrder", FourthOrder(DiscreteGradient));
    check("composition", Suzuki4.of(DiscreteGradient));
}

/// `FourthOrder(DiscreteGradient)` refuses steps with hω > √12, in which an oscillation turns by more than half a turn. There the projection would move
/// along the surface of constant energy instead of across it.
#[test]
fn half_a_turn_in_a_step() {
    #[hamiltonian]
    fn oscillator(q: f64, p: f64, m: f64, k: f64) -> f64 {
        p * p / (2.0 * m) + k * q * q / 2.0
    }
    // ω = √(k/m) = 10.
    let run = |h: f64| {
        let start = State::new(1.0, 0.3);
        Oscillator { m: 0.5, k: 50.0 }.integrator(FourthOrder(DiscreteGradient), h, start).advance(100)
    };
    let most = 12.0_f64.sqrt() / 10.0;
    assert_eq!(run(0.999 * most), Ok(()));
    assert!(matches!(run(1.001 * most), Err(StepError { failure: Failure::Singular, .. })));
}

/// Implicit steps have a solution for huge h in a potential well. The midpoint of the step tends to the minimum, so x₁ tends to −x₀. Newton's method
/// finds this solution, although the initial guess is far away.
#[test]
fn steps_of_any_length_in_a_well() {
    fn check<M: Method<DoublePendulum>>(name: &str, method: M) {
        let (system, start) = (DoublePendulum::system::<f64>(), DoublePendulum::initial::<f64>(0.0));
        for h in [3e3, 3e4, 3e5, 3e6, 3e7, 3e8] {
            let mut sim = system.integrator(method, h, start);
            assert_eq!(sim.step(), Ok(()), "{name}: h = {h}");
            let end = sim.state();
            let gap = flat(&end).iter().zip(flat(&start)).fold(0.0, |gap: f64, (a, b)| gap.max((a + b).abs()));
            assert!(gap < 30.0 / h, "{name}: h = {h}: {end:?}");
            let error = (system.energy(&end) - system.energy(&start)).abs();
            assert!(error <= 1e-14 || !method.claims().conserves_energy, "{name}: h = {h}: {error:.1e}");
        }
    }
    check("ImplicitMidpoint", ImplicitMidpoint);
    check("DiscreteGradient", DiscreteGradient);
}

/// An overflow is reported as `NonFinite`, because the energy is defined everywhere.
#[test]
fn overflow_on_the_way() {
    let system = QuarticChain::system::<f64>();
    let reason = stops_at_the_last_good_state("overflow", system, StormerVerlet, 5.0, QuarticChain::initial(0.0));
    assert!(matches!(reason, StepError { t, failure: Failure::NonFinite, .. } if t > 0.0), "{reason}");
}

/// Messages name the time, the function and its argument.
#[test]
fn messages_say_why() {
    let mut sim = Rim { m: 1.4 }.integrator(StormerVerlet, 0.1, State::new(0.2, 2.0));
    let message = sim.advance(100).unwrap_err().to_string();
    assert!(
        message.contains("t = 0.") && message.contains("`sqrt` of a negative number") && message.contains("q²"),
        "{message}"
    );
    let error: Box<dyn std::error::Error> = Box::new(StepError::new(Failure::InvalidStepSize { h: 0.0 }, 0.0, 0.0));
    assert!(error.to_string().contains("step size"));
}

/// The message of `NotConverged` uses singular, plural, and a sentence of its own for 0 iterations.
#[test]
fn messages_count() {
    let text =
        |iterations| StepError::new(Failure::NotConverged { iterations, correction: 0.25 }, 0.5, 0.1).to_string();
    assert!(text(100).contains("in 100 iterations (last correction 2.5e-1)"), "{}", text(100));
    assert!(text(1).contains("in 1 iteration (last"), "{}", text(1));
    assert!(text(0).contains("has no value") && !text(0).contains("inf"), "{}", text(0));
}
