//! Adaptive steps follow every coordinate with the same relative accuracy, whatever the sizes of the others.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Failure, Method};
use geoint_tests::measure::distance;
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::flat;

/// Two oscillators that know nothing of each other.
#[hamiltonian]
fn two_oscillators(q: [f64; 2], p: [f64; 2], m: [f64; 2], k: [f64; 2]) -> f64 {
    (p[0] * p[0] / m[0] + k[0] * q[0] * q[0]) / 2.0 + (p[1] * p[1] / m[1] + k[1] * q[1] * q[1]) / 2.0
}

#[test]
fn small_motions_beside_large_ones() {
    fn check<M: Method<TwoOscillators>>(name: &str, method: M, tolerance: f64) {
        // Frequencies 1.25 and 8.
        let system = TwoOscillators { m: [1.6, 0.5], k: [2.5, 32.0] };
        for (large, small) in [(1e8, 1e-3), (1e-12, 1e9), (1.0, 1e-14)] {
            let mut sim = system.adaptive(method, tolerance, State::new([large, small], [0.0, 0.0]));
            sim.advance_to(20.0).unwrap();
            let [x, y] = sim.state().q;
            let errors = [x / large - 25.0_f64.cos(), y / small - 160.0_f64.cos()];
            println!("{name} {large:e} {small:e}: {errors:?} in {} steps", sim.steps());
            assert!(errors.iter().all(|e| e.abs() <= 3e3 * tolerance), "{name} {large:e} {small:e}: {errors:?}");
        }
    }
    check("DOP853", DOP853, 1e-6);
    check("RK4", RK4, 1e-7);
    check("Gauss", Gauss::<3>, 1e-7);
    check("Projection", Projection(DOP853, Energy), 1e-8);
}

/// The Earth in SI units, and a libration beside it: lengths of 10¹¹ m and an angle, momenta of 10²⁹ kg m/s and of 10³⁰ kg m²/s.
#[hamiltonian]
fn earth_and_libration(q: [f64; 3], p: [f64; 3], m: f64, mu: f64, inertia: f64, torque: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - mu / (q[0] * q[0] + q[1] * q[1]).sqrt() + p[2] * p[2] / (2.0 * inertia)
        - torque * q[2].cos()
}

/// The libration alone.
#[hamiltonian]
fn libration(q: f64, p: f64, inertia: f64, torque: f64) -> f64 {
    p * p / (2.0 * inertia) - torque * q.cos()
}

#[test]
fn lengths_and_angles_in_si_units() {
    let (inertia, year) = (8.0e37, 3.156e7);
    // Eight librations a year.
    let torque = inertia * (8.0 * std::f64::consts::TAU / year).powi(2);
    let system = EarthAndLibration { m: 5.972e24, mu: 7.928e44, inertia, torque };
    let start = State::new([1.47e11, 0.0, 0.5], [0.0, 5.972e24 * 3.03e4, 0.0]);
    let mut exact = Libration { inertia, torque }.adaptive(DOP853, 1e-12, State::new(0.5, 0.0));
    exact.advance_to(2.0 * year).unwrap();
    let mut sim = system.adaptive(DOP853, 1e-7, start);
    sim.advance_to(2.0 * year).unwrap();
    let error = (sim.state().q[2] - exact.state().q).abs();
    println!("angle {:.6}, error {error:.1e}, {} steps", sim.state().q[2], sim.steps());
    assert!(error <= 1e-4 && sim.steps() < 2000, "{error:.1e} in {} steps", sim.steps());
}

#[hamiltonian]
fn kepler_in_space(q: [f64; 3], p: [f64; 3], m: f64, mu: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) - mu / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt()
}

/// A coordinate that is always zero costs nothing. A coordinate at the level of rounding costs little.
#[test]
fn planes_in_space() {
    let system = KeplerInSpace { m: 1.4, mu: 2.2 };
    let steps = |tilt: f64| {
        let start = State::new([1.0, 0.0, tilt], [0.0, 1.9, -0.7 * tilt]);
        let mut sim = system.adaptive(RK4, 1e-8, start);
        sim.advance_to(50.0).unwrap();
        (sim.steps() + sim.rejections()) as f64
    };
    let [tilted, plane, almost, rounding] = [0.3, 0.0, 1e-9, 1e-17].map(steps);
    println!("{tilted} {plane} {almost} {rounding}");
    assert!([plane, almost, rounding].iter().all(|n| (0.7 * tilted..1.3 * tilted).contains(n)));
}

/// A chain of which one site is displaced: the others are at rest, and the wave comes to them later.
#[hamiltonian]
fn chain(q: [f64; 10], p: [f64; 10], m: f64) -> f64 {
    let mut h = 0.0;
    for i in 0..10 {
        let d = q[(i + 1) % 10] - q[i];
        h += p[i] * p[i] / (2.0 * m) + 0.5 * d * d + 0.2 * d * d * d * d;
    }
    h
}

