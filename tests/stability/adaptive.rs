//! Adaptive steps: the invariants that survive any sequence of step lengths, and how the integrator chooses and refuses steps and ends a run.

use geoint_runtime::method::{Visitor, catalogue};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::Snapshot;
use geoint_runtime::{Failure, Method};
use geoint_tests::measure::{Noise, distance, solution};
use geoint_tests::methods;
use geoint_tests::problems::*;
use geoint_tests::scalars::Double;
use std::f64::consts::TAU;

/// Returns Kepler's problem, a start at the pericentre of an ellipse of eccentricity `e` with semi-major axis 1.3, and the period.
fn ellipse(e: f64) -> (Kepler, State<[f64; 2]>, f64) {
    let (mass, mu, a) = (1.6, 2.3, 1.3_f64);
    let speed = (mu / (mass * a) * (1.0 + e) / (1.0 - e)).sqrt();
    let period = TAU * (mass * a.powi(3) / mu).sqrt();
    (Kepler { mass, mu }, State::new([a * (1.0 - e), 0.0], [0.0, mass * speed]), period)
}

fn spin(state: &State<[f64; 2]>) -> f64 {
    state.q[0] * state.p[1] - state.q[1] * state.p[0]
}

/// Returns the largest relative errors of energy and angular momentum on the way to `t`.
fn drift<M: Method<Kepler>>(sim: &mut Adaptive<Kepler, M>, t: f64) -> (f64, f64) {
    let (system, start) = (*sim.system(), sim.state());
    let (energy, momentum) = (system.energy(&start), spin(&start));
    sim.until(t).map(Result::unwrap).fold((0.0, 0.0), |(h, l), state| {
        let (gap_h, gap_l) = (system.energy(&state) / energy - 1.0, spin(&state) / momentum - 1.0);
        (f64::max(h, gap_h.abs()), f64::max(l, gap_l.abs()))
    })
}

/// Follows a comet for a thousand periods. Energy and angular momentum keep a relative error of at most 10⁻¹², with fewer than 150 000 steps.
#[test]
fn discrete_gradient_keeps_energy_and_angular_momentum_of_a_comet() {
    let (system, start, period) = ellipse(0.9);
    let mut sim = system.adaptive(DiscreteGradient, 1e-4, start);
    let (energy, momentum) = drift(&mut sim, 1000.0 * period);
    println!(
        "energy {energy:.1e}, angular momentum {momentum:.1e}; {} steps, {} rejected",
        sim.steps(),
        sim.rejections()
    );
    assert!(energy <= 1e-12 && momentum <= 1e-12, "energy {energy:.1e}, angular momentum {momentum:.1e}");
    assert_eq!(sim.time(), 1000.0 * period);
    assert!(sim.steps() < 150_000 && 10 * sim.rejections() < sim.steps());
    // Controls: adaptive steps by `StormerVerlet` lose the energy (error above 10⁻⁴). `RK4` loses both invariants (errors above 10⁻⁶).
    let (energy, momentum) = drift(&mut system.adaptive(StormerVerlet, 1e-4, start), 10.0 * period);
    assert!(energy > 1e-4 && momentum < 1e-12, "{energy:.1e} {momentum:.1e}");
    let (energy, momentum) = drift(&mut system.adaptive(RK4, 1e-4, start), 10.0 * period);
    assert!(energy > 1e-6 && momentum > 1e-6, "{energy:.1e} {momentum:.1e}");
}

/// Methods that keep the energy by a correction keep it in adaptive runs, too. Some of them scale their steps. The run still ends at the requested time.
#[test]
fn corrected_methods_adapt() {
    fn check<M: Method<Kepler>>(name: &str, method: M, e: f64) {
        let (system, start, period) = ellipse(e);
        let mut sim = system.adaptive(method, 1e-6, start);
        let (energy, _) = drift(&mut sim, 20.0 * period);
        println!("{name}: energy {energy:.1e}; {} steps, {} rejected", sim.steps(), sim.rejections());
        assert!(energy <= 5e-13, "{name}: {energy:.1e}");
        assert_eq!(sim.time(), 20.0 * period, "{name}");
    }
    check("projection", Projection(RK4, Energy), 0.9);
    check("projection", Projection(DOP853, Energy), 0.9);
    check("relaxation", Relaxation(RK4), 0.2);
    check("relaxation", Relaxation(DOP853), 0.2);
    check("composition", Suzuki4.of(DiscreteGradient), 0.9);
}

