//! The series has the requested order.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Of second order: momenta are velocities.
#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - q.cos()
}

/// Of first order.
#[vector_field]
fn predators(x: [f64; 2], a: f64) -> [f64; 2] {
    [x[0] * (a - x[1]), x[1] * (x[0] - 1.0)]
}

/// A spring on one side, a stiffer one on the other.
#[hamiltonian]
fn two_springs(q: f64, p: f64) -> f64 {
    p * p / 2.0 + if q > 0.0 { q * q / 2.0 } else { 2.0 * q * q }
}

const PENDULUM: Pendulum = Pendulum { m: 1.3 };
const PREDATORS: Predators = Predators { a: 1.1 };

macro_rules! orders {
    ($check:ident: $($order:literal)*) => { $($check::<$order>();)* };
}

/// A smaller tolerance shortens the step by the root of the given order, so a higher order takes fewer steps. Regression test: the second-lowest order took
/// the steps of the lowest order.
#[test]
fn steps_have_the_order_of_the_series() {
    fn check<const P: usize>() {
        let tolerances: [f64; 2] = [1e-4, 1e-10];
        let order = |steps: [f64; 2]| (tolerances[0] / tolerances[1]).ln() / (steps[0] / steps[1]).ln();
        let steps = tolerances.map(|tolerance| {
            let mut sim = PENDULUM.taylor(TaylorOrder::<P> { tolerance }, State::new(0.7, 0.9));
            sim.step().map(|()| sim.last_step()).unwrap()
        });
        // Logarithms of step sizes give the order only approximately.
        assert!((order(steps) / P as f64 - 1.0).abs() < 0.01, "{P}: {}", order(steps));
        let steps = tolerances.map(|tolerance| {
            let mut sim = PREDATORS.taylor(TaylorOrder::<P> { tolerance }, FlowState::new([0.7, 0.9]));
            sim.step().map(|()| sim.last_step()).unwrap()
        });
        assert!((order(steps) / P as f64 - 1.0).abs() < 0.01, "{P}: {}", order(steps));
    }
    orders!(check: 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30);
}

/// Errors at a fixed time follow the order, with steps of fixed length and with steps from a tolerance.
#[test]
fn errors_have_the_order_of_the_series() {
    fn check<const P: usize>() {
        let (time, gap) = (5.0, |x: [f64; 2], y: [f64; 2]| (x[0] - y[0]).abs().max((x[1] - y[1]).abs()));
        let of_pendulum = |state: State<f64>| [state.q, state.p];
        let mut exact = PENDULUM.taylor(Taylor::default(), State::new(0.7, 0.9));
        exact.advance_to(time).unwrap();
        let errors = [100.0, 200.0].map(|steps| {
            let mut sim = PENDULUM.taylor(TaylorFixed::<P> { h: time / steps }, State::new(0.7, 0.9));
            sim.advance_to(time).map(|()| gap(of_pendulum(sim.state()), of_pendulum(exact.state()))).unwrap()
        });
        assert!(((errors[0] / errors[1]).log2() - P as f64).abs() < 0.3, "{P}: {errors:?}");
        let mut exact = PREDATORS.taylor(Taylor::default(), FlowState::new([0.7, 0.9]));
        exact.advance_to(time).unwrap();
        let runs = [1e-4, 1e-6].map(|tolerance| {
            let mut sim = PREDATORS.taylor(TaylorOrder::<P> { tolerance }, FlowState::new([0.7, 0.9]));
            sim.advance_to(time).map(|()| (sim.steps() as f64, gap(sim.state().x, exact.state().x))).unwrap()
        });
        let order = (runs[0].1 / runs[1].1).ln() / (runs[1].0 / runs[0].0).ln();
        assert!((order - P as f64).abs() < 0.5, "{P}: {runs:?}");
    }
    orders!(check: 2 3 4 5 6 7);
}

/// The first term of a series contains no information on its error. Regression test: the lowest order crept away from a zero of the momentum, because its
/// steps relied on this term.
#[test]
fn the_lowest_orders_go_on() {
    let spring = TwoSprings.taylor(TaylorOrder::<2> { tolerance: 1e-6 }, State::new(1.0, 0.0));
    let (mut second, mut third) =
        (spring.steps_at_most(100_000), TwoSprings.taylor(TaylorOrder::<3> { tolerance: 1e-6 }, State::new(1.0, 0.0)));
    for t in [0.1, 1.0] {
        second.advance_to(t).unwrap_or_else(|error| panic!("{error}"));
        third.advance_to(t).unwrap();
        assert!((second.state().q - third.state().q).abs() < 1e-3, "{:?} {:?}", second.state(), third.state());
    }
}