/// The same with forces of 1 at rest: what has not been reached is rounding.
#[hamiltonian]
fn toda_ring(q: [f64; 10], p: [f64; 10], m: f64) -> f64 {
    let mut h = 0.0;
    for i in 0..10 {
        h += p[i] * p[i] / (2.0 * m) + (q[i] - q[(i + 1) % 10]).exp();
    }
    h
}

#[test]
fn waves_that_have_not_arrived() {
    let (mut q, p) = ([0.0; 10], [0.0; 10]);
    q[3] = 0.4;
    waves(q, p);
}

/// The length of the first step does not matter. Regression test: after a short first step the tolerated errors stayed so small that all steps stayed
/// short.
#[test]
fn waves_after_a_short_step() {
    let mut q = [0.0; 10];
    q[3] = 0.4;
    macro_rules! check {
        ($system:expr, $($method:expr),*) => { $({
            let steps = |first: f64| {
                let sim = $system.adaptive($method, 1e-6, State::new(q, [0.0; 10])).first_step(first);
                let mut sim = sim.steps_at_most(5_000);
                sim.advance_to(6.0).unwrap();
                sim.steps() + sim.rejections()
            };
            let [usual, short] = [1e-2, 1e-9].map(steps);
            assert!(short < usual + usual / 4 + 20, "{}: {short} steps, {usual}", stringify!($system, $method));
        })* };
    }
    check!(Chain { m: 1.3 }, RK4, DOP853, DiscreteGradient, BlanesMoanSrkn14a);
    check!(TodaRing { m: 1.3 }, RK4, DOP853, DiscreteGradient, BlanesMoanSrkn14a);
}

/// A standing wave whose nodes are rounding.
#[test]
fn nodes_that_are_rounding() {
    let mode = |i: usize| 0.4 * (std::f64::consts::TAU * i as f64 / 10.0).sin();
    waves(core::array::from_fn(mode), [0.0; 10]);
}

fn waves(q: [f64; 10], p: [f64; 10]) {
    macro_rules! check {
        ($system:expr, $($method:expr),*) => { $({
            let run = |tolerance: f64| {
                let mut sim = $system.adaptive($method, tolerance, State::new(q, p)).steps_at_most(5_000);
                sim.advance_to(6.0).unwrap();
                (flat(&sim.state()), sim.steps(), sim.rejections())
            };
            let ((coarse, steps, rejections), (fine, ..)) = (run(1e-6), run(1e-9));
            let error = distance(&coarse, &fine);
            println!("{}: {error:.1e} in {steps} steps, {rejections} rejected", stringify!($method));
            let most = 2e-6 * steps as f64;
            assert!(error <= most && steps + rejections <= 2500, "{}: {error:.1e}, {steps} steps", stringify!($method));
        })* };
    }
    check!(Chain { m: 1.3 }, RK4, DOP853, DiscreteGradient, Gauss::<2>);
    check!(TodaRing { m: 1.3 }, RK4, DOP853, DiscreteGradient, Gauss::<2>);
}

/// Oscillators of which a moving one knows nothing of the one that a force moves from rest, which grows, and one that begins later.
#[hamiltonian]
fn driven(q: [f64; 2], p: [f64; 2], t: f64, m: [f64; 2], k: f64, omega: f64, late: f64) -> f64 {
    let force = if t > late { (omega * (t - late)).sin() } else { 0.0 };
    p[0] * p[0] / (2.0 * m[0]) + k * q[0].powi(4) + p[1] * p[1] / (2.0 * m[1]) + k * q[1] * q[1] / 2.0 - force * q[1]
}

/// An oscillator is driven from rest by a force that starts at zero. No measured error limits the first step, which must still be short.
#[test]
fn driven_from_rest() {
    // Every step misses a force that starts behind its last evaluation. The points of `Gauss` lie inside the step.
    fn check<M: Method<Driven>>(method: M, latest: f64) {
        for (x, omega, late) in [(0.0, 1.0, 0.0), (0.0, 30.0, 0.0), (0.6, 30.0, 0.0), (0.0, 9.0, 1.0), (0.6, 9.0, 1.0)]
        {
            if late > latest {
                continue;
            }
            let (system, start) = (Driven { m: [1.6, 0.7], k: 0.8, omega, late }, State::new([x, 0.0], [0.0, 0.0]));
            let (mut sim, mut series) = (system.adaptive(method, 1e-7, start), system.taylor(Taylor::default(), start));
            sim.advance_to(6.0).unwrap();
            series.advance_to(6.0).unwrap();
            let error = (sim.state().q[1] / series.state().q[1] - 1.0).abs();
            println!("{}, {x}, {omega}, {late}: {error:.1e} in {} steps", method.name(), sim.steps());
            assert!(error < 1e-4, "{}, {x}, {omega}, {late}: {error:.1e}", method.name());
        }
    }
    check(RK4, 1.0);
    check(DOP853, 1.0);
    check(Gauss::<2>, 0.0);
    check(BlanesMoanSrkn14a, 1.0);
    check(KahanLi8_17a.of(StormerVerlet), 1.0);
}

