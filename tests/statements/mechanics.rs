//! T48: an integrand F(x, y') without y. T9: kinetic energies in coordinates x = x(q, t), by the chain rule. T22: spherical coordinates.

use geoint_runtime::Hamiltonian;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Length in the half-plane of Poincaré, with x in place of the time.
#[lagrangian(q = _y, v = slope, t = x)]
fn length(_y: f64, slope: f64, x: f64) -> f64 {
    (1.0 + slope * slope).sqrt() / x
}

/// An integrand that also contains y: a control.
#[lagrangian(t = x)]
fn pulled_length(q: f64, v: f64, x: f64) -> f64 {
    (1.0 + v * v).sqrt() / x - 0.3 * q
}

/// T48, Euler's case I: if F(x, y') does not contain y, then ∂F/∂y' = y'/(x√(1 + y'²)) is constant, also if F contains x. The extremals are circles.
#[test]
fn the_momentum_is_constant_if_y_is_absent() -> Result<(), StepError> {
    let (x, y, p) = (0.3_f64, 0.2, 0.8);
    let slope = p * x / (1.0 - p * p * x * x).sqrt();
    let start = Length.at_time(x, y, slope);
    assert!((start.p - p).abs() < 2e-16, "{}", start.p);
    macro_rules! keeps {
        ($($method:expr),*) => { $(
            let mut sim = Length.integrator($method, 0.01, start);
            sim.advance(70)?;
            assert_eq!(sim.state().p, start.p, "{}", stringify!($method));
        )* };
    }
    keeps!(ImplicitMidpoint, Gauss::<3>, DiscreteGradient, RK4);
    let mut control = PulledLength.integrator(Gauss::<3>, 0.01, PulledLength.at_time(x, y, slope));
    let first = control.state().p;
    control.advance(70)?;
    assert!((control.state().p - first).abs() > 0.1, "{}", control.state().p);

    let mut sim = Length.integrator(Gauss::<6>, 0.01, start);
    sim.advance(70)?;
    let end = sim.state();
    assert!((end.t - 1.0).abs() < 1e-15 && (end.q - 0.663_466_109_951_159_6).abs() < 1e-13, "{end:?}");
    assert!((sim.velocity() - 4.0 / 3.0).abs() < 1e-13, "{}", sim.velocity());
    Ok(())
}

/// A pendulum on a pivot that moves. The first lines are x' = ∂x/∂q q' + ∂x/∂t.
#[lagrangian]
fn moving_pivot(q: f64, v: f64, t: f64, m: f64, l: f64, pivot: [f64; 2]) -> f64 {
    let across = 2.0 * pivot[0] * (2.0 * t).cos() + l * q.cos() * v;
    let upwards = -4.0 * pivot[1] * (4.0 * t).sin() + l * q.sin() * v;
    m * (across * across + upwards * upwards) / 2.0
}

/// T9 and T10: x = x(q, t) gives T = T₂ + T₁ + T₀ of degrees 2, 1 and 0 in q', with T₂ = ½m|∂x/∂q|²q'², T₁ = m ∂x/∂q·∂x/∂t q', T₀ = ½m|∂x/∂t|².
#[test]
fn the_chain_rule_gives_three_kinetic_energies() {
    let (q, v, t) = (0.7, 0.4, 0.3);
    let parts = |pivot: [f64; 2]| {
        let system = MovingPivot { m: 0.8, l: 1.2, pivot };
        let kinetic = |v: f64| system.lagrangian(t, q, v);
        let (rest, even, odd) = (kinetic(0.0), (kinetic(v) + kinetic(-v)) / 2.0, (kinetic(v) - kinetic(-v)) / 2.0);
        let state = system.at_time(t, q, v);
        // H = T₂ − T₀, and p q' = 2T₂ + T₁.
        let energy = system.energy(&state) - (even - 2.0 * rest);
        let momentum = state.p * v - (2.0 * (even - rest) + odd);
        assert!(energy.abs() < 1e-15 && momentum.abs() < 1e-15, "{energy:e} {momentum:e}");
        [even - rest, odd, rest]
    };
    let expected = [0.092_16, 0.004_733_250_443_423_004, 0.099_192_047_040_573_41];
    for (found, expected) in parts([0.2, 0.1]).into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-16, "{found} in place of {expected}");
    }
    // Control: without ∂x/∂t only T₂ is left.
    let [second, first, zeroth] = parts([0.0; 2]);
    assert!((second - expected[0]).abs() < 1e-16 && first.abs() < 1e-16 && zeroth == 0.0, "{first} {zeroth}");
}