/// A discrete gradient keeps the energy to 10⁻¹⁴ with random step sizes. A symplectic method needs equal steps: its error exceeds 10⁻⁴.
#[test]
fn random_steps_keep_the_energy() {
    fn largest<M: Method<HenonHeiles>>(method: M, compensated: bool) -> f64 {
        let (system, start) = (HenonHeiles::system::<f64>(), HenonHeiles::initial::<f64>(0.0));
        let energy = system.energy(&start);
        let mut plain = system.integrator(method, 0.1, start);
        let mut carried = plain.clone().compensated();
        let mut error = 0.0_f64;
        for noise in Noise::new(5).take(2000) {
            let h = 0.16 + 0.14 * noise;
            let now = if compensated {
                carried.set_step_size(h);
                carried.step().map(|()| carried.energy())
            } else {
                plain.set_step_size(h);
                plain.step().map(|()| plain.energy())
            };
            error = error.max((now.unwrap() - energy).abs());
        }
        error
    }
    for compensated in [false, true] {
        let error = largest(DiscreteGradient, compensated);
        println!("compensated {compensated}: {error:.1e}");
        assert!(error < 1e-14, "{error:.1e}");
    }
    let error = largest(StormerVerlet, false);
    assert!(error > 1e-4, "{error:.1e}");
}

/// The error at the end is at most the number of steps times the tolerance. A smaller tolerance gives a smaller error. The methods have different orders.
#[test]
fn errors_follow_the_tolerance() {
    let (start, t) = (DoublePendulum::initial::<f64>(0.4), 3.4);
    let lifted = DoublePendulum::initial::<Double>(0.4);
    let exact = solution(&DoublePendulum::system::<Double>(), &lifted, Double::from(t) - lifted.t, 40);
    let exact: Vec<f64> = exact.iter().map(|x| x.value()).collect();
    let run = |method: &dyn Fn(f64) -> (Vec<f64>, u64), name: &str| {
        let mut before: Option<(f64, u64)> = None;
        for tolerance in [1e-5, 1e-7, 1e-9] {
            let (end, steps) = method(tolerance);
            let error = distance(&end, &exact);
            println!("{name} {tolerance:.0e}: {error:.1e} in {steps} steps");
            assert!(error < steps as f64 * tolerance, "{name} {tolerance:.0e}: {error:.1e}");
            if let Some((error_before, steps_before)) = before {
                assert!(error < 0.1 * error_before && steps > steps_before, "{name} {tolerance:.0e}: {error:.1e}");
            }
            before = Some((error, steps));
        }
    };
    macro_rules! check {
        ($($method:expr),*) => { $( run(&|tolerance| {
            let mut sim = DoublePendulum::system::<f64>().adaptive($method, tolerance, start);
            sim.advance_to(t).unwrap();
            assert_eq!(sim.time(), t);
            (flat(&sim.state()), sim.steps())
        }, stringify!($method)); )* };
    }
    check!(DiscreteGradient, RK4, Gauss::<2>, DOP853, Projection(RK4, Energy));
}

/// Step sizes stay within their bounds. Fewer than a quarter of the steps have another length than the step before.
#[test]
fn most_steps_are_like_the_one_before() {
    let (system, start, period) = ellipse(0.6);
    let mut sim = system.adaptive(DiscreteGradient, 1e-6, start).steps_between(1e-3, 0.01);
    let (mut changes, mut before) = (0, sim.step_size());
    while sim.time() < 3.0 * period {
        let now = sim.step_size();
        assert!((1e-3..=0.01).contains(&now), "{now}");
        changes += u64::from(now != before);
        (before, _) = (now, sim.step().unwrap());
    }
    assert!(changes > 10 && 4 * changes < sim.steps(), "{changes} of {}", sim.steps());
}

