//! Errors and orders of methods with constraints. The references are another program and coordinates without constraints.

use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Largest defects at the ends of steps.
#[derive(Default)]
struct Largest {
    energy: f64,
    constraint: f64,
    rate: f64,
}

fn largest<M: Method<DoublePendulum>>(method: M, h: f64, time: f64) -> Largest {
    let mut sim = Integrator::new(DOUBLE, method, h, released());
    let start = sim.energy();
    let mut all = Largest::default();
    for _ in 0..(time / h).round() as u64 {
        sim.step().expect("a step");
        let State { q, p, .. } = sim.state();
        let v = [p[0] / M[0], p[1] / M[0], p[2] / M[1], p[3] / M[1]];
        let (x, y, u, w) = (q[2] - q[0], q[3] - q[1], v[2] - v[0], v[3] - v[1]);
        let g = [q[0] * q[0] + q[1] * q[1] - 1.0, x * x + y * y - L[1] * L[1]].map(|g| (g / 2.0).abs());
        let rates = [q[0] * v[0] + q[1] * v[1], x * u + y * w].map(f64::abs);
        all.energy = all.energy.max((sim.energy() - start).abs());
        all.constraint = all.constraint.max(g[0]).max(g[1]);
        all.rate = all.rate.max(rates[0]).max(rates[1]);
    }
    all
}

fn close(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 0.05, "{found:.3e} {expected:.3e}");
}

const STEPS: [f64; 4] = [0.02, 0.01, 0.005, 0.0025];

#[test]
fn rattle() {
    let errors = STEPS.map(|h| far(&run(DOUBLE, Rattle, h, released(), 2.0).state(), &at_two()));
    for (found, expected) in errors.into_iter().zip([1.10e-2, 2.75e-3, 6.88e-4, 1.72e-4]) {
        close(found, expected);
    }
    assert!(orders(&errors).iter().all(|order| (order - 2.0).abs() < 0.1), "{errors:?}");
    for (h, energy) in [(0.02, 1.2e-2), (0.0025, 1.8e-4)] {
        let found = largest(Rattle, h, 2.0);
        assert!((found.energy / energy - 1.0).abs() < 0.1, "{:e}", found.energy);
        assert!(found.constraint < 5e-16 && found.rate < 2e-15, "{:e} {:e}", found.constraint, found.rate);
    }
    // The energy swings and does not drift.
    let long = largest(Rattle, 0.02, 100.0);
    assert!(
        (long.energy / 1.4e-2 - 1.0).abs() < 0.1 && long.constraint < 5e-16 && long.rate < 2e-15,
        "{:e}",
        long.energy
    );
}

/// Errors of positions and momenta.
fn apart(method: impl Method<DoublePendulum>, h: f64) -> [f64; 2] {
    let (state, exact) = (run(DOUBLE, method, h, released(), 2.0).state(), at_two());
    [far(&State { p: exact.p, ..state }, &exact), far(&State { q: exact.q, ..state }, &exact)]
}

const LONG: [f64; 3] = [0.04, 0.02, 0.01];

/// Momenta are tangent at the ends of steps, and the energy is kept all the same.
#[test]
fn discrete_gradient() {
    let errors = LONG.map(|h| apart(DiscreteGradient, h));
    for (found, expected) in errors.into_iter().zip([[6.82e-3, 4.36e-2], [1.69e-3, 1.09e-2], [4.22e-4, 2.73e-3]]) {
        close(found[0], expected[0]);
        close(found[1], expected[1]);
    }
    for k in [0, 1] {
        assert!(orders(&errors.map(|error| error[k])).iter().all(|order| (order - 2.0).abs() < 0.1), "{errors:?}");
    }
    for (h, time) in STEPS.into_iter().zip([2.0; 4]).chain([(0.02, 100.0)]) {
        let Largest { energy, constraint, rate } = largest(DiscreteGradient, h, time);
        assert!(energy < 6e-14 && constraint < 6e-16 && rate < 4e-15, "{energy:e} {constraint:e} {rate:e}");
    }
}

