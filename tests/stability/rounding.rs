//! Benefits of divided differences without cancellation: small steps, large constants in the energy, very long runs.

use geoint_runtime::method::{Method, Observer, Probe, Step};
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Plain, Point};
use geoint_tests::measure::distance;
use geoint_tests::problems::flat;
use geoint_tests::scalars::Double;

/// A pendulum, and what else there is in the world.
#[hamiltonian]
fn swing(q: f64, p: f64, m: f64, g: f64, rest: f64) -> f64 {
    p * p / (2.0 * m) - m * g * q.cos() + rest
}

const START: (f64, f64) = (1.5, 0.0);

/// Takes the scheme without divided differences, by fixed-point iteration. It uses the quotient (H(q₁) − H(q₀))/(q₁ − q₀), and the derivative in place of
/// 0/0.
fn by_quotients(rest: f64, h: f64, steps: usize) -> (f64, f64) {
    let potential = |q: f64| rest - q.cos();
    let (mut q, mut p) = START;
    for _ in 0..steps {
        let mut dq = h * p;
        for _ in 0..7 {
            let slope = if dq == 0.0 { q.sin() } else { (potential(q + dq) - potential(q)) / dq };
            dq = h * (p - 0.5 * h * slope);
        }
        let slope = if dq == 0.0 { q.sin() } else { (potential(q + dq) - potential(q)) / dq };
        (q, p) = (q + dq, p - h * slope);
    }
    (q, p)
}

/// Compares with the same scheme in double-double arithmetic. The difference is rounding alone.
#[test]
fn small_steps_do_not_cost_digits() {
    let mut before = 0.0;
    for (h, steps) in [(1e-3, 5000), (1e-5, 5000)] {
        let system = Swing { m: 1.0, g: 1.0, rest: 0.0 };
        let mut sim = system.integrator(DiscreteGradient, h, State::new(START.0, START.1));
        sim.advance(steps).unwrap();
        let one = Double::from(1.0);
        let exact = Swing { m: one, g: one, rest: one - one };
        let start = State::new(Double::from(START.0), Double::from(START.1));
        let mut exact = Integrator::new(exact, DiscreteGradient, Double::from(h), start);
        exact.advance(steps).unwrap();
        let exact = flat(&exact.state());
        let error = |q: f64, p: f64| distance(&[Double::from(q), Double::from(p)], &exact);
        let own = error(sim.state().q, sim.state().p);
        assert!(own <= 2e-14, "h = {h}: {own:.1e}");
        // Quotients lose more digits, and more of them for smaller steps.
        let (q, p) = by_quotients(0.0, h, steps as usize);
        assert!(error(q, p) > 4.0 * own && error(q, p) > before, "h = {h}: {:.1e}", error(q, p));
        before = error(q, p);
    }
}

/// A large constant in the energy has no effect on the steps.
#[test]
fn energy_in_the_background() {
    struct Count(u64);
    impl Observer for Count {
        fn pause(&mut self, _: bool) {}
    }

    impl Probe<Swing, f64> for Count {
        fn visit(&mut self, _: f64, _: &[[f64; 1]; 2], _: &()) {
            self.0 += 1;
        }
    }
    let moving = |q: f64, p: f64| p * p / 2.0 - q.cos();
    let (rest, h, steps) = (1e6, 1e-3, 3000);
    let system = Swing { m: 1.0, g: 1.0, rest };
    let prepared = Method::<Swing>::prepare(&DiscreteGradient, &system, h);
    let mut x = Point::<[[f64; 1]; 2], Plain>::new([[START.0], [START.1]]);
    let mut memory = <DiscreteGradient as Method<Swing>>::memory(&x.z);
    let mut count = Count(0);
    let mut drift = 0.0_f64;
    for _ in 0..steps {
        let step = Step { system: &system, t: 0.0, end: h, x: &mut x, probe: &mut count };
        <DiscreteGradient as Method<Swing>>::step(&prepared, &mut memory, step).unwrap();
        drift = drift.max((moving(x.z[0][0], x.z[1][0]) - moving(START.0, START.1)).abs());
    }
    assert!(drift <= 2e-14, "{drift:.1e}");
    // Each step evaluates once at its start.
    assert!(count.0 <= 4 * steps, "{} a step", count.0 as f64 / steps as f64);
    let (q, p) = by_quotients(rest, h, steps as usize);
    let lost = (moving(q, p) - moving(START.0, START.1)).abs();
    assert!(lost > 1e-11, "quotients see it: {lost:.1e}");
}

/// In 10⁸ steps, rounding errors would add up to about 10⁻¹³ of the terms of the energy if they were not removed.
#[test]
#[ignore = "takes half a minute in release, and an hour without"]
fn energy_over_a_hundred_million_steps() {
    let system = Swing { m: 1.0, g: 1.0, rest: 0.0 };
    let mut sim = system.integrator(DiscreteGradient, 0.1, State::new(START.0, START.1)).compensated();
    let start = sim.energy();
    let mut largest = 0.0_f64;
    for _ in 0..1000 {
        sim.advance(100_000).unwrap();
        largest = largest.max((sim.energy() - start).abs());
    }
    println!("largest {largest:.1e}");
    assert!(largest <= 3e-15, "{largest:.1e}");
}
