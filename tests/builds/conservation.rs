//! Conservation of energy and momenta in runs of up to 10⁶ steps.
//!
//! Discrete gradients conserve the energy to rounding, and some conserve angular momentum, too. Störmer–Verlet keeps the error of the energy bounded.
//! Explicit Euler is a control: its energy drifts. Cyclic momenta are constant bit for bit. The last test compares errors with the
//! figures of an independent program.
//!
//! The tests belong to the program `builds`, because conservation to rounding depends on the arithmetic of a build: without the standard library, with
//! `strict-math`, with fused operations.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::{Line, distance, regression, solution};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use geoint_tests::scalars::Double;

/// Returns Kepler's problem and the pericentre of an ellipse with this eccentricity, semi-major axis 1. `Kepler` is written in q·q and p·p, so the
/// macro finds that `DiscreteGradient` conserves the angular momentum.
fn ellipse(eccentricity: f64) -> (Kepler, State<[f64; 2]>) {
    let speed = ((1.0 + eccentricity) / (1.0 - eccentricity)).sqrt();
    (Kepler { mass: 1.0, mu: 1.0 }, State::new([1.0 - eccentricity, 0.0], [0.0, speed]))
}

fn angular_momentum(state: &State<[f64; 2]>) -> f64 {
    state.q[0] * state.p[1] - state.q[1] * state.p[0]
}

/// Largest errors of the energy and of the angular momentum in a run.
struct Errors {
    energy: f64,
    angular_momentum: f64,
}

/// Returns the errors in 2000 steps on the ellipse with e = 0.6, where H = −0.5 and the angular momentum is 0.8.
fn ellipse_errors<M: Method<Kepler, f64>>(method: M) -> Errors {
    let (system, start) = ellipse(0.6);
    let mut sim = system.integrator(method, 0.05, start);
    let mut largest = Errors { energy: 0.0, angular_momentum: 0.0 };
    for state in sim.sampled(1).take(2000).map(Result::unwrap) {
        largest.energy = largest.energy.max((system.energy(&state) - system.energy(&start)).abs());
        let change = angular_momentum(&state) - angular_momentum(&start);
        largest.angular_momentum = largest.angular_momentum.max(change.abs());
    }
    largest
}

/// The bound 10⁻¹⁴ is about 100 units in the last place of the energy and of the angular momentum.
#[test]
fn discrete_gradient_keeps_energy_and_angular_momentum() {
    let Errors { energy, angular_momentum } = ellipse_errors(DiscreteGradient);
    println!("discrete gradient: energy {energy:.1e}, angular momentum {angular_momentum:.1e}");
    assert!(energy <= 1e-14, "energy {energy:.1e}");
    assert!(angular_momentum <= 1e-14, "angular momentum {angular_momentum:.1e}");
    // Controls: the midpoint rule conserves only the angular momentum, and explicit Euler conserves neither.
    let Errors { energy, angular_momentum } = ellipse_errors(ImplicitMidpoint);
    assert!(energy > 1e-4 && angular_momentum <= 1e-13, "{energy:.1e} {angular_momentum:.1e}");
    let Errors { energy, angular_momentum } = ellipse_errors(ExplicitEuler);
    assert!(energy > 1e-2 && angular_momentum > 1e-2, "{energy:.1e} {angular_momentum:.1e}");
}

/// Two charges in space, attracted by a heavy charge at the origin and repelled by each other.
#[hamiltonian]
fn charges(q: [[f64; 3]; 2], p: [[f64; 3]; 2], m: f64) -> f64 {
    let square = |a: [f64; 3]| a.iter().map(|x| x * x).sum::<f64>();
    let apart = (0..3).map(|i| (q[0][i] - q[1][i]).powi(2)).sum::<f64>();
    square(p[0]) / 2.0 + square(p[1]) / (2.0 * m) - 2.0 / square(q[0]).sqrt() - 2.0 / square(q[1]).sqrt()
        + 0.3 / apart.sqrt()
}