/// Compositions have order 4, in positions and in momenta.
#[test]
fn compositions() {
    let rattle = LONG.map(|h| far(&run(DOUBLE, Suzuki4.of(Rattle), h, released(), 2.0).state(), &at_two()));
    for (found, expected) in rattle.into_iter().zip([8.52e-5, 5.27e-6, 3.29e-7]) {
        close(found, expected);
    }
    assert!(orders(&rattle).iter().all(|order| (order - 4.0).abs() < 0.1), "{rattle:?}");
    let errors = LONG.map(|h| apart(Suzuki4.of(DiscreteGradient), h));
    for (found, expected) in errors.into_iter().zip([[5.70e-6, 4.02e-5], [3.61e-7, 2.55e-6], [2.26e-8, 1.60e-7]]) {
        close(found[0], expected[0]);
        close(found[1], expected[1]);
    }
    for k in [0, 1] {
        assert!(orders(&errors.map(|error| error[k])).iter().all(|order| (order - 4.0).abs() < 0.1), "{errors:?}");
    }
    let sim = run(DOUBLE, Suzuki4.of(DiscreteGradient), 0.04, released(), 2.0);
    assert!((sim.energy() - DOUBLE.energy(&released())).abs() < 3e-14);
}

/// A mass matrix that depends on angles, closed by two equations, against masses in the plane.
#[test]
fn a_linkage_by_angles_and_by_points() {
    let (angles, points) = cranked(0.4, 1.5);
    let joint = |q: [f64; 3]| {
        let first = [BARS[0] * q[0].cos(), BARS[0] * q[0].sin()];
        [first[0], first[1], first[0] + BARS[1] * q[1].cos(), first[1] + BARS[1] * q[1].sin()]
    };
    let exact = run(FOUR_BAR, KahanLi8_17a.of(Rattle), 0.01, points, 1.0).state();
    let apart = |q: [f64; 4]| (0..4).fold(0.0, |far, i| f64::max(far, (q[i] - exact.q[i]).abs()));
    let same = run(FOUR_BAR_OF_ANGLES, KahanLi8_17a.of(Rattle), 0.01, angles, 1.0).state();
    assert!(apart(joint(same.q)) < 1e-9, "{:e}", apart(joint(same.q)));
    macro_rules! second {
        ($system:expr, $start:expr, $joint:expr, $($method:expr),*) => { $(
            let errors = [0.02, 0.01, 0.005].map(|h| apart($joint(run($system, $method, h, $start, 1.0).state().q)));
            assert!(orders(&errors).iter().all(|order| (order - 2.0).abs() < 0.1), "{errors:?}");
        )* };
    }
    second!(FOUR_BAR, points, |q| q, Rattle, DiscreteGradient);
    second!(FOUR_BAR_OF_ANGLES, angles, joint, Rattle, DiscreteGradient);
    let sim = run(FOUR_BAR_OF_ANGLES, DiscreteGradient, 0.02, angles, 20.0);
    assert!((sim.energy() - FOUR_BAR_OF_ANGLES.energy(&angles)).abs() < 1e-12);
}

/// T that is not quadratic, and time in H, against the angle.
#[test]
fn energies_that_are_not_quadratic() {
    let (system, free) = (Fast { m: 0.7, c: 3.0, l: 1.3, g: 9.81 }, FastAngle { m: 0.7, c: 3.0, l: 1.3, g: 9.81 });
    let start = State::new([1.3 * 0.5_f64.sin(), -1.3 * 0.5_f64.cos()], [0.8 * 0.5_f64.cos(), 0.8 * 0.5_f64.sin()]);
    let mut exact = free.integrator(Gauss::<6>, 0.01, State::new(0.5, 0.8 * 1.3));
    exact.advance(100).expect("steps");
    let State { q: angle, p, .. } = exact.state();
    let (sin, cos) = angle.sin_cos();
    let exact = State { t: 1.0, q: [1.3 * sin, -1.3 * cos], p: [p / 1.3 * cos, p / 1.3 * sin] };
    macro_rules! order {
        ($order:literal, $steps:expr, $($method:expr),*) => { $(
            let errors = $steps.map(|h| {
                let state = run(system, $method, h, start, 1.0).state_on_constraint().expect("a state");
                far(&state, &exact)
            });
            assert!(orders(&errors).iter().all(|order| (order - $order).abs() < 0.15), "{errors:?}");
        )* };
    }
    order!(2.0, [0.04, 0.02, 0.01], Rattle, DiscreteGradient);
    order!(4.0, [0.02, 0.01, 0.005], Suzuki4.of(Rattle), Suzuki4.of(DiscreteGradient));
}