/// A first step of 10⁴ units of time is rejected at least five times. The accepted step is shorter than 0.1.
#[test]
fn long_steps_are_rejected() {
    let mut sim =
        DoublePendulum::system::<f64>().adaptive(DiscreteGradient, 1e-8, DoublePendulum::initial(0.0)).first_step(1e4);
    sim.step().unwrap();
    assert!(sim.rejections() >= 5 && sim.steps() == 1, "{} rejections", sim.rejections());
    assert!(sim.time() < 0.1);
    let rejected = sim.rejections();
    sim.advance_to(1.0).unwrap();
    assert!(sim.rejections() < rejected + sim.steps() / 5);
}

/// Integrates to t = 2 and back to the start. The requested time determines the sign of the step.
#[test]
fn backwards() {
    let start = DoublePendulum::initial::<f64>(0.4);
    let mut sim = DoublePendulum::system::<f64>().adaptive(DiscreteGradient, 1e-8, start);
    sim.advance_to(2.0).unwrap();
    assert!(sim.step_size() > 0.0 && distance(&flat(&sim.state()), &flat(&start)) > 0.1);
    let times: Vec<f64> = sim.until(0.4).map(|state| state.unwrap().t).collect();
    assert!(times.windows(2).all(|pair| pair[0] > pair[1]) && times.last() == Some(&0.4));
    assert!(sim.step_size() < 0.0);
    let gap = distance(&flat(&sim.state()), &flat(&start));
    assert!(gap < 1e-6, "{gap:.1e}");
    let mut sim = DoublePendulum::system::<f64>().adaptive(DiscreteGradient, 1e-8, start).first_step(-0.01);
    sim.step().unwrap();
    assert!(sim.time() < 0.4);
}

#[test]
fn until_ends_at_the_time() {
    for (from, to) in [(0.0, 1.0), (0.3, 0.1), (-0.7, 0.0), (1.0, 1.0 + 4.0 * f64::EPSILON), (1e6, 1e6 + 0.1)] {
        let start = State { t: from, ..Pendulum::initial(0.0) };
        let mut sim = Pendulum::system::<f64>().adaptive(DiscreteGradient, 1e-6, start);
        let times: Vec<f64> = sim.until(to).map(|state| state.unwrap().t).collect();
        assert_eq!(times.last(), Some(&to), "from {from}");
        assert!(times.windows(2).all(|pair| (pair[0] < pair[1]) == (from < to)));
        assert_eq!(sim.until(to).count(), 0);
    }
    // Frequent output does not prevent the run from ending exactly at each requested time.
    let mut sim = Pendulum::system::<f64>().adaptive(DiscreteGradient, 1e-6, Pendulum::initial(0.0));
    for n in 1..=200 {
        sim.advance_to(f64::from(n) * 0.01).unwrap();
        assert_eq!(sim.time(), f64::from(n) * 0.01);
    }
}

/// A root that ends at q = 1.
#[hamiltonian]
fn rim(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - (1.0 - q * q).sqrt()
}

/// A logarithmic wall at q = 0.
#[hamiltonian]
fn wall(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) - k * q.ln() + q
}

/// Adaptive steps approach the boundary of the domain, and report the boundary. The state is then the last good state.
#[test]
fn the_edge_of_the_domain_is_approached() {
    fn check<M: Method<Rim>>(name: &str, method: M) {
        let mut sim = Rim { m: 1.4 }.adaptive(method, 1e-6, State::new(0.2, 2.0));
        let outcome: Vec<_> = sim.until(100.0).collect();
        let (error, good) = outcome.split_last().unwrap();
        let last = good.last().unwrap().unwrap();
        let Err(error @ StepError { t, h, failure: Failure::OutsideDomain { what }, .. }) = *error else {
            panic!("{name}: {error:?}")
        };
        println!("{name}: q = 1 − {:.1e}, h = {h:.1e}", 1.0 - last.q);
        // The message names the root, either for a point behind the boundary or for the boundary itself, at which the root has no derivative.
        let named = |text: &str| text.contains("`sqrt`") || text.ends_with("√(-q² + 1)");
        assert!(named(what), "{name}: {what}");
        assert!(error.is_shortest() && error.to_string().contains(what), "{error}");
        assert!(h > 0.0 && h < 1e-14 && t == last.t, "{name}: {h:.1e}");
        assert!(last.q <= 1.0 && last.q > 1.0 - 1e-6, "{name}: {}", last.q);
        assert_eq!(sim.state(), last, "{name}");
        assert!(sim.step().is_err() && sim.state() == last, "{name}");
        sim.advance_to(0.0).unwrap();
    }
    check("DiscreteGradient", DiscreteGradient);
    check("ImplicitMidpoint", ImplicitMidpoint);
    check("RK4", RK4);
    check("StormerVerlet", StormerVerlet);
}

