//! Costs of contact systems. S41: estimates of an error. S42: the cost of a step beside Euler's. S53: costs of errors by order.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::{Tallied, Tally};

/// A pendulum with friction.
#[contact_hamiltonian]
fn pendulum(q: f64, p: f64, s: f64, m: f64, gamma: f64) -> f64 {
    p * p / (2.0 * m) - q.cos() + gamma * s
}

const PENDULUM: Pendulum = Pendulum { m: 1.7, gamma: 0.1 };
const DURATION: f64 = 10.0;

type Point = ContactState<f64>;

fn start() -> Point {
    ContactState::new(1.0, 0.5, 0.3)
}

/// q' = p/m, p' = −sin q − γp, s' = p²/(2m) + cos q − γs.
fn swing(x: &[f64]) -> Vec<f64> {
    let Pendulum { m, gamma } = PENDULUM;
    vec![x[1] / m, -x[0].sin() - gamma * x[1], x[1] * x[1] / (2.0 * m) + x[0].cos() - gamma * x[2]]
}

fn after<M: Method<Pendulum>>(method: M, steps: u64) -> Point {
    let mut sim = PENDULUM.integrator(method, DURATION / steps as f64, start());
    sim.advance(steps).expect("steps");
    sim.state()
}

/// Order 12 by three steps of order 10 (H. Yoshida 1990).
fn after_by_order_12(steps: u64) -> Point {
    let outer = 1.0 / (2.0 - 2.0_f64.powf(1.0 / 11.0));
    let h = DURATION / steps as f64;
    let lengths = [outer * h, (1.0 - 2.0 * outer) * h, outer * h];
    let mut sims = lengths.map(|h| PENDULUM.integrator(SofroniouSpaletta10_35.of(StormerVerlet), h, start()));
    let mut x = start();
    for _ in 0..steps {
        for sim in &mut sims {
            sim.set_state(x);
            sim.step().expect("a step");
            x = sim.state();
        }
    }
    x
}

/// Returns the fewest steps that lead to an error below the tolerance, among numbers that grow by a quarter.
fn fewest(after: impl Fn(u64) -> Point, tolerance: f64) -> u64 {
    let exact = extrapolated(|_, x| swing(x), 0.0, vec![1.0, 0.5, 0.3], DURATION, 20);
    let error = |x: Point| (x.q - exact[0]).abs().max((x.p - exact[1]).abs()).max((x.s - exact[2]).abs());
    let numbers = std::iter::successors(Some(1), |n: &u64| Some((n * 5).div_ceil(4)));
    numbers.take(60).find(|n| error(after(*n)) < tolerance).expect("a number of steps")
}

/// Compositions of the step of Störmer and Verlet, orders 2 to 12. For an error of 0.01 the number of forces grows with the order. For 10⁻¹⁰ it falls up to
/// order 10, and order 12 costs more again.
#[test]
fn low_orders_are_cheap_for_rough_results() {
    let forces = |tolerance: f64| {
        macro_rules! by_order {
            ($($method:expr),*) => { [$({
                let forces = Method::<Pendulum>::claims(&$method).forces.expect("a number");
                u64::from(forces) * fewest(|steps| after($method, steps), tolerance)
            }),*, 3 * 35 * fewest(after_by_order_12, tolerance)] };
        }
        by_order!(
            StormerVerlet,
            Suzuki4.of(StormerVerlet),
            Yoshida6a.of(StormerVerlet),
            KahanLi8_17a.of(StormerVerlet),
            SofroniouSpaletta10_35.of(StormerVerlet)
        )
    };
    let [rough, fine] = [1e-2, 1e-10].map(forces);
    assert!(rough.is_sorted() && 2 * rough[0] < rough[4] && 2 * rough[4] < rough[5], "{rough:?}");
    assert!(fine[..5].is_sorted_by(|low, high| low > high) && fine[0] > 100 * fine[1], "{fine:?}");
    assert!(fine[1] > 5 * fine[4] && fine[5] > 2 * fine[4], "{fine:?}");
}