/// At an event a coordinate is next to zero. Its size for the tolerance stays the earlier size, so steps stay long.
#[test]
fn events_do_not_shorten_steps() {
    let system = TwoOscillators { m: [1.6, 0.5], k: [2.5, 32.0] };
    let start = State::new([1.0, 0.3], [0.0, 0.2]);
    let [mut sim, mut plain] = [(); 2].map(|()| system.adaptive(DOP853, 1e-8, start));
    for _ in 0..40 {
        sim.until_event(1e3, Direction::Any, |state| state.q[1]).unwrap().unwrap();
    }
    plain.advance_to(sim.time()).unwrap();
    let [steps, without] = [&sim, &plain].map(|sim| sim.steps() + sim.rejections());
    assert!(steps < without + 5 * 40, "{steps}, without events {without}");
}

/// An absolute tolerance saves the steps for errors that do not matter.
#[test]
fn absolute_errors() {
    let system = TwoOscillators { m: [1.6, 0.5], k: [2.5, 32.0] };
    let start = State::new([1.0, 1e-6], [0.0, 0.0]);
    let mut strict = system.adaptive(RK4, 1e-8, start);
    let mut loose = system.adaptive(RK4, 1e-8, start).absolute(State::new([0.0, 1e-3], [0.0, 1e-3]));
    strict.advance_to(20.0).unwrap();
    loose.advance_to(20.0).unwrap();
    assert!(3 * loose.steps() < strict.steps(), "{} {}", loose.steps(), strict.steps());
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let mut sim = system.adaptive(RK4, 1e-8, start).absolute(State::new([0.0, bad], [0.0; 2]));
        assert!(matches!(sim.step(), Err(StepError { failure: Failure::InvalidTolerance { .. }, .. })), "{bad}");
    }
}

#[hamiltonian]
fn henon_heiles(q: [f64; 2], p: [f64; 2], m: [f64; 2], lambda: f64) -> f64 {
    let [x, y] = q;
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    kinetic + (x * x + y * y) / 2.0 + lambda * (x * x * y - y * y * y / 3.0)
}

/// Steps over a small perturbation are long. They indicate neither the time scale of the state nor the propagation of errors. Regression test: methods that
/// used them had a hundred times the tolerated error.
#[test]
fn small_perturbations_do_not_loosen_the_tolerance() {
    fn check<M: Method<HenonHeiles>>(method: M, tolerance: f64) {
        let system = HenonHeiles { m: [1.7, 0.6], lambda: 0.8 };
        let mut sim = system.adaptive(method, tolerance, State::new([0.3, -0.2], [0.35, 0.25]));
        let mut worst = 0.0_f64;
        while sim.time() < 20.0 {
            let mut exact = system.taylor(Taylor::default(), sim.state());
            sim.step_towards(20.0).unwrap();
            exact.advance_to(sim.time()).unwrap();
            worst = worst.max(distance(&flat(&sim.state()), &flat(&exact.state())));
        }
        // No coordinate is larger than 0.7.
        println!("{}: {:.2} in {} steps", method.name(), worst / tolerance, sim.steps());
        assert!(worst < 2.0 * tolerance, "{}: {:.1}", method.name(), worst / tolerance);
    }
    check(WisdomHolmanProcessed, 1e-7);
    check(WisdomHolmanProcessed, 1e-5);
    check(WisdomHolman, 1e-6);
    check(WisdomHolmanGradient, 1e-6);
}

/// A tolerance of 1 or more is as large as the state. Every kind of run refuses it, together with zero, negative and invalid tolerances.
#[test]
fn a_tolerance_is_a_part_of_the_state() {
    let system = TwoOscillators { m: [1.6, 0.5], k: [2.5, 32.0] };
    let start = State::new([1.0, 1e-6], [0.0, 0.0]);
    for bad in [1.0, 3.0, 1e300, f64::INFINITY, 0.0, -1e-9, f64::NAN] {
        let outcomes = [
            system.adaptive(RK4, bad, start).step(),
            system.adaptive(DOP853, bad, start).advance_to(1.0),
            system.taylor(Taylor { tolerance: bad }, start).step(),
            system.taylor(TaylorOrder::<8> { tolerance: bad }, start).advance_to(1.0),
        ];
        for outcome in outcomes {
            let Err(error @ StepError { failure: Failure::InvalidTolerance { .. }, .. }) = outcome else {
                panic!("{bad}: {outcome:?}")
            };
            assert!(!(1.0..1e301).contains(&bad) || error.to_string().contains("below 1"), "{error}");
        }
    }
    for loose in [0.5, 0.99] {
        system.adaptive(DOP853, loose, start).step().unwrap();
        system.taylor(Taylor { tolerance: loose }, start).step().unwrap();
    }
}