/// Equal steps jump through this wall. Adaptive steps bounce off.
#[test]
fn a_wall_is_bounced_off() {
    fn check<M: Method<Wall>>(name: &str, method: M) {
        let mut sim = Wall { m: 1.3, k: 0.5 }.adaptive(method, 1e-6, State::new(2.0, -1.0)).first_step(0.31);
        let energy = sim.energy();
        let nearest = sim.until(30.0).map(|state| state.unwrap().q).fold(f64::INFINITY, f64::min);
        assert!(nearest > 0.0 && nearest < 0.02, "{name}: {nearest}");
        assert!((sim.energy() - energy).abs() < 1e-2, "{name}");
    }
    check("StormerVerlet", StormerVerlet);
    check("RK4", RK4);
    check("DiscreteGradient", DiscreteGradient);
}

/// A run ends with an error if even the shortest allowed step is too inaccurate.
#[test]
fn the_shortest_step_is_too_long() {
    let start = DoublePendulum::initial::<f64>(0.4);
    let mut sim = DoublePendulum::system::<f64>()
        .adaptive(DiscreteGradient, 1e-13, start)
        .steps_between(0.05, 1.0)
        .first_step(1.0);
    for _ in 0..2 {
        let error = sim.advance_to(2.0).unwrap_err();
        let StepError { t, h, failure: Failure::Inaccurate { error }, .. } = error else { panic!("{error}") };
        assert!(t == 0.4 && h == 0.05 && error > 1.0, "{t} {h} {error}");
        assert_eq!((sim.state(), sim.steps()), (start, 0));
    }
    assert!(sim.rejections() > 2);
    // Shorter steps succeed.
    let mut sim = sim.steps_between(1e-6, 1.0);
    sim.step().unwrap();
}

#[test]
fn unusable_input() {
    let start = Pendulum::initial::<f64>(0.3);
    let with = |tolerance: f64| Pendulum::system::<f64>().adaptive(DiscreteGradient, tolerance, start);
    for tolerance in [0.0, -1e-6, f64::NAN, f64::INFINITY] {
        let mut sim = with(tolerance);
        assert!(matches!(sim.step(), Err(StepError { failure: Failure::InvalidTolerance { .. }, .. })), "{tolerance}");
        assert_eq!(sim.state(), start);
    }
    for h in [0.0, f64::NAN, f64::INFINITY] {
        let error = with(1e-6).first_step(h).step().unwrap_err();
        assert!(
            matches!(error, StepError { failure: Failure::InvalidStepSize { h: seen }, .. } if seen == h || h.is_nan()),
            "{h}: {error}"
        );
    }
    for (shortest, longest) in
        [(1.0, 0.1), (f64::NAN, 1.0), (0.1, f64::NAN), (f64::INFINITY, f64::INFINITY), (0.0, 0.0)]
    {
        let error = with(1e-6).steps_between(shortest, longest).step().unwrap_err();
        assert!(
            matches!(error, StepError { failure: Failure::InvalidBounds { .. }, .. }),
            "{shortest} {longest}: {error}"
        );
    }
    // The message suggests a correction.
    let said =
        |shortest: f64, longest: f64| with(1e-6).steps_between(shortest, longest).step().unwrap_err().to_string();
    assert_eq!(
        said(0.5, 0.1),
        "no step is longer than 0.5 and shorter than 0.1; give the shorter length first: `steps_between(0.1, 0.5)`"
    );
    assert!(said(0.0, 0.0).contains("give a shortest one that is finite"), "{}", said(0.0, 0.0));
    assert!(said(f64::NAN, 1.0).contains("no step has a length between NaN and 1;"), "{}", said(f64::NAN, 1.0));
    let outcome: Vec<_> = with(1e-6).until(f64::NAN).collect();
    assert!(matches!(outcome[..], [Err(StepError { failure: Failure::InvalidStepSize { .. }, .. })]), "{outcome:?}");
    let mut sim = Pendulum::system::<f64>().adaptive(RK4, 1e-6, State::new(f64::NAN, 0.0));
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::NonFiniteState, .. })));
    let mut sim = Rim { m: 1.4 }.adaptive(RK4, 1e-6, State::new(1.5, 0.0));
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })));
}

