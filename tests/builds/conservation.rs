//! Long runs: energy to rounding, energy within bounds, energy lost.

use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use geoint_tests::measure::{Line, distance, regression, solution};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use geoint_tests::scalars::Double;

/// Kepler in the form whose angular momentum the discrete gradient keeps.
fn ellipse(e: f64) -> (Kepler, State<[f64; 2]>) {
    let speed = ((1.0 + e) / (1.0 - e)).sqrt();
    (Kepler { mass: 1.0, mu: 1.0 }, State::new([1.0 - e, 0.0], [0.0, speed]))
}

fn momentum(state: &State<[f64; 2]>) -> f64 {
    state.q[0] * state.p[1] - state.q[1] * state.p[0]
}

/// Errors of energy and angular momentum over a run.
fn ellipse_errors<M: Method<Kepler, f64>>(method: M) -> (f64, f64) {
    let (system, start) = ellipse(0.6);
    let (energy, spin) = (system.energy(&start), momentum(&start));
    let mut sim = system.integrator(method, 0.05, start);
    sim.sampled(1).take(2000).map(Result::unwrap).fold((0.0, 0.0), |(h, l), state| {
        (f64::max(h, (system.energy(&state) - energy).abs()), f64::max(l, (momentum(&state) - spin).abs()))
    })
}

#[test]
fn discrete_gradient_keeps_energy_and_angular_momentum() {
    let (energy, spin) = ellipse_errors(DiscreteGradient);
    println!("discrete gradient: energy {energy:.1e}, angular momentum {spin:.1e}");
    assert!(energy <= 1e-14, "energy {energy:.1e}");
    assert!(spin <= 1e-14, "angular momentum {spin:.1e}");
    // Neither comes for free: the midpoint rule keeps the second alone, and explicit Euler nothing.
    let (energy, spin) = ellipse_errors(ImplicitMidpoint);
    assert!(energy > 1e-4 && spin <= 1e-13, "{energy:.1e} {spin:.1e}");
    let (energy, spin) = ellipse_errors(ExplicitEuler);
    assert!(energy > 1e-2 && spin > 1e-2, "{energy:.1e} {spin:.1e}");
}

/// Two charges that a third, heavy one holds, in space.
#[hamiltonian]
fn charges(q: [[f64; 3]; 2], p: [[f64; 3]; 2], m: f64) -> f64 {
    let square = |a: [f64; 3]| a.iter().map(|x| x * x).sum::<f64>();
    let apart = (0..3).map(|i| (q[0][i] - q[1][i]).powi(2)).sum::<f64>();
    square(p[0]) / 2.0 + square(p[1]) / (2.0 * m) - 2.0 / square(q[0]).sqrt() - 2.0 / square(q[1]).sqrt()
        + 0.3 / apart.sqrt()
}

/// A centre whose strength changes in time: the angular momentum alone is kept.
#[hamiltonian]
fn breathing(q: [f64; 2], p: [f64; 2], t: f64, mu: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + mu * (1.0 + t.sin() / 3.0) * (q[0] * q[0] + q[1] * q[1]).powi(2) / 4.0
}

/// Steps of order 4 list the momenta that are found beside H: linear ones, angular momentum, with time and without.
#[test]
fn steps_of_order_4_keep_momenta() {
    let fourth = FourthOrder(DiscreteGradient);
    let (energy, spin) = ellipse_errors(fourth);
    println!("ellipse: energy {energy:.1e}, angular momentum {spin:.1e}");
    assert!(energy <= 2e-14 && spin <= 1e-14, "{energy:.1e} {spin:.1e}");
    // By the other formula it is kept to the order.
    let (_, spin) = ellipse_errors(FourthOrder(Gonzalez));
    assert!(spin > 1e-9, "{spin:.1e}");

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
    assert!((momentum(&sim.state()) - momentum(&start)).abs() < 1e-13);
}

