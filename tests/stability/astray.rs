//! Projections of explicit steps that are far too large. A projected step keeps the energy to rounding, or is refused.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::Noise;

/// A pendulum of mass m, in any scalar.
#[hamiltonian]
fn swing(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - q.cos()
}

/// The same in single precision.
#[hamiltonian]
fn swing_single(q: f32, p: f32, m: f32) -> f32 {
    p * p / (2.0 * m) - q.cos()
}

/// A quartic double well in single precision.
#[hamiltonian]
fn double_well_single(q: f32, p: f32, m: f32) -> f32 {
    p * p / (2.0 * m) - q * q / 2.0 + q * q * q * q / 4.0
}

/// The same with a torque, in single precision.
#[hamiltonian]
fn turned_single(q: f32, p: f32, m: f32, torque: f32) -> f32 {
    p * p / (2.0 * m) - torque * q.cos()
}

/// Two coordinates with bends between them.
#[hamiltonian]
fn two_with_bends(q: [f64; 2], p: [f64; 2], a: f64, b: f64) -> f64 {
    let squares = (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0] * q[0] / 4.0 + q[1] * q[1] / 3.0;
    squares + a * (q[0] - q[1]).abs() + q[0].max(b * q[1]) - q[1].min(0.3)
}

/// Number of successful steps, and the largest change of the energy in units of its rounding.
#[derive(Default)]
struct Outcome {
    steps: usize,
    worst: f64,
}

/// Takes at most 100 steps of each size from each of 200 random starts. `$terms` is the size of the terms of the energy: its rounding is ε times this size.
macro_rules! outcome {
    ($method:expr, $system:expr, $scalar:ty, $start:expr, $terms:expr) => {{
        let (mut noise, mut outcome) = (Noise::new(11), Outcome::default());
        for h in [1.0, 2.0, 2.667, 4.0] {
            for _ in 0..200 {
                let mut sim = $system.integrator($method, h, $start(&mut || noise.next().unwrap() as $scalar));
                let start = f64::from(sim.energy());
                for _ in 0..100 {
                    if sim.step().is_err() {
                        break;
                    }
                    let rounding = f64::from(<$scalar>::EPSILON) * f64::from($terms(sim.state()));
                    outcome.worst = outcome.worst.max((f64::from(sim.energy()) - start).abs() / rounding);
                    outcome.steps += 1;
                }
            }
        }
        outcome
    }};
}

/// A step is refused if an invariant changes by more roundings than this.
const MOST: f64 = 16384.0;

#[test]
fn a_step_that_is_led_astray_is_refused() {
    let swing = || Swing { m: 1.3 };
    let start = |next: &mut dyn FnMut() -> f64| State::new(3.0 * next(), 2.0 * next());
    let terms = |x: State<f64>| 1.0 + x.q.abs() + x.p * x.p;
    let Outcome { steps, worst } = outcome!(Projection(RK4, Energy), swing(), f64, start, terms);
    assert!(steps > 20_000 && worst <= MOST, "{steps} steps: {worst:.1e}");
    // Control: without the projection.
    assert!(outcome!(RK4, swing(), f64, start, terms).worst > 1e9);
}

/// The message names the reason, and the state stays. A shorter step succeeds.
#[test]
fn the_refusal_has_a_name() {
    let start = State::new(2.0, 0.0);
    let mut sim = Swing { m: 1.3 }.integrator(Projection(RK4, Energy), 6.0, start);
    assert!(matches!(sim.step(), Err(StepError { t: 0.0, failure: Failure::LedAstray, .. })), "{:?}", sim.state());
    assert_eq!(sim.state(), start);
    let mut sim = Swing { m: 1.3 }.integrator(Projection(RK4, Energy), 0.5, start);
    sim.step().expect("a shorter step");
}

/// Beside a bend, and at an angle of many turns, a residual is as rough as rounding. A large residual must not be accepted as rounding.
#[test]
fn rough_residuals_are_not_all_rounding() {
    let start = State::new(-2.922_252e-5_f32, -3.069_984e-5);
    let mut sim =
        TurnedSingle { m: 1.035_493_6, torque: -1.377_243 }.integrator(Projection(RK4, Energy), 269.344_06, start);
    assert!(sim.step().is_err(), "energy {} at {:?}", sim.energy(), sim.state());

    let bends = TwoWithBends { a: 0.349_118_539_689_467_9, b: 0.899_360_474_606_351_5 };
    let start = State::new(
        [-0.009_228_948_329_623_414, 0.032_954_185_037_033_12],
        [0.026_709_524_524_431_486, -0.037_441_325_000_406_6],
    );
    let mut sim = bends.integrator(Projection(RK4, Energy), -1.680_639_735_516_648_7e-2, start);
    let energy = sim.energy();
    for _ in 0..1100 {
        if sim.step().is_err() {
            break;
        }
        let error = (sim.energy() - energy).abs();
        assert!(error <= 1e-13, "step {}: {error:.1e}", sim.steps());
    }
    assert!(sim.steps() > 500, "{} steps", sim.steps());
}

#[test]
fn in_single_precision_too() {
    let start = |next: &mut dyn FnMut() -> f32| State::new(3.0 * next(), 2.0 * next());
    let terms = |x: State<f32>| 1.0 + x.q.abs() + x.p * x.p;
    let Outcome { steps, worst } = outcome!(Projection(RK4, Energy), SwingSingle { m: 1.3 }, f32, start, terms);
    assert!(steps > 20_000 && worst <= MOST, "{steps} steps: {worst:.1e}");
    let terms = |x: State<f32>| 1.0 + x.q.powi(4) + x.p * x.p;
    let Outcome { steps, worst } = outcome!(Projection(RK4, Energy), DoubleWellSingle { m: 1.3 }, f32, start, terms);
    assert!(steps > 10_000 && worst <= MOST, "{steps} steps: {worst:.1e}");
}