/// A central force with a strength that depends on time. The angular momentum is constant, the energy is not.
#[hamiltonian]
fn breathing(q: [f64; 2], p: [f64; 2], t: f64, mu: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + mu * (1.0 + t.sin() / 3.0) * (q[0] * q[0] + q[1] * q[1]).powi(2) / 4.0
}

/// `FourthOrder(DiscreteGradient)` conserves the energy and the angular momentum of one particle and of several particles in space. If H depends on
/// time, the method conserves the angular momentum alone. Exception: orbits near a circle, see the next test.
#[test]
fn steps_of_order_4_keep_momenta() {
    let fourth = FourthOrder(DiscreteGradient);
    let Errors { energy, angular_momentum: change } = ellipse_errors(fourth);
    println!("ellipse: energy {energy:.1e}, angular momentum {change:.1e}");
    assert!(energy <= 2e-14 && change <= 1e-14, "{energy:.1e} {change:.1e}");
    // Control: `FourthOrder(Gonzalez)` uses another formula. Its angular momentum has an error of the size of the step error.
    let Errors { angular_momentum: change, .. } = ellipse_errors(FourthOrder(Gonzalez));
    assert!(change > 1e-9, "{change:.1e}");

    let system = Charges { m: 1.7 };
    let start = State::new([[1.0, 0.2, -0.1], [-1.4, 0.3, 0.5]], [[-0.2, 1.3, 0.1], [0.3, -1.9, 0.4]]);
    let angular = |state: &State<[[f64; 3]; 2]>| -> [f64; 3] {
        std::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            (0..2).map(|body| state.q[body][i] * state.p[body][j] - state.q[body][j] * state.p[body][i]).sum()
        })
    };
    let mut sim = system.integrator(fourth, 0.02, start);
    let (energy, before) = (system.energy(&start), angular(&start));
    for _ in 0..20 {
        sim.advance(25).unwrap();
        let state = sim.state();
        assert!((system.energy(&state) - energy).abs() < 4e-14, "{:e}", system.energy(&state) - energy);
        for (now, before) in angular(&state).iter().zip(before) {
            assert!((now - before).abs() < 4e-14, "{:e}", now - before);
        }
    }

    let start = State::new([0.7, 0.3], [-0.2, 0.9]);
    let mut sim = Breathing { mu: 1.3 }.integrator(fourth, 0.1, start);
    sim.advance(1000).unwrap();
    assert!((angular_momentum(&sim.state()) - angular_momentum(&start)).abs() < 1e-13);
}

