//! Steps so long that the explicit guess is useless. The solver finds the solution that is continuous in h, if it exists.
//!
//! With one degree of freedom, q₁ − q₀ − h p₀/m + h²/2m V[q₀, q₁] = 0 is the equation of every discrete gradient. If V is convex its left
//! side grows with q₁: one solution, found here by bisection.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Hamiltonian, Method};

#[hamiltonian]
fn hard_spring(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + 2500.0 * q * q * q * q
}

#[hamiltonian]
fn pole(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + 0.3 / q
}

#[hamiltonian]
fn logarithmic_wall(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - 0.3 * q.ln() + q
}

#[hamiltonian]
fn soft_wall(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + (-4.0 * q).exp() + q
}

const MASS: f64 = 1.3;

/// Returns the end of a step by bisection between `low` and 10⁴.
fn bisection(v: fn(f64) -> f64, low: f64, (q, p): (f64, f64), h: f64) -> f64 {
    let excess = |end: f64| {
        let slope = if end == q { 0.0 } else { (v(end) - v(q)) / (end - q) };
        end - q - h * p / MASS + h * h / (2.0 * MASS) * slope
    };
    let (mut low, mut high) = (low, 1e4);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        // An overflowing slope counts as the slope of a wall.
        if excess(middle) > 0.0 { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

fn check<S, M>(name: &str, system: S, method: M, v: fn(f64) -> f64, low: f64, starts: &[(f64, f64)], steps: &[f64])
where
    S: Hamiltonian<f64, Coordinates = f64>,
    M: Method<S, f64>,
{
    for &(q, p) in starts {
        for &h in steps {
            let expected = bisection(v, low, (q, p), h);
            let mut sim = system.integrator(method, h, State::new(q, p));
            let outcome = sim.step();
            // Skips ends next to the boundary of the domain, where q₀ + (q₁ − q₀) loses all digits.
            if expected - low < 1e-8 {
                continue;
            }
            assert_eq!(outcome, Ok(()), "{name}: h = {h} from {q}, {p}, expected {expected}");
            let error = (sim.state().q - expected).abs();
            assert!(
                error <= 1e-6 * (q.abs() + expected.abs()),
                "{name}: h = {h} from {q}, {p}: {} {expected}",
                sim.state().q
            );
        }
    }
}

#[test]
fn solutions_far_from_the_guess() {
    let walls = [(0.05, -8.0), (0.05, 2.0), (0.2, -3.0), (0.6, -1.0), (1.0, -8.0), (2.0, -3.0), (2.0, 0.5)];
    let wells = [(-2.9, -5.0), (-1.1, 3.1), (0.2, 0.4), (0.7, -5.0), (2.2, 1.3)];
    let steps = [0.05, 0.1, 0.31, 0.8, 1.3, 3.0];
    macro_rules! rows {
        ($($method:expr),*) => { $(
            let name = stringify!($method);
            check(name, HardSpring { m: MASS }, $method, |q| 2500.0 * q.powi(4), -1e4, &wells, &[0.01, 0.1, 1.0, 10.0]);
            check(name, Pole { m: MASS }, $method, |q| 0.3 / q, 0.0, &walls, &steps);
            check(name, LogarithmicWall { m: MASS }, $method, |q| -0.3 * q.ln() + q, 0.0, &walls, &steps);
            check(name, SoftWall { m: MASS }, $method, |q| (-4.0 * q).exp() + q, -170.0, &wells, &steps);
        )* };
    }
    rows!(DiscreteGradient, SymmetrisedItohAbe, MeanValue::<2>, CoordinateIncrement::default());
}

/// From h V'' < −4m on, beside a maximum, the solution turns round: refused, by each method that has it.
#[hamiltonian]
fn hill(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - q * q / 2.0 + 0.01 * q * q * q * q
}

#[test]
fn solutions_that_turned_round() {
    macro_rules! rows {
        ($($method:expr),*) => { $( {
            let start = State::new(0.01, 0.003);
            let mut sim = Hill { m: 1.0 }.integrator($method, 1.9, start);
            assert_eq!(sim.step(), Ok(()), stringify!($method));
            assert!(sim.state().q > start.q);
            for h in [2.1, 2.5] {
                let mut sim = Hill { m: 1.0 }.integrator($method, h, start);
                // Another solution lies in the valley beyond.
                match sim.step() {
                    Ok(()) => assert!(sim.state().q > 1.0, "{}: {:?}", stringify!($method), sim.state()),
                    Err(error) => {
                        assert!(matches!(error, StepError { failure: Failure::Singular, .. }), "{}: {error}", stringify!($method));
                        assert_eq!(sim.state(), start);
                    }
                }
            }
        } )* };
    }
    rows!(
        DiscreteGradient,
        MeanValue::<2>,
        Gonzalez,
        SymmetrisedItohAbe,
        CoordinateIncrement::default(),
        ImplicitMidpoint
    );
}

/// A fast oscillator beside a slow one: of the mean of p, which an impulse turns round, a step as long as this leaves no digits.
#[hamiltonian]
fn fast_and_slow(q: [f64; 2], p: [f64; 2], w: f64, c: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + w * w * q[0] * q[0]) / 2.0 + c * q[0] * q[1] + q[1] * q[1]
}

#[test]
fn energies_of_steps_longer_than_oscillations() {
    let (w, start) = (1e6, State::new([1e-6, 1.0], [1.0, 0.3]));
    for c in [0.0, 1.0] {
        for h in [1e-7, 1e-4, 0.01, 1.0, 10.0, 1e4, 1e8] {
            macro_rules! check {
                ($($method:expr),*) => { $( for h in [h, -h] {
                    let mut sim = FastAndSlow { w, c }.integrator($method, h, start);
                    let energy = sim.energy();
                    assert_eq!(sim.advance(1000), Ok(()), "{h:e}");
                    let error = (sim.energy() / energy - 1.0).abs();
                    // Bound: two roundings in each of the five substeps of a step.
                    assert!(error < 1000.0 * 10.0 * f64::EPSILON, "{} h = {h:e}: {error:e}", stringify!($method));
                } )* };
            }
            check!(DiscreteGradient, Suzuki4.of(DiscreteGradient));
        }
    }
}
