//! Projections of explicit steps that are far too large: what such a step is led back to keeps the energy to rounding, or is an error.

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

/// How many steps succeed, and the largest change of an energy in units of its rounding.
#[derive(Default)]
struct Outcome {
    steps: usize,
    worst: f64,
}

/// Takes at most 100 steps of these sizes from each of 200 random starts. `$terms` are the terms of the energy, of which ε is their rounding.
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

/// A step is refused where an invariant changes by more than so many roundings.
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
    assert!(matches!(sim.step(), Err(StepError::LedAstray { t: 0.0 })), "{:?}", sim.state());
    assert_eq!(sim.state(), start);
    let mut sim = Swing { m: 1.3 }.integrator(Projection(RK4, Energy), 0.5, start);
    sim.step().expect("a shorter step");
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