/// `FourthOrder(DiscreteGradient)` on circular orbits, where it conserves the energy but not the angular momentum L.
///
/// On a circle ∇H and ∇L are parallel. Near a circle the discrete gradients of H and of L are nearly parallel, and the equations for
/// keeping both are nearly singular. The method then conserves the energy alone. Among orbits of one energy, the circle has the largest L. A deviation δ of the radius therefore changes L by a multiple of δ² only.
#[test]
fn steps_of_order_4_follow_circles() {
    #[hamiltonian]
    fn central(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
    let system = Central { m: 1.7, k: 1.7 };
    let run = |eccentricity: f64, h: f64, steps: u64| {
        let speed = ((1.0 + eccentricity) / (1.0 - eccentricity)).sqrt();
        let start = State::new([1.0 - eccentricity, 0.0], [0.0, 1.7 * speed]);
        let mut sim = system.integrator(FourthOrder(DiscreteGradient), h, start);
        // Errors of the energy, of the angular momentum and of the radius.
        let mut largest = [0.0_f64; 3];
        for _ in 0..steps {
            sim.step().unwrap_or_else(|error| panic!("{eccentricity:e}, h = {h}: {error}"));
            let state = sim.state();
            let errors = [
                system.energy(&state) - system.energy(&start),
                angular_momentum(&state) - angular_momentum(&start),
                state.q[0].hypot(state.q[1]) - 1.0,
            ];
            largest = std::array::from_fn(|i| largest[i].max(errors[i].abs()));
        }
        largest
    };
    for eccentricity in [0.0, 1e-12, 1e-8] {
        let [coarse, fine, _] = [0.4, 0.2, 0.1].map(|h| {
            let [energy, momentum, radius] = run(eccentricity, h, 70);
            assert!(energy < 4e-15, "{eccentricity:e}, h = {h}: {energy:e}");
            assert!(momentum < 4.0 * radius * radius + 4e-15, "{eccentricity:e}, h = {h}: {momentum:e} {radius:e}");
            radius - eccentricity
        });
        // Order 4: the error of the radius falls by nearly 2⁴ if h is halved.
        assert!(coarse < 1e-4 && coarse > 12.0 * fine, "{eccentricity:e}: {coarse:e} {fine:e}");
    }
    // The errors stay small in a run of 500 steps.
    let [energy, momentum, radius] = run(0.0, 0.4, 500);
    assert!(energy < 1e-14 && momentum < 4e-9 && radius < 6e-5, "{energy:e} {momentum:e} {radius:e}");
    // On an ellipse with e = 10⁻³ the method conserves both quantities.
    let [energy, momentum, _] = run(1e-3, 0.1, 200);
    assert!(energy < 4e-15 && momentum < 4e-15, "{energy:e} {momentum:e}");
}

/// Returns points (t, (H(t) − H(0))/H(0)) of a run, one after each `stride` steps.
fn errors<P: Problem, M: Method<P::Over<f64>, f64>>(method: M, h: f64, stride: u64, samples: usize) -> Vec<(f64, f64)> {
    let (system, start) = (P::system::<f64>(), P::initial::<f64>(0.0));
    let energy = system.energy(&start);
    let mut sim = system.integrator(method, h, start);
    let point = |state: Result<State<_>, _>| {
        let state = state.unwrap();
        (state.t, (system.energy(&state) - energy) / energy)
    };
    sim.sampled(stride).take(samples).map(point).collect()
}

/// Returns the largest absolute error of the energy.
fn largest(points: &[(f64, f64)]) -> f64 {
    points.iter().map(|point| point.1.abs()).fold(0.0, f64::max)
}

/// The energy of a pendulum has no drift in 10⁶ steps: a fitted line stays within rounding.
#[test]
fn discrete_gradient_has_no_drift_in_a_million_steps() {
    let points = errors::<Pendulum, _>(DiscreteGradient, 0.1, 100, 10_000);
    let Line { slope, uncertainty } = regression(&points);
    let reach = slope * points.last().unwrap().0;
    println!(
        "pendulum: largest {:.1e}, drift over the run {reach:.1e}, uncertainty of the slope {uncertainty:.1e}",
        largest(&points)
    );
    assert!(largest(&points) <= 1e-12, "{:.1e}", largest(&points));
    // Rounding errors of u = 2⁻⁵³ a step add up to √n u = 10⁻¹³ in a random walk of n = 10⁶ steps. A drift of u in each step would reach 10⁻¹⁰.
    assert!(reach.abs() <= 5e-13, "{reach:.1e}");
}

/// The error of Störmer–Verlet is bounded: it is not larger late in the run than early, and a fitted line is flat. The energy of explicit Euler drifts,
/// although its steps are 100 times shorter, as is its run.
#[test]
fn verlet_keeps_energy_within_bounds_and_euler_does_not() {
    let points = errors::<Pendulum, _>(StormerVerlet, 0.02, 100, 10_000);
    let (early, late) = points.split_at(1000);
    println!("verlet: {:.1e} early, {:.1e} late", largest(early), largest(late));
    assert!(largest(late) <= 1.05 * largest(early), "{:.1e} {:.1e}", largest(early), largest(late));
    assert!(largest(late) < 0.02);
    let Line { slope, .. } = regression(&points);
    assert!((slope * points.last().unwrap().0).abs() < 1e-3 * largest(late), "{slope:.1e}");

    let points = errors::<Pendulum, _>(ExplicitEuler, 0.0002, 100, 10_000);
    let Line { slope, uncertainty } = regression(&points);
    println!("euler: drift {:.1e}", slope * points.last().unwrap().0);
    assert!((slope * points.last().unwrap().0).abs() > 0.05 && slope.abs() > 100.0 * uncertainty);
}

/// A method conserves the energy to rounding if and only if it claims to.
#[test]
fn energy_is_kept_by_those_that_claim_it() {
    /// Counts the methods that claim to conserve the energy.
    struct Energy(usize);
    impl Visitor<DoublePendulum, f64> for Energy {
        fn visit<M: Method<DoublePendulum, f64> + 'static>(&mut self, method: M) {
            let name = method.name().to_string();
            let error = largest(&errors::<DoublePendulum, _>(method, 0.1, 1, 200));
            let claims = method.claims();
            self.0 += usize::from(claims.conserves_energy);
            println!("{name:45} {error:.1e}");
            match claims.conserves_energy {
                true => assert!(error < 5e-14, "{name}: {error:.1e}"),
                false => assert!(error > 5e-14, "{name}: {error:.1e}"),
            }
        }
    }
    let mut energy = Energy(0);
    methods::kinds_of_general(&mut energy);
    methods::kinds_of_discrete_gradient(&mut energy);
    methods::projected(&mut energy);
    methods::kinds_of_itoh_abe(&mut energy);
    methods::itoh_abe_one_way(&mut energy);
    // Number of methods in these lists that claim to conserve the energy. A changed list fails here.
    assert_eq!(energy.0, 11);
}