/// An adaptive run in `f32` ends exactly at t = 10, in more than 50 steps, with an energy error below 10⁻⁶.
#[test]
fn short_numbers() {
    let mut sim = ShortPendulum { m: 1.3, l: 0.7, g: 9.81 }.adaptive(DiscreteGradient, 1e-4, State::new(0.1_f32, 0.0));
    let energy = sim.energy();
    sim.advance_to(10.0).unwrap();
    assert_eq!(sim.time(), 10.0);
    assert!((sim.energy() - energy).abs() < 1e-6 && sim.steps() > 50, "{} {}", sim.energy() - energy, sim.steps());
}

/// Doubts of which shorter steps are not free: a sign on which structure relies does not hold, and of two poles parameters rule one out.
#[hamiltonian]
fn well(q: f64, p: f64, m: f64, a: f64) -> f64 {
    p * p / (2.0 * m) + q * q + 1.0 / (1.0 + a * q * q)
}

#[hamiltonian]
fn two_poles(q: [f64; 2], p: [f64; 2], m: f64, e: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + e / (m + q[1] * q[1]) - m / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

#[contact_hamiltonian]
fn damped_well(q: f64, p: f64, s: f64, m: f64, a: f64) -> f64 {
    p * p / (2.0 * m) + q * q + 1.0 / (1.0 + a * q * q) + 0.1 * s
}

#[vector_field(keeps(h = x[1] * x[1] / (2.0 * m) + x[0] * x[0] + 1.0 / (1.0 + a * x[0] * x[0])))]
fn field_of_well(x: [f64; 2], m: f64, a: f64) -> [f64; 2] {
    let d = 1.0 + a * x[0] * x[0];
    [x[1] / m, -2.0 * x[0] + 2.0 * a * x[0] / (d * d)]
}

#[lagrangian]
fn well_of_velocity(q: f64, v: f64, m: f64, a: f64) -> f64 {
    -m * (1.0 - v * v).sqrt() - q * q - 1.0 / (1.0 + a * q * q)
}

#[test]
fn no_doubt_ends_a_run() {
    /// Compares the end of a run with the end of an accurate run.
    fn ends<X: Snapshot<Real = f64> + std::fmt::Debug>(
        name: &str,
        mut sim: impl Trajectory<State = X>,
        end: X,
        gap: impl Fn(X, X) -> f64,
    ) {
        sim.advance_to(10.0).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(gap(sim.state(), end) < 1e-2, "{name}: {:?}, {end:?}", sim.state());
    }
    macro_rules! check {
        ($system:expr, $state:expr, $gap:expr, $($method:expr),*) => { {
            let mut exact = $system.adaptive(DOP853, 1e-12, $state);
            exact.advance_to(10.0).unwrap();
            $( ends(stringify!($method), $system.adaptive($method, 1e-6, $state), exact.state(), $gap); )*
        } };
    }
    let gap = |x: State<f64>, y: State<f64>| (x.q - y.q).hypot(x.p - y.p);
    for a in [-0.01, 0.0, 0.01] {
        let (m, start) = (1.3, State::new(0.8, 0.1));
        check!(Well { m, a }, start, gap, DiscreteGradient, FourthOrder(DiscreteGradient), Gonzalez, ImplicitMidpoint);
        check!(Well { m, a }, start, gap, Gauss::<2>, Gauss::<4>, Suzuki4.of(DiscreteGradient), BlanesMoan4);
        check!(Well { m, a }, start, gap, Projection(RK4, Energy), Projection(DOP853, Energy), Relaxation(DOP853));
        let system = WellOfVelocity { m, a };
        check!(system, system.at(0.8, 0.1), gap, DiscreteGradient, Gauss::<2>, ImplicitMidpoint);
        let gap = |x: ContactState<f64>, y: ContactState<f64>| (x.q - y.q).hypot(x.s - y.s);
        let start = ContactState::new(0.8, 0.1, 0.0);
        check!(DampedWell { m, a }, start, gap, ContactDiscreteGradient, ContactGauss::<2>, ContactMidpoint);
        let gap = |x: FlowState<[f64; 2]>, y: FlowState<[f64; 2]>| (x.x[0] - y.x[0]).hypot(x.x[1] - y.x[1]);
        let start = FlowState::new([0.8, 0.1]);
        check!(
            FieldOfWell { m, a },
            start,
            gap,
            DiscreteGradient,
            FourthOrder(DiscreteGradient),
            PlanarSplitting,
            Gauss::<2>
        );
    }
    let (system, start) = (TwoPoles { m: 1.0, e: 1e-3 }, State::new([0.8, 0.1], [0.1, 1.0]));
    let mut exact = system.adaptive(DOP853, 1e-12, start);
    exact.advance_to(3.0).unwrap();
    let mut all = Adapts { system, start, end: exact.state(), methods: 0 };
    methods::kinds_of_general(&mut all);
    methods::kinds_of_discrete_gradient(&mut all);
    methods::kinds_of_itoh_abe(&mut all);
    methods::itoh_abe_one_way(&mut all);
    catalogue::coordinate_increment(&mut all);
    methods::projected(&mut all);
    methods::relaxed(&mut all);
    assert_eq!(all.methods, 20);
}

/// Takes an adaptive run with every method of a list.
struct Adapts {
    system: TwoPoles,
    start: State<[f64; 2]>,
    end: State<[f64; 2]>,
    methods: usize,
}

impl Visitor<TwoPoles> for Adapts {
    fn visit<M: Method<TwoPoles> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let mut sim = self.system.adaptive(method, 1e-6, self.start);
        sim.advance_to(3.0).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (q, end) = (sim.state().q, self.end.q);
        assert!((q[0] - end[0]).hypot(q[1] - end[1]) < 5e-2, "{name}: {q:?}, {end:?}");
        self.methods += 1;
    }
}

