//! Statements of Aung's thesis (2000) without another test or example, one by one. `tests/STATEMENTS.md` lists all statements.

use geoint_runtime::Hamiltonian;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A particle in coordinates that turn: x = q₁ cos ωt − q₂ sin ωt, and so on, in T = ½m|x'|² and in V = k|x|⁴.
#[lagrangian]
fn turning(q: [f64; 2], v: [f64; 2], m: f64, omega: f64, k: f64) -> f64 {
    let square = q[0] * q[0] + q[1] * q[1];
    m / 2.0 * (v[0] * v[0] + v[1] * v[1]) + m * omega * (q[0] * v[1] - q[1] * v[0]) + m / 2.0 * omega * omega * square
        - k * square * square
}

/// The same particle at rest in space.
#[lagrangian]
fn resting(q: [f64; 2], v: [f64; 2], m: f64, k: f64) -> f64 {
    m / 2.0 * (v[0] * v[0] + v[1] * v[1]) - k * (q[0] * q[0] + q[1] * q[1]).powi(2)
}

/// 2.1.1 to 2.1.10 and before 2.2.13: T₂ + T₁ + T₀ by degree in v, p = ∂T/∂v, H = T₂ − T₀ + V. 2.1.11 to 2.1.22: Lagrange's equations are the
/// equations of the particle in all coordinates.
#[test]
fn kinetic_energies_by_degree() -> Result<(), StepError> {
    let (m, omega, k) = (1.3, 0.7, 0.4);
    let (system, still) = (Turning { m, omega, k }, Resting { m, k });
    let (q, v) = ([0.8, -0.3], [0.2, 0.9]);
    let start = system.at(q, v);
    let momenta = [m * (v[0] - omega * q[1]), m * (v[1] + omega * q[0])];
    let square: f64 = q.iter().map(|q| q * q).sum();
    let [second, zeroth] = [m / 2.0 * v.iter().map(|v| v * v).sum::<f64>(), m / 2.0 * omega * omega * square];
    for i in 0..2 {
        assert!((start.p[i] - momenta[i]).abs() < 1e-15, "{:?}", start.p);
    }
    assert!((system.energy(&start) - (second - zeroth + k * square * square)).abs() < 1e-15);

    let mut turned = system.integrator(Gauss::<6>, 0.05, start);
    let mut fixed = still.integrator(Gauss::<6>, 0.05, still.at(q, [v[0] - omega * q[1], v[1] + omega * q[0]]));
    turned.advance(60)?;
    fixed.advance(60)?;
    let (sin, cos) = (omega * turned.time()).sin_cos();
    let [a, b] = turned.state().q;
    let [x, y] = fixed.state().q;
    assert!((cos * a - sin * b - x).abs() < 1e-12 && (sin * a + cos * b - y).abs() < 1e-12);
    Ok(())
}

/// A particle in spherical coordinates r, θ, φ.
#[lagrangian]
fn spherical(q: [f64; 3], v: [f64; 3], m: f64, k: f64) -> f64 {
    let [r, theta, _] = q;
    let sin = theta.sin();
    m / 2.0 * (v[0] * v[0] + r * r * v[1] * v[1] + r * r * sin * sin * v[2] * v[2]) + k / r
}

/// The example after 2.2.12: its six canonical equations.
#[test]
fn a_particle_in_spherical_coordinates() {
    let (m, k) = (1.3, 0.6);
    let system = Spherical { m, k };
    let ([r, theta, phi], [a, b, c]) = ([1.7_f64, 0.9, 0.3], [0.2_f64, -0.5, 0.8]);
    let mut slopes = [[0.0_f64; 3]; 2];
    system.gradient(0.0, &[[r, theta, phi], [a, b, c]], &mut slopes);
    let (sin, cos) = theta.sin_cos();
    let velocities = [a / m, b / (m * r * r), c / (m * r * r * sin * sin)];
    let forces = [
        (b * b + c * c / (sin * sin)) / (m * r * r * r) - k / (r * r),
        c * c * cos / (m * r * r * sin * sin * sin),
        0.0,
    ];
    for i in 0..3 {
        assert!((slopes[1][i] - velocities[i]).abs() < 1e-15, "{i}");
        assert!((slopes[0][i] + forces[i]).abs() < 1e-15, "{i}");
    }
}

