//! Projected series, and interpolation by states and rates of other methods.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

#[hamiltonian]
fn kepler(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - m / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

#[contact_hamiltonian]
fn damped_pendulum(q: f64, p: f64, s: f64) -> f64 {
    p * p / 2.6 - q.cos() + 0.1 * s
}

#[vector_field(keeps(
    energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
    momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0,
))]
fn euler_top(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
    [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
}

/// At a loose tolerance the truncation error makes the energy drift. A projection reduces the error to rounding.
#[test]
fn projected_series() {
    let (system, start) = (Kepler { m: 1.3 }, State::new([0.4, 0.0], [0.0, 2.6]));
    let worst = |energy: f64, now: f64| (now / energy - 1.0).abs();
    for sign in [1.0, -1.0] {
        let mut plain = system.taylor(TaylorOrder::<12> { tolerance: 1e-6 }, start);
        let mut projected = system.taylor(Projection(TaylorOrder::<12> { tolerance: 1e-6 }, Energy), start);
        let energy = plain.energy();
        plain.advance_to(sign * 500.0).unwrap();
        projected.advance_to(sign * 500.0).unwrap();
        assert!(worst(energy, plain.energy()) > 1e-8, "{:e}", worst(energy, plain.energy()));
        assert!(worst(energy, projected.energy()) < 4e-15, "{:e}", worst(energy, projected.energy()));
    }
    // Steps of fixed length, and events on the way.
    let mut sim = system.taylor(Projection(TaylorFixed::<6> { h: 0.01 }, Energy), start);
    let energy = sim.energy();
    assert_eq!(sim.crossings(Direction::Up, |s| s.q[1]).take(3).filter(Result::is_ok).count(), 3);
    assert!(worst(energy, sim.energy()) < 4e-15);
    // All integrals of a field.
    let (top, x) = (EulerTop { a: 1.0, b: 2.0, c: 3.0 }, FlowState::new([0.5, 0.8, -0.4]));
    let momentum = |x: [f64; 3]| x[0] * x[0] + 4.0 * x[1] * x[1] + 9.0 * x[2] * x[2];
    for projects in [false, true] {
        let end = if projects {
            let mut sim = top.taylor(Projection(Taylor { tolerance: 1e-5 }, Integrals), x);
            sim.advance_to(300.0).map(|()| sim.state())
        } else {
            let mut sim = top.taylor(Taylor { tolerance: 1e-5 }, x);
            sim.advance_to(300.0).map(|()| sim.state())
        };
        let x = end.unwrap().x;
        let error = worst(top.energy(&FlowState::new([0.5, 0.8, -0.4])), top.energy(&FlowState::new(x)))
            .max(worst(momentum([0.5, 0.8, -0.4]), momentum(x)));
        assert_eq!(error < 1e-14, projects, "{error:e}");
    }
    // A tolerance of zero is refused.
    let bad = system.taylor(Projection(Taylor { tolerance: 0.0 }, Energy), start).step();
    assert!(matches!(bad, Err(StepError { failure: Failure::InvalidTolerance { .. }, .. })));
}

/// Projected steps do not drift: each is led back to the energy at the start of the run. A projection from step to step would add up to 10⁻¹³ of rounding.
#[test]
fn projected_series_do_not_walk() {
    let start = State::new([0.4, 0.0], [0.0, 2.6]);
    let mut sim = Kepler { m: 1.3 }.taylor(Projection(Taylor { tolerance: 1e-9 }, Energy), start);
    let (energy, mut worst) = (sim.energy(), 0.0_f64);
    for n in 1..=20 {
        sim.advance_to(500.0 * n as f64).unwrap();
        worst = worst.max((sim.energy() / energy - 1.0).abs());
    }
    assert!(worst < 5e-15, "{worst:e}");
    // A state set by the user has its own energy.
    sim.set_state(State::at(sim.time(), [0.5, 0.0], [0.0, 2.0]));
    let energy = sim.energy();
    sim.advance(3000).unwrap();
    assert!((sim.energy() / energy - 1.0).abs() < 5e-15, "{:e}", sim.energy() / energy - 1.0);
}

/// Asserts that interpolation does not increase the error of states a twentieth of a step apart. The reference takes shorter steps to the same times.
macro_rules! interpolated {
    ($exact:expr, $sim:expr, |$state:ident| $x:expr) => {{
        let (mut exact, mut sim) = ($exact, $sim);
        let mut copy = sim.clone();
        let dt = sim.step_size() / 20.0;
        let times: Vec<f64> = (0..600).map(|n| n as f64 * dt).collect();
        let exact: Vec<f64> = exact.sampled_at(times.clone()).map(|s| s.unwrap()).map(|$state| $x).collect();
        let error = |found: Vec<f64>| found.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let steps = error(sim.sampled_every(dt).take(600).map(|s| s.unwrap()).map(|$state| $x).collect());
        let curves = copy.sampled_every(dt).interpolated().take(600).map(|s| s.unwrap());
        let curves = error(curves.map(|$state| $x).collect());
        assert!(curves < 1.1 * steps + 1e-13, "{curves:e} {steps:e}");
        assert_eq!(copy.state(), sim.state());
    }};
}

#[test]
fn polynomials_through_states_and_rates() {
    let (system, start) = (Kepler { m: 1.3 }, State::new([0.4, 0.0], [0.0, 2.6]));
    let exact = || system.taylor(Taylor::default(), start);
    interpolated!(exact(), system.integrator(StormerVerlet, 0.02, start), |s| s.p[1]);
    interpolated!(exact(), system.integrator(BlanesMoan4, 0.05, start), |s| s.p[1]);
    interpolated!(exact(), system.integrator(BceRkn17_8, -0.1, start), |s| s.p[1]);
    interpolated!(exact(), system.integrator(Gauss::<6>, 0.1, start), |s| s.p[1]);
    interpolated!(exact(), system.adaptive(DOP853, 1e-9, start), |s| s.p[1]);
    let start = ContactState::new(1.5, 0.3, 0.2);
    let exact = || DampedPendulum.taylor(Taylor::default(), start);
    interpolated!(exact(), DampedPendulum.integrator(Suzuki4.of(ContactSplitting), 0.1, start), |state| state.s);
}