/// A run from an unusable start returns an error even if no step remains to be taken. Sampling such a run yields no state.
#[test]
fn a_start_is_examined_where_no_step_is_taken() {
    let (system, state) = (Well { m: 1.3, a: 0.01 }, State::new(f64::NAN, 0.1));
    let refused = |outcome: Result<(), StepError>| {
        assert!(matches!(outcome, Err(StepError { failure: Failure::NonFiniteState, .. })), "{outcome:?}")
    };
    let late = State::at(f64::INFINITY, 0.3, 0.1);
    refused(system.adaptive(DOP853, 1e-7, state).advance_to(0.0));
    refused(system.adaptive(DOP853, 1e-7, late).advance_to(f64::INFINITY));
    refused(system.taylor(Taylor::default(), state).advance_to(0.0));
    refused(system.taylor(Taylor::default(), late).advance_to(f64::INFINITY));
    let wrong = system.adaptive(DOP853, -1.0, State::new(0.3, 0.1)).advance_to(0.0);
    assert!(matches!(wrong, Err(StepError { failure: Failure::InvalidTolerance { .. }, .. })), "{wrong:?}");
    fn samples<T: Dense<State = State<f64>>>(run: T) {
        for outcomes in
            [run.clone().sampled_every(0.5).take(3).collect::<Vec<_>>(), run.clone().sampled_at([0.0, 0.5]).collect()]
        {
            assert!(matches!(outcomes[..], [Err(StepError { failure: Failure::NonFiniteState, .. })]), "{outcomes:?}");
        }
    }
    // A sample of the start takes no step. The first step of this run would cross a pole.
    let start = State::new(9.9, 100.0);
    let mut sim = Well { m: 1.3, a: -0.01 }.integrator(Relaxation(RK4), 0.1, start);
    let outcomes: Vec<_> = sim.sampled_every(0.1).take(3).collect();
    assert!(
        matches!(outcomes[..], [Ok(first), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })] if first == start),
        "{outcomes:?}"
    );
    samples(system.integrator(StormerVerlet, 0.1, state));
    samples(system.adaptive(DOP853, 1e-7, state));
    samples(system.taylor(Taylor::default(), state));
}