/// A run ends at its limit of steps, and continues on request.
#[test]
fn a_limit_of_steps() {
    let system = TwoOscillators { m: [1.6, 0.5], k: [2.5, 32.0] };
    let mut sim = system.adaptive(RK4, 1e-10, State::new([1.0, 1.0], [0.0, 0.0])).steps_at_most(50);
    let error = sim.advance_to(20.0).unwrap_err();
    let StepError { t, failure: Failure::TooManySteps { steps: 50 }, .. } = error else { panic!("{error}") };
    assert!(t == sim.time() && sim.steps() == 50 && t < 20.0 && error.to_string().contains("50 steps"), "{error}");
    assert!(sim.advance_to(20.0).is_err() && sim.steps() == 100);
    let mut sim = sim.steps_at_most(u64::MAX);
    sim.advance_to(20.0).unwrap();
    assert_eq!(sim.time(), 20.0);
}

/// An estimate whose square overflows is still a number, and refuses the step.
#[test]
fn tolerances_that_nothing_meets() {
    let system = TwoOscillators { m: [1.6, 0.5], k: [2.5, 32.0] };
    for tolerance in [1e-200, 1e-300, 5e-324] {
        let mut sim = system.adaptive(DOP853, tolerance, State::new([1.0, 0.5], [0.3, 0.2]));
        for _ in 0..2 {
            let error = sim.step().expect_err("nothing is as accurate");
            let StepError { failure: Failure::Inaccurate { error }, .. } = error else { panic!("{error}") };
            assert!(error > 1.0, "{tolerance:e}: {error}");
        }
        assert!(sim.steps() == 0 && sim.step_size() > 0.0, "{tolerance:e}: {}", sim.step_size());
    }
}

/// Sizes of an invalid start have no effect after the next start.
#[test]
fn sizes_of_a_state_that_is_not_finite() {
    let system = TwoOscillators { m: [1.6, 0.5], k: [2.5, 32.0] };
    let (good, bad) = (State::new([1.0, 0.5], [0.3, 0.2]), State::new([f64::INFINITY, 0.5], [f64::NAN, 0.2]));
    macro_rules! check {
        ($run:expr) => {{
            let run = $run;
            let (mut right, mut sim) = (run(good), run(bad));
            assert!(matches!(sim.step(), Err(StepError { failure: Failure::NonFiniteState, .. })));
            sim.set_state(good);
            for sim in [&mut right, &mut sim] {
                sim.advance_to(10.0).expect("steps");
            }
            assert_eq!((sim.state(), sim.steps()), (right.state(), right.steps()));
        }};
    }
    check!(|start| system.adaptive(RK4, 1e-8, start));
    check!(|start| system.taylor(Taylor { tolerance: 1e-8 }, start));
}

/// A first step that is far too short costs few extra steps, with methods of every order.
#[test]
fn steps_grow_by_every_order() {
    struct Grow;
    impl Visitor<TwoOscillators> for Grow {
        fn visit<M: Method<TwoOscillators> + 'static>(&mut self, method: M) {
            let system = TwoOscillators { m: [1.6, 0.5], k: [2.5, 32.0] };
            let run = || system.adaptive(method, 1e-3, State::new([1.0, 0.5], [0.3, 0.2]));
            let (mut usual, mut short) = (run(), run().first_step(1e-12).steps_at_most(2000));
            for sim in [&mut usual, &mut short] {
                sim.advance_to(1.0).unwrap_or_else(|error| panic!("{}: {error}", method.name()));
            }
            assert!(short.steps() < usual.steps() + 200, "{}: {}, {}", method.name(), short.steps(), usual.steps());
        }
    }
    methods::kinds_of_general(&mut Grow);
    methods::kinds_of_separable(&mut Grow);
    // Orders 6 to 12.
    Grow.visit(Yoshida6a.of(StormerVerlet));
    Grow.visit(DOP853);
    Grow.visit(KahanLi8_17a.of(StormerVerlet));
    Grow.visit(SofroniouSpaletta10_35.of(StormerVerlet));
    Grow.visit(Gauss::<6>);
}