/// On a circle the gradients of energy and angular momentum are parallel, and no step is orthogonal to both in all their neighbourhood: there
/// the energy is kept alone. Of a given energy the circle has the largest angular momentum, so that a step which is off it by e loses e².
#[test]
fn steps_of_order_4_follow_circles() {
    #[hamiltonian]
    fn kepler(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
    let system = Kepler { m: 1.7, k: 1.7 };
    let run = |eccentricity: f64, h: f64, steps: u64| {
        let speed = ((1.0 + eccentricity) / (1.0 - eccentricity)).sqrt();
        let start = State::new([1.0 - eccentricity, 0.0], [0.0, 1.7 * speed]);
        let spin = |state: &State<[f64; 2]>| state.q[0] * state.p[1] - state.q[1] * state.p[0];
        let mut sim = system.integrator(FourthOrder(DiscreteGradient), h, start);
        let mut largest = [0.0_f64; 3];
        for _ in 0..steps {
            sim.step().unwrap_or_else(|error| panic!("{eccentricity:e}, h = {h}: {error}"));
            let state = sim.state();
            let found = [
                system.energy(&state) - system.energy(&start),
                spin(&state) - spin(&start),
                state.q[0].hypot(state.q[1]) - 1.0,
            ];
            largest = std::array::from_fn(|i| largest[i].max(found[i].abs()));
        }
        largest
    };
    for eccentricity in [0.0, 1e-12, 1e-8] {
        let mut radii = [0.1, 0.2, 0.4].map(|h| {
            let [energy, spin, radius] = run(eccentricity, h, 70);
            assert!(energy < 4e-15, "{eccentricity:e}, h = {h}: {energy:e}");
            assert!(spin < 4.0 * radius * radius + 4e-15, "{eccentricity:e}, h = {h}: {spin:e} {radius:e}");
            radius - eccentricity
        });
        radii.reverse();
        assert!(radii[0] < 1e-4 && radii[0] > 12.0 * radii[1], "{eccentricity:e}: {radii:?}");
    }
    // It does not become worse.
    let [energy, spin, radius] = run(0.0, 0.4, 500);
    assert!(energy < 1e-14 && spin < 4e-9 && radius < 6e-5, "{energy:e} {spin:e} {radius:e}");
    // A little eccentricity is enough to keep both.
    let [energy, spin, _] = run(1e-3, 0.1, 200);
    assert!(energy < 4e-15 && spin < 4e-15, "{energy:e} {spin:e}");
}

/// Energy errors of a run, relative to the start, at every `stride`-th step.
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

fn largest(points: &[(f64, f64)]) -> f64 {
    points.iter().map(|point| point.1.abs()).fold(0.0, f64::max)
}

#[test]
fn discrete_gradient_has_no_drift_in_a_million_steps() {
    let points = errors::<Pendulum, _>(DiscreteGradient, 0.1, 100, 10_000);
    let Line { slope, uncertainty } = regression(&points);
    let reach = slope * points.last().unwrap().0;
    println!(
        "pendulum: largest {:.1e}, drift over the run {reach:.1e} ± {uncertainty:.1e} a unit of time",
        largest(&points)
    );
    assert!(largest(&points) <= 1e-12, "{:.1e}", largest(&points));
    // Rounding walks at random, √n steps of about u: a drift of one unit in 2⁵³ a step would reach 1e-10.
    assert!(reach.abs() <= 5e-13, "{reach:.1e}");
}

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

/// Each kind of method keeps the energy to rounding if it claims so, and not otherwise.
#[test]
fn energy_is_kept_by_those_that_claim_it() {
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
    assert_eq!(energy.0, 11);
}

/// The momentum of a cyclic coordinate is not touched, not even by rounding.
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
            assert!((sim.state().p[1] - start.p[1]).abs() > 1e-3, "{name}: the others move");
        }
    }
    let mut cyclic = Cyclic;
    methods::kinds_of_general(&mut cyclic);
    methods::kinds_of_discrete_gradient(&mut cyclic);
    methods::relaxed(&mut cyclic);
    methods::kinds_of_itoh_abe(&mut cyclic);
    methods::itoh_abe_one_way(&mut cyclic);
}

/// Errors of the implicit midpoint rule at T = 2 on Hénon–Heiles with unit masses from (0.1, −0.2, 0.3, 0.25), computed
/// once by another program from an independent solution of relative accuracy 10⁻¹³.
#[test]
fn midpoint_errors_of_another_program() {
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
