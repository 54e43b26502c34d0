//! Methods that keep the energy, with steps far too large or beside a jump of a divided difference: every accepted step keeps the energy.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::Noise;

/// A double well of Duffing's oscillator.
#[hamiltonian]
fn two_wells(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.powi(4) / 4.0 - q * q / 2.0
}

/// A plane with a small force that turns three times as fast as its direction from zero, where that is not defined.
#[hamiltonian]
fn propeller(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + p[1] * p[1] + x * x + y * y) / 2.0 + k * (3.0 * y.atan2(x)).sin() / (1.0 + x * x + y * y)
}

/// A pendulum in single precision.
#[hamiltonian]
fn single_pendulum(q: f32, p: f32, m: f32, c: f32) -> f32 {
    p * p / (2.0 * m) - c * q.cos()
}

/// Returns the number of successful single steps from 500 random starts, and the largest change of the energy relative to its terms.
fn single_steps<M: Method<TwoWells>>(method: M, h: f64) -> (usize, f64) {
    let (mut noise, mut steps, mut worst) = (Noise::new(5), 0, 0.0_f64);
    for _ in 0..500 {
        let [q, p] = [1.5, 1.5].map(|size| size * noise.next().unwrap());
        let mut sim = TwoWells { m: 1.3 }.integrator(method, h, State::new(q, p));
        let start = sim.energy();
        if sim.step().is_ok() {
            let State { q, p, .. } = sim.state();
            steps += 1;
            worst = worst.max((sim.energy() - start).abs() / (1.0 + q.powi(4) + p * p));
        }
    }
    (steps, worst)
}

/// The second form of `FourthOrder` may fall back on a matrix of difference quotients. A quotient over a long way exceeds every derivative. The matrix is
/// then large and the correction small, although the residual is not. The bounds on the energy are a few hundred ε. The bound for `Gonzalez`, which divides
/// by the increment, is ten times as large.
#[test]
fn a_small_correction_by_a_large_matrix_is_no_solution() {
    for h in [1.4, 2.0, 3.0] {
        let (steps, worst) = single_steps(FourthOrder(MeanValue::<2>), h);
        assert!(steps >= 490 && worst <= 1e-13, "h {h}: {steps} steps, {worst:.1e}");
        let (steps, worst) = single_steps(FourthOrder(Gonzalez), h);
        assert!(steps >= 480 && worst <= 1e-12, "h {h}: {steps} steps, {worst:.1e}");
    }
    // Control: a method that does not keep the energy.
    assert!(single_steps(ImplicitMidpoint, 2.0).1 > 1e-3);
}

/// The divided difference of `atan2` jumps where the direction turns by half a turn within the step. Steps from this grid pass near the origin. Before the
/// energy was checked, some of them ended on the jump.
#[test]
fn a_jump_of_a_divided_difference_is_no_solution() {
    let mut steps = 0;
    for i in -30..=30 {
        for j in -30..=30 {
            let start = State::new([-0.048 + 2e-3 * f64::from(i), -0.022 + 2e-3 * f64::from(j)], [1.16, 0.565]);
            let mut sim = Propeller { k: -0.015 }.integrator(FourthOrder(DiscreteGradient), 0.06, start);
            let energy = sim.energy();
            if sim.step().is_ok() {
                steps += 1;
                let change = (sim.energy() - energy).abs();
                assert!(change <= 1e-13, "from {start:?}: {change:.1e}");
            }
        }
    }
    assert!(steps > 3000, "{steps} steps");
}

/// The check of the energy leaves room for the rounding of forces that cancel. In single precision this room must stay far below the energy itself.
#[test]
fn steps_in_single_precision_keep_the_energy() {
    let (mut noise, mut steps) = (Noise::new(9), 0);
    let mut random = |size: f64| (size * noise.next().unwrap()) as f32;
    for h in [0.5, 3.0, 10.0] {
        for _ in 0..300 {
            let system = SinglePendulum { m: 1.2 + random(1.0), c: random(1.0) };
            let mut sim = system.integrator(DiscreteGradient, h, State::new(random(3.0), random(1.0)));
            let start = sim.energy();
            for _ in 0..20 {
                if sim.step().is_err() {
                    break;
                }
                steps += 1;
                let State { q, p, .. } = sim.state();
                let terms = 1.0 + system.c.abs() * q.abs() + p * p / system.m;
                let change = (sim.energy() - start).abs();
                assert!(change <= 1e-3 * terms, "{system:?}, h {h}: {change:.1e}");
            }
        }
    }
    assert!(steps > 10_000, "{steps} steps");
}
