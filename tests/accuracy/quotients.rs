//! The purpose of divided differences. The same steps with quotients of differences are compared with figures of another program.
//!
//! Both forms keep the energy, because quotients telescope. Quotients lose accuracy of the trajectory: a step rounds them by ε H/|increment|. This
//! error grows with shorter steps and with a larger H, including all parts of H unrelated to the motion.
//!
//! The figures are rounding errors, and no two programs round alike. Most figures can be compared only in their order of magnitude. The numbers of
//! iterations, 3 and 7, are left out: they follow from the way that program ends its iterations.

use geoint_runtime::prelude::*;
use geoint_tests::measure::distance;
use geoint_tests::problems::flat;
use geoint_tests::scalars::Double;

/// A pendulum beside something else that has an energy.
#[hamiltonian]
fn pendulum(q: f64, p: f64, background: f64) -> f64 {
    p * p / 2.0 - q.cos() + background
}

const START: (f64, f64) = (1.5, 0.0);

/// Iterations of a quotient whose noise does not let it converge.
const MOST: u32 = 7;

fn energy(q: f64, p: f64) -> f64 {
    p * p / 2.0 - q.cos()
}

/// The step with T and V as slopes of theirs: q₁ = q + hT[p, p₁], p₁ = p − hV[q, q₁], by a fixed point in the increments.
fn step(
    h: f64,
    (q, p): (f64, f64),
    kinetic: impl Fn(f64, f64, f64) -> f64,
    potential: impl Fn(f64, f64, f64) -> f64,
) -> (f64, f64) {
    let (mut dq, mut dp) = (h * p, -h * q.sin());
    for _ in 0..MOST {
        let before = (dq, dp);
        dq = h * kinetic(p, p + dp, q + dq);
        dp = -h * potential(q, q + dq, p);
        if (dq - before.0).abs().max((dp - before.1).abs()) <= 4.0 * f64::EPSILON {
            break;
        }
    }
    (q + dq, p + dp)
}

/// Slopes of T and V each, by quotients.
fn termwise(h: f64, x: (f64, f64)) -> (f64, f64) {
    let quotient = |f: fn(f64) -> f64, a: f64, b: f64, limit: f64| if a == b { limit } else { (f(b) - f(a)) / (b - a) };
    step(h, x, |p, p1, _| quotient(|p| p * p / 2.0, p, p1, p), |q, q1, _| quotient(|q| -q.cos(), q, q1, q.sin()))
}

/// Quotients of H.
fn whole(h: f64, x: (f64, f64), background: f64) -> (f64, f64) {
    let all = |q: f64, p: f64| energy(q, p) + background;
    step(
        h,
        x,
        |p, p1, q1| if p == p1 { p } else { (all(q1, p1) - all(q1, p)) / (p1 - p) },
        |q, q1, p| if q == q1 { q.sin() } else { (all(q1, p) - all(q, p)) / (q1 - q) },
    )
}

/// Largest error of the energy on the way, and the end.
fn run(steps: usize, mut next: impl FnMut((f64, f64)) -> (f64, f64)) -> (f64, (f64, f64)) {
    let mut x = START;
    let drift = (0..steps).fold(0.0, |largest: f64, _| {
        x = next(x);
        largest.max((energy(x.0, x.1) - energy(START.0, START.1)).abs())
    });
    (drift, x)
}

fn generated(h: f64, steps: usize, background: f64) -> (f64, (f64, f64)) {
    let mut sim = Pendulum { background }.integrator(DiscreteGradient, h, State::new(START.0, START.1));
    run(steps, |_| {
        sim.step().unwrap();
        (sim.state().q, sim.state().p)
    })
}

fn gap(a: (f64, f64), b: (f64, f64)) -> f64 {
    distance(&[a.0, a.1], &[b.0, b.1])
}

/// Compares trajectories with the same steps in numbers of twice the length. Slopes lose less than the slopes of the other program, whose sums are
/// not compensated. Quotients lose more in shorter steps.
#[test]
fn trajectories_keep_their_digits() {
    for (h, steps, by_quotients, by_slopes) in [
        (1e-2, 2000, 0.0..1.2e-13, 2.2e-14),
        (1e-3, 5000, 0.0..1.2e-13, 7.2e-15),
        (1e-4, 5000, 0.9e-13..1.3e-13, 8.2e-15),
        (1e-5, 5000, 1.4e-12..1.8e-12, 8.1e-15),
    ] {
        let start = State::new(Double::from(START.0), Double::from(START.1));
        let system = Pendulum { background: Double::from(0.0) };
        let mut exact = Integrator::new(system, DiscreteGradient, Double::from(h), start);
        exact.advance(steps as u64).unwrap();
        let exact: Vec<f64> = flat(&exact.state()).iter().map(|x| x.value()).collect();
        let (drift, end) = generated(h, steps, 0.0);
        let (quotient_drift, quotient_end) = run(steps, |x| termwise(h, x));
        let [error, quotient_error] = [end, quotient_end].map(|end| gap(end, (exact[0], exact[1])));
        println!("h = {h:.0e}: energy {drift:.1e} {quotient_drift:.1e}, trajectory {error:.1e} {quotient_error:.1e}");
        assert!(drift <= 7.4e-15 && quotient_drift <= 1e-14, "h = {h}: {drift:.1e} {quotient_drift:.1e}");
        assert!(error <= 0.1 * by_slopes, "h = {h}: {error:.1e}");
        assert!(by_quotients.contains(&quotient_error), "h = {h}: {quotient_error:.1e}");
    }
}

/// A constant in the energy changes no bit of the motion. A quotient of H loses digits to it.
#[test]
fn what_does_not_move_is_not_seen() {
    let (h, steps) = (1e-3, 3000);
    let (drift, end) = generated(h, steps, 0.0);
    assert!(drift <= 5.9e-15, "{drift:.1e}");
    for (background, expected_drift, expected_gap) in
        [(0.0, 4.2e-15, 9e-14), (1e3, 2.6e-12, 1.3e-10), (1e6, 5.4e-9, 2.7e-8)]
    {
        assert_eq!(generated(h, steps, background), (drift, end), "background {background}");
        let (lost, quotient_end) = run(steps, |x| whole(h, x, background));
        let apart = gap(end, quotient_end);
        println!("background {background:.0e}: {lost:.1e}, {apart:.1e}");
        // How much of the noise is left depends on where the iteration ends.
        assert!((0.05..4.0).contains(&(lost / expected_drift)), "background {background}: {lost:.1e}");
        assert!((0.25..4.0).contains(&(apart / expected_gap)), "background {background}: {apart:.1e}");
    }
}