/// Example 2.2.6: a mass on a spring.
#[test]
fn a_mass_on_a_spring() {
    #[lagrangian]
    fn spring(q: f64, v: f64, m: f64, k: f64) -> f64 {
        m * v * v / 2.0 - k * q * q / 2.0
    }
    let system = Spring { m: 1.3, k: 2.1 };
    let state = system.at(0.4, 0.7);
    assert!((state.p - 1.3 * 0.7).abs() < 1e-16);
    assert!((system.energy(&state) - (state.p * state.p / 2.6 + 2.1 * 0.08)).abs() < 1e-15);
    assert!(Spring::<f64>::REPORT.contains("H = "));
    let mut sim = system.integrator(StormerVerlet, 0.1, state);
    assert!(sim.advance(10).is_ok());
}

/// A mass on a hard spring under a force that depends on time.
#[hamiltonian]
fn pushed(q: f64, p: f64, t: f64, m: f64, k: f64, f: f64) -> f64 {
    p * p / (2.0 * m) + k * q.powi(4) / 4.0 - f * (1.7 * t).sin() * q
}

/// 3.1.1 to 3.1.7: E₁ = E₀ + (d₁ − d₀)·F with F at the middle of the step, where the thesis takes the mean of both ends; and 2.2.14,
/// dH/dt = ∂H/∂t.
#[test]
fn the_work_of_a_force_is_what_the_energy_gains() -> Result<(), StepError> {
    let (m, k, f, h) = (1.3, 0.9, 0.6, 0.1);
    let system = Pushed { m, k, f };
    let energy = |state: &State<f64>| state.p * state.p / (2.0 * m) + k * state.q.powi(4) / 4.0;
    let force = |t: f64| f * (1.7 * t).sin();
    let mut sim = system.integrator(DiscreteGradient, h, State::at(0.2, 0.8, 0.1));
    let mut furthest = 0.0_f64;
    for _ in 0..100 {
        let before = sim.state();
        sim.step()?;
        let after = sim.state();
        let gained = energy(&after) - energy(&before);
        let moved = after.q - before.q;
        assert!((gained - moved * force(before.t + h / 2.0)).abs() < 2e-15, "{gained:e}");
        furthest = furthest.max((gained - moved * (force(before.t) + force(after.t)) / 2.0).abs());
    }
    // The mean of both ends is another force, by h²F''/8.
    assert!((1e-5..1e-3).contains(&furthest), "{furthest:e}");

    let mut exact = system.integrator(Gauss::<6>, 1e-3, State::at(0.2, 0.8, 0.1));
    let start = exact.state();
    exact.advance(2)?;
    let end = exact.state();
    let middle: f64 = 0.2 + 1e-3;
    let rate = (system.energy(&end) - system.energy(&start)) / 2e-3;
    let explicit = -f * 1.7 * (1.7 * middle).cos() * (start.q + end.q) / 2.0;
    assert!((rate - explicit).abs() < 1e-6, "{rate} {explicit}");
    Ok(())
}

/// Example 3.1.1: on an oscillator divided differences are the implicit midpoint rule, 3.1.15 and 3.1.16; the phase curve is an ellipse.
#[test]
fn an_oscillator_stays_on_its_ellipse() -> Result<(), StepError> {
    #[hamiltonian]
    fn oscillator(q: f64, p: f64, m: f64, k: f64) -> f64 {
        p * p / (2.0 * m) + k * q * q / 2.0
    }
    let (system, start) = (Oscillator { m: 1.3, k: 2.1 }, State::new(0.8, -0.4));
    let mut divided = system.integrator(CoordinateIncrement::default(), 0.3, start);
    let mut midpoint = system.integrator(ImplicitMidpoint, 0.3, start);
    for _ in 0..200 {
        divided.step()?;
        midpoint.step()?;
        let (a, b) = (divided.state(), midpoint.state());
        assert!((a.q - b.q).abs() < 1e-13 && (a.p - b.p).abs() < 1e-13, "{a:?} {b:?}");
        assert!((system.energy(&a) - system.energy(&start)).abs() < 1e-15);
    }
    Ok(())
}

/// The figure to example 3.1.2: phase curves of x'' = −x − x³ within 0.03 of the origin, by a Runge–Kutta method: circles but for a⁴/2.
#[test]
fn small_orbits_of_duffing_are_circles() -> Result<(), StepError> {
    #[vector_field]
    fn duffing(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0] - x[0].powi(3)]
    }
    for a in [0.01_f64, 0.02, 0.03] {
        let mut sim = Duffing.integrator(RK4, 0.01, FlowState::new([a, 0.0]));
        let mut furthest = 0.0_f64;
        for _ in 0..700 {
            sim.step()?;
            let [x, y] = sim.state().x;
            furthest = furthest.max((x * x + y * y - a * a).abs());
        }
        assert!((furthest / (a.powi(4) / 2.0) - 1.0).abs() < 1e-2, "{furthest:e}");
    }
    Ok(())
}
