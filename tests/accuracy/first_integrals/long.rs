//! Long runs: periods to twelve digits, and an integral over 10⁸ steps.

use super::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// By the trapezoidal rule in an angle along the orbit, with 50 digits.
const PREDATORS: f64 = 5.173_375_597_582_038_8;
/// 4K(k)/λ of Jacobi's functions.
const TOP: f64 = 14.698_307_430_045_764;

/// The time after which the first coordinate is back, by secants.
fn period<S, M, const N: usize>(system: S, method: M, start: [f64; N], steps: u64, guess: f64) -> f64
where
    S: PhaseSpace<State = FlowState<[f64; N]>>,
    M: Method<S>,
{
    let miss = |time: f64| {
        let mut sim = Integrator::new(system, method, time / steps as f64, FlowState::new(start));
        sim.advance(steps).unwrap_or_else(|error| panic!("{error}"));
        sim.state().x[0] - start[0]
    };
    let (mut before, mut now) = (1.001 * guess, guess);
    let mut last = miss(before);
    for _ in 0..12 {
        let this = miss(now);
        if this == last {
            break;
        }
        (before, now) = (now, now - this * (now - before) / (this - last));
        last = this;
    }
    now
}

/// By four methods of order 8, in 400 steps; a method of order 4 misses.
#[test]
fn periods_to_twelve_digits() {
    let (start, guess) = ([1.0, 0.5], 5.2);
    let (flow, field) = (LotkaVolterra { a: 2.0, b: 1.0, c: 1.0 }, Predators { a: 2.0, b: 1.0, c: 1.0 });
    let eighth = KahanLi8_17a.of(DiscreteGradient);
    let found = [
        period(flow, eighth, start, 400, guess),
        period(field, eighth, start, 400, guess),
        period(flow, KahanLi8_17a.of(PoissonSplitting), start, 400, guess),
        period(field, Gauss::<4>, start, 400, guess),
    ];
    assert!(found.iter().all(|period| (period - PREDATORS).abs() < 1e-12), "{found:?}");
    let control = period(field, FourthOrder(DiscreteGradient), start, 400, guess);
    assert!((control - PREDATORS).abs() > 1e-10, "{control}");

    let (velocity, guess) = ([0.5, 0.8, -0.4], 14.7);
    let (top, body) = (EulerTop { a: 1.0, b: 2.0, c: 3.0 }, FreeBody { inertia: [1.0, 2.0, 3.0] });
    let found = [
        period(top, eighth, velocity, 400, guess),
        period(body, KahanLi8_17a.of(PlanarSplitting), velocity, 800, guess),
        period(top, Gauss::<4>, velocity, 400, guess),
    ];
    assert!(found.iter().all(|period| (period - TOP).abs() < 1e-12), "{found:?}");
    let control = period(top, FourthOrder(DiscreteGradient), velocity, 400, guess);
    assert!((control - TOP).abs() > 1e-10, "{control}");
}

/// The equation of a step is evaluated at a point that includes the rounding errors of the sums. Steps then equal steps of compensated runs to the
/// last bit. Otherwise an integral drifts by 2 to 8·10⁻²⁰ per step, a thousandth of ε.
#[test]
fn steps_see_what_their_sums_have_lost() {
    let (flow, field) = (LotkaVolterra { a: 2.0, b: 1.0, c: 1.0 }, Predators { a: 2.0, b: 1.0, c: 1.0 });
    alike(flow, DiscreteGradient);
    alike(field, DiscreteGradient);
    alike(field, FourthOrder(DiscreteGradient));
}

fn alike<S, M>(system: S, method: M)
where
    S: PhaseSpace<State = FlowState<[f64; 2]>>,
    M: Method<S>,
{
    let mut plain = Integrator::new(system, method, PREDATORS / 50.0, FlowState::new([1.0, 0.5]));
    let mut compensated = Integrator::new(system, method, PREDATORS / 50.0, FlowState::new([1.0, 0.5])).compensated();
    for _ in 0..300 {
        plain.step().and_then(|()| compensated.step()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(plain.state().x, compensated.state().x, "{}, step {}", method.name(), plain.steps());
    }
}

/// 10⁸ steps, 50 a period: roundings of the integral, 4·10⁻¹⁷ a step, would be 4·10⁻¹³ at the end. They are taken away.
#[test]
#[ignore = "minutes, in a build that is optimised"]
fn roundings_of_integrals_do_not_add_up() {
    let (flow, field) = (LotkaVolterra { a: 2.0, b: 1.0, c: 1.0 }, Predators { a: 2.0, b: 1.0, c: 1.0 });
    stays(field, FourthOrder(DiscreteGradient), field);
    stays(flow, DiscreteGradient, field);
    stays(field, DiscreteGradient, field);
}

fn stays<S, M>(system: S, method: M, field: Predators)
where
    S: PhaseSpace<State = FlowState<[f64; 2]>>,
    M: Method<S>,
{
    let mut sim = Integrator::new(system, method, PREDATORS / 50.0, FlowState::new([1.0, 0.5]));
    let start = field.wealth(&sim.state());
    let mut largest = 0.0_f64;
    for _ in 0..1000 {
        sim.advance(100_000).unwrap_or_else(|error| panic!("{error}"));
        largest = largest.max((field.wealth(&sim.state()) / start - 1.0).abs());
    }
    println!("{}: {largest:.1e}", method.name());
    assert!(largest < 3e-15, "{}: {largest:e}", method.name());
}