/// A star in hydrostatic equilibrium, with the force a + b q + c q⁵.
#[contact_hamiltonian]
fn star(q: f64, p: f64, s: f64, t: f64, a: f64, b: f64, c: f64) -> f64 {
    p * p / 2.0 + 2.0 / t * s + a * q + b * q * q / 2.0 + c * q.powi(6) / 6.0
}

/// The equations of the star without the action.
#[vector_field]
fn star_by_field(x: [f64; 2], t: f64, a: f64, b: f64, c: f64) -> [f64; 2] {
    [x[1], -2.0 / t * x[1] - a - b * x[0] - c * x[0].powi(5)]
}

/// The star with n = 5.
fn exact(t: f64) -> f64 {
    1.0 / (1.0 + t * t / 3.0).sqrt()
}

/// Operations, a division counted as ten, from t = 0.1 on.
#[test]
fn a_step_of_a_star_costs_less_than_two_of_euler() {
    let [zero, one, h, t] = [0.0, 1.0, 0.01, 0.1].map(Tallied::from);
    let (q, p) = (exact(0.1).into(), (-0.1 / 3.0 * exact(0.1).powi(3)).into());
    let split = Star { a: zero, b: zero, c: one };
    let mut split = split.integrator(ContactSplitting, h, ContactState::at(t, q, p, zero));
    let euler = StarByField { a: zero, b: zero, c: one };
    let mut euler = euler.integrator(ExplicitEuler, h, FlowState::at(t, [q, p]));
    let cost = Tally::during(|| split.advance(1000).expect("steps"));
    let cost_of_euler = Tally::during(|| euler.advance(1000).expect("steps"));
    assert!(
        cost.weight() < 2 * cost_of_euler.weight() && cost_of_euler.weight() > 10_000,
        "{cost:?} {cost_of_euler:?}"
    );
    let error = |t: Tallied, q: Tallied| (q.value() - exact(t.value())).abs();
    let (split, euler) = (split.state(), euler.state());
    let errors = [error(split.t, split.q), error(euler.t, euler.x[0])];
    assert!(errors[0] < 1e-5 && errors[1] > 40.0 * errors[0], "{errors:?}");
}

/// Errors at the end of steps h and h/2 differ by 3/4 of the first one, if the order is 2.
#[test]
fn two_step_sizes_estimate_the_error_of_a_star() -> Result<(), StepError> {
    type Solution = fn(f64) -> f64;
    let stars: [(Star, f64, Solution); 3] = [
        (Star { a: 1.0, b: 0.0, c: 0.0 }, 2.4, |t| 1.0 - t * t / 6.0),
        (Star { a: 0.0, b: 1.0, c: 0.0 }, 3.0, |t| t.sin() / t),
        (Star { a: 0.0, b: 0.0, c: 1.0 }, 10.0, exact),
    ];
    for (system, end, exact) in stars {
        for h in [0.2, 0.1, 0.05] {
            let [whole, half] = [h, h / 2.0].map(|h| {
                let mut sim = system.integrator(ContactSplitting, h, ContactState::new(1.0, 0.0, 0.0));
                sim.advance_to(end).map(|()| sim.state().q)
            });
            let (whole, half) = (whole?, half?);
            let ratio = (whole - half) * 4.0 / 3.0 / (whole - exact(end));
            assert!((ratio - 1.0).abs() < 0.01, "h = {h}: {ratio}");
        }
    }
    // Control: explicit Euler has order 1, so that the estimate is 2/3 of the error.
    let start = FlowState::at(0.1, [exact(0.1), -0.1 / 3.0 * exact(0.1).powi(3)]);
    let [whole, half] = [0.01, 0.005].map(|h| {
        let mut sim = StarByField { a: 0.0, b: 0.0, c: 1.0 }.integrator(ExplicitEuler, h, start);
        sim.advance_to(10.1).map(|()| sim.state().x[0])
    });
    let (whole, half) = (whole?, half?);
    let ratio = (whole - half) * 4.0 / 3.0 / (whole - exact(10.1));
    assert!((ratio - 2.0 / 3.0).abs() < 0.1, "{ratio}");
    Ok(())
}