/// H does not depend on the cyclic coordinate φ. The methods of these lists keep the momentum of φ bit for bit, while other momenta change.
#[test]
fn cyclic_momentum_is_kept_bitwise() {
    struct Cyclic;
    impl Visitor<Spherical, f64> for Cyclic {
        fn visit<M: Method<Spherical, f64> + 'static>(&mut self, method: M) {
            let name = method.name().to_string();
            let start = Spherical::initial::<f64>(0.0);
            let mut sim = Spherical::system::<f64>().integrator(method, 0.02, start);
            sim.advance(300).unwrap();
            assert_eq!(sim.state().p[2].to_bits(), start.p[2].to_bits(), "{name}");
            assert!((sim.state().p[1] - start.p[1]).abs() > 1e-3, "{name}: other momenta change");
        }
    }
    let mut cyclic = Cyclic;
    methods::kinds_of_general(&mut cyclic);
    methods::kinds_of_discrete_gradient(&mut cyclic);
    methods::relaxed(&mut cyclic);
    methods::kinds_of_itoh_abe(&mut cyclic);
    methods::itoh_abe_one_way(&mut cyclic);
}

/// Errors of the implicit midpoint rule at t = 2 agree with the figures of an independent program, to 5 %. The program is not in this repository. It
/// computed the figures once, with a reference solution of relative accuracy 10⁻¹³. The system is Hénon–Heiles with unit masses.
#[test]
fn midpoint_errors_of_an_independent_program() {
    let system = HenonHeiles { m: [1.0, 1.0], lambda: 1.0 };
    let start = State::new([0.1, -0.2], [0.3, 0.25]);
    let lifted = HenonHeiles { m: [1.0, 1.0].map(Double::from), lambda: 1.0.into() };
    let exact = solution(&lifted, &State::new(start.q.map(Double::from), start.p.map(Double::from)), 2.0.into(), 20);
    let exact: Vec<f64> = exact.iter().map(|x| x.value()).collect();
    for (h, expected) in [(0.2, 4.759e-3), (0.1, 1.198e-3), (0.05, 3.000e-4)] {
        let mut sim = system.integrator(ImplicitMidpoint, h, start);
        let end = sim.until(2.0).last().unwrap().unwrap();
        let error = distance(&flat(&end), &exact);
        println!("h = {h}: {error:.3e}, expected {expected:.3e}");
        assert!((error / expected - 1.0).abs() < 0.05, "h = {h}: {error:.3e}, expected {expected:.3e}");
    }
}