/// A particle in a uniform field, in spherical coordinates r, θ, φ: V = m (a₁x + a₃z) depends on all three.
#[lagrangian]
fn spherical(q: [f64; 3], v: [f64; 3], m: f64, a: [f64; 2]) -> f64 {
    let [r, theta, phi] = q;
    let sin = theta.sin();
    let potential = m * r * (a[0] * sin * phi.cos() + a[1] * theta.cos());
    m / 2.0 * (v[0] * v[0] + r * r * v[1] * v[1] + r * r * sin * sin * v[2] * v[2]) - potential
}

/// T22: the six canonical equations in spherical coordinates, with −∂V/∂r, −∂V/∂θ and −∂V/∂φ. The motion is a parabola in space.
#[test]
fn spherical_coordinates_with_a_potential_of_all_three() -> Result<(), StepError> {
    let (m, a) = (1.3, [0.4, 1.1]);
    let system = Spherical { m, a };
    let ([r, theta, phi], [u, v, w]) = ([1.7_f64, 0.9, 0.3], [0.2_f64, -0.5, 0.8]);
    let mut slopes = [[0.0_f64; 3]; 2];
    system.gradient(0.0, &[[r, theta, phi], [u, v, w]], &mut slopes);
    let ((sin, cos), (sin_phi, cos_phi)) = (theta.sin_cos(), phi.sin_cos());
    let velocities = [u / m, v / (m * r * r), w / (m * r * r * sin * sin)];
    let potential = [
        m * (a[0] * sin * cos_phi + a[1] * cos),
        m * r * (a[0] * cos * cos_phi - a[1] * sin),
        -m * r * a[0] * sin * sin_phi,
    ];
    let centrifugal =
        [(v * v + w * w / (sin * sin)) / (m * r * r * r), w * w * cos / (m * r * r * sin * sin * sin), 0.0];
    for i in 0..3 {
        assert!((slopes[1][i] - velocities[i]).abs() < 1e-15, "{i}");
        assert!((slopes[0][i] + centrifugal[i] - potential[i]).abs() < 1e-15, "{i}");
        // Control: without the potential every force is another one.
        assert!((slopes[0][i] + centrifugal[i]).abs() > 0.1, "{i}");
    }

    let point = |[r, theta, phi]: [f64; 3]| [r * theta.sin() * phi.cos(), r * theta.sin() * phi.sin(), r * theta.cos()];
    let start = [0.2, -0.3, 0.5];
    let [x, y, z] = point([r, theta, phi]);
    // Rates of r, θ and φ of a particle with the velocity `start` in space.
    let along = (x * start[0] + y * start[1] + z * start[2]) / r;
    let rates = [along, (z * along / r - start[2]) / (r * sin), (x * start[1] - y * start[0]) / (x * x + y * y)];
    let mut sim = system.integrator(Gauss::<6>, 0.02, system.at([r, theta, phi], rates));
    sim.advance(50)?;
    let fallen = [-a[0] / 2.0, 0.0, -a[1] / 2.0];
    for (i, found) in point(sim.state().q).into_iter().enumerate() {
        let expected = [x, y, z][i] + start[i] + fallen[i];
        assert!((found - expected).abs() < 1e-13, "{i}: {found} {expected}");
    }
    Ok(())
}
