//! Error estimates of Gauss methods from the defect of their polynomial.

use geoint_runtime::method::{Claims, Estimate, Failure, Name, Probe, Step, Unwatched};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::Jets;
use geoint_runtime::space::{Array, Plain, Point, Snapshot, Summation};
use geoint_runtime::system::{Rates, StateOf};
use geoint_runtime::{Method, PhaseSpace, Real, TaylorIntegrator};
use geoint_tests::measure::{distance, extrapolated};
use geoint_tests::problems::{
    Breathing, DoublePendulum, DrivenPendulum, HenonHeiles, Kepler, ShortPendulum, SwingingMass,
};
use geoint_tests::scalars::Double;
use geoint_tests::scene::{Scene, flat, point};

/// Wraps a method. Its error is estimated by comparison with half steps, without the method's own estimate.
#[derive(Clone, Copy, Debug)]
struct Halves<M>(M);

impl<S: PhaseSpace, M: Method<S>> Method<S> for Halves<M> {
    delegate_step!();

    fn name(&self) -> Name {
        Name::new("halves").of(self.0.name())
    }
    fn prepare(&self, system: &S, h: f64) -> Self::Prepared {
        self.0.prepare(system, h)
    }
}

/// The estimate of one step, and its error, by their largest entries.
fn step<P: Scene, M: Method<P::Over<Double>, Double>>(method: M, h: f64) -> [f64; 2] {
    let (start, x) = P::start();
    let x: Vec<Double> = x.into_iter().map(Double::from).collect();
    let system = P::over::<Double>();
    let (t, z, s) = point::<StateOf<P::Over<Double>, Double>>(start.into(), &x).parts();
    let exact = extrapolated(|t, x: &[Double]| P::rate(&system, t, x), t, x, h.into(), 8);
    let mut x: Point<_, Plain, _> = Point::with_action(z, s);
    let (prepared, mut memory) = (method.prepare(&system, h.into()), M::memory(&z));
    let step = Step { system: &system, t, end: t + Double::from(h), x: &mut x, probe: &mut Unwatched };
    let estimate: Estimate<P::Over<Double>, Double> =
        M::estimated(&prepared, &mut memory, step).expect("an estimate").expect("a step");
    let estimate = estimate[0].z.as_slice().iter().map(|x| x.magnitude()).fold(0.0, f64::max);
    [estimate, distance(x.z.as_slice(), &exact)]
}

/// Estimates fall with the step length in the order of the errors, and exceed the errors. The scenes have one and two derivatives, and time-dependent forces.
#[test]
fn estimates_have_the_order_of_errors() {
    fn check<P: Scene, const S: usize>(h: f64)
    where
        Gauss<S>: Method<P::Over<Double>, Double>,
    {
        assert_eq!(Method::<P::Over<Double>, Double>::order_of_estimate(&Gauss::<S>), Some(2 * S as u32));
        // The mean of several lengths, because an entry may change its sign at a single length. Much shorter steps show the rounding of weights.
        let lengths = [1.0, 0.9, 0.8, 0.7].map(|part| part * h * S as f64);
        let mut orders = [0.0; 2];
        for h in lengths {
            let [long, short] = [h, h / 2.0].map(|h| step::<P, _>(Gauss::<S>, h));
            for (order, (long, short)) in orders.iter_mut().zip(long.into_iter().zip(short)) {
                *order += (long / short).log2() / lengths.len() as f64;
            }
            for [estimate, error] in [long, short] {
                let covers = estimate / error;
                assert!(covers > 1.0 && covers < 1e5, "{} {S}: h = {h}, {covers:.2}", P::NAME);
            }
        }
        println!("{} {S}: h^{:.2}, h^{:.2}", P::NAME, orders[0], orders[1]);
        // At these lengths higher orders of some errors are still seen.
        let off = [(2 * S + 1) as f64, orders[1]].map(|order| (orders[0] - order).abs());
        assert!(off[0].min(off[1]) < 0.7, "{} {S}: h^{:.2}, h^{:.2}", P::NAME, orders[0], orders[1]);
    }
    fn all<P: Scene>(h: f64)
    where
        Gauss<3>: Method<P::Over<Double>, Double>,
        Gauss<4>: Method<P::Over<Double>, Double>,
    {
        check::<P, 3>(h);
        check::<P, 4>(h);
    }
    all::<HenonHeiles>(0.13);
    all::<DoublePendulum>(0.05);
    all::<DrivenPendulum>(0.13);
    all::<Breathing>(0.1);
    all::<SwingingMass>(0.13);
}

/// Returns the largest error of a step of a run. The unit is the tolerance times the largest magnitude of the coordinate on the whole way.
fn worst<S, M: Method<S>>(system: S, method: M, tolerance: f64, start: StateOf<S, f64>, t: f64) -> f64
where
    S: Rates + Jets + Copy,
    StateOf<S, f64>: Copy,
{
    let mut sizes = vec![0.0_f64; flat(&start).len()];
    let mut sim = TaylorIntegrator::new(system, Taylor::default(), start);
    while sim.time() < t {
        sim.step_towards(t).expect("steps");
        sizes.iter_mut().zip(flat(&sim.state())).for_each(|(size, x)| *size = size.max(x.abs()));
    }
    let (mut sim, mut worst) = (system.adaptive(method, tolerance, start).steps_at_most(20_000), 0.0_f64);
    while sim.time() < t {
        let mut exact = TaylorIntegrator::new(system, Taylor::default(), sim.state());
        sim.step_towards(t).expect("steps");
        exact.advance_to(sim.time()).expect("steps");
        for ((x, exact), size) in flat(&sim.state()).into_iter().zip(flat(&exact.state())).zip(&sizes) {
            worst = worst.max((x - exact).abs() / (size * tolerance));
        }
    }
    worst
}

/// The centre is a mass, so that momenta are no velocities.
#[hamiltonian]
fn orbit(q: [f64; 2], p: [f64; 2], m: f64, mu: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - m * mu / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// An ellipse with e = 0.6 in other units, from its nearest point.
fn ellipse([length, time]: [f64; 2]) -> (Orbit, State<[f64; 2]>) {
    let (m, mu) = (1.3, length.powi(3) / (time * time));
    (Orbit { m, mu }, State::new([0.4 * length, 0.0], [0.0, 2.0 * m * length / time]))
}

/// A pendulum of type `f64`.
#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}

/// A pendulum on a spring.
#[hamiltonian]
fn spring(q: [f64; 2], p: [f64; 2], m: f64, k: f64, l: f64, g: f64) -> f64 {
    let stretch = (q[0] * q[0] + q[1] * q[1]).sqrt() - l;
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + k * stretch * stretch / 2.0 + m * g * q[1]
}

/// Nothing but forces in time, a slow one and a fast one of a thousandth.
#[hamiltonian]
fn pushed(t: f64, q: f64, p: f64, m: f64, a: f64, w: f64) -> f64 {
    p * p / (2.0 * m) - a * q * (w * t).sin() - q * (0.2 * t).cos()
}

/// Relaxation oscillations.
#[vector_field]
fn relaxing(x: [f64; 2], epsilon: f64) -> [f64; 2] {
    [x[1], epsilon * (1.0 - x[0] * x[0]) * x[1] - x[0]]
}

/// A pendulum in air.
#[hamiltonian(damping = c)]
fn in_air(q: f64, p: f64, m: f64, g: f64, c: f64) -> f64 {
    p * p / (2.0 * m) - m * g * q.cos()
}

/// No step has a larger error than the tolerance. The cases: vanishing rates, small vibrations beside large motions, a force of time alone, and other units.
#[test]
fn local_errors_are_covered() {
    fn covered<S, M: Method<S>>(system: S, method: M, tolerance: f64, start: StateOf<S, f64>, t: f64)
    where
        S: Rates + Jets + Copy,
        StateOf<S, f64>: Copy,
    {
        let worst = worst(system, method, tolerance, start, t);
        println!("{}, {tolerance:.0e}: {worst:.3}", method.name());
        assert!(worst < 1.0, "{}, {tolerance:.0e}: {worst:.2}", method.name());
    }
    macro_rules! check {
        ($($system:expr, $start:expr, $t:expr => $($method:expr),*;)*) => { $({ $(
            for tolerance in [1e-4, 1e-8] {
                covered($system, $method, tolerance, $start, $t);
            }
        )* })* };
    }
    let units = [[1.0, 1.0], [3e8, 5e-3]];
    for [length, time] in units {
        let (orbit, start) = ellipse([length, time]);
        check! { orbit, start, 15.0 * time => Gauss::<3>, Gauss::<4>; }
    }
    let swing = Pendulum { m: 1.3, l: 0.7, g: 9.81 };
    // 50 vibrations a swing, and none at the start.
    let stiff = Spring { m: 1.3, k: 1.3 * 9.81 * 2500.0, l: 1.0, g: 9.81 };
    check! {
        swing, State::new(0.0, 0.0001), 3.0 => Gauss::<3>, Gauss::<4>;
        swing, State::new(std::f64::consts::PI - 1e-4, 0.0), 5.0 => Gauss::<3>, Gauss::<4>;
        stiff, State::new([0.8, -0.6], [0.0, 0.0]), 2.0 => Gauss::<3>, Gauss::<4>;
        Pushed { m: 0.7, a: 1e-3, w: 40.0 }, State::new(0.5, 0.2), 10.0 => Gauss::<3>, Gauss::<4>;
        Relaxing { epsilon: 100.0 }, FlowState::new([2.0, 0.0]), 150.0 => Gauss::<3>, Gauss::<4>;
        InAir { m: 1.3, g: 2.1, c: 0.4 }, State::new(1.4, 0.0), 10.0 => Gauss::<3>, Gauss::<4>;
    }
    // Control: a run with tolerance 10⁻⁷ exceeds the tolerance 10⁻¹⁰.
    let (orbit, start) = ellipse([1.0, 1.0]);
    assert!(1e3 * worst(orbit, Gauss::<3>, 1e-7, start, 15.0) > 1.0);
}

/// In single precision the same, against double.
#[test]
fn single_precision() {
    let (m, l, g, tolerance) = (1.3_f32, 0.7, 9.81, 1e-4);
    let system = Pendulum { m: m.into(), l: l.into(), g: g.into() };
    let mut sim = ShortPendulum { m, l, g }.adaptive(Gauss::<3>, tolerance, State::new(1.1_f32, 0.0));
    let mut worst = 0.0_f64;
    while sim.time() < 5.0 {
        let State { t, q, p } = sim.state();
        let mut exact = system.taylor(Taylor::default(), State::at(f64::from(t), f64::from(q), f64::from(p)));
        sim.step_towards(5.0).expect("steps");
        exact.advance_to(f64::from(sim.time())).expect("steps");
        // The largest angle, and the largest momentum: of the energy at the start.
        let sizes = [1.1, (2.0 * system.m.powi(2) * system.g * system.l.powi(3) * (1.0 - 1.1_f64.cos())).sqrt()];
        let ends = [(sim.state().q, exact.state().q), (sim.state().p, exact.state().p)];
        for ((x, exact), size) in ends.into_iter().zip(sizes) {
            worst = worst.max((f64::from(x) - exact).abs() / (size * tolerance));
        }
    }
    println!("{worst:.3} in {} steps", sim.steps());
    assert!(worst < 1.0 && sim.steps() < 100, "{worst:.2} in {} steps", sim.steps());
}

/// Steps become longer with the tolerance as an error of order 2s + 1 asks for.
#[test]
fn steps_follow_the_tolerance() {
    fn check<const S: usize>()
    where
        Gauss<S>: Method<HenonHeiles>,
    {
        let steps = [1e-5, 1e-9].map(|tolerance| {
            let system = HenonHeiles { m: [1.7, 0.6], lambda: 0.8 };
            let mut sim = system.adaptive(Gauss::<S>, tolerance, State::new([0.3, -0.2], [0.35, 0.25]));
            sim.advance_to(200.0).expect("steps");
            sim.steps() as f64
        });
        let power = (steps[1] / steps[0]).log10() / 4.0;
        println!("{S}: {:.2} for {}", 1.0 / power, 2 * S + 1);
        assert!((power * (2 * S + 1) as f64 - 1.0).abs() < 0.15, "{S}: {:.2}", 1.0 / power);
    }
    check::<3>();
    check::<4>();
}

/// For equal errors the method's own estimate solves fewer equations than the comparison with half steps.
#[test]
fn steps_cost_less_than_halves() {
    fn run<M: Method<Orbit>>(method: M, tolerance: f64, [length, time]: [f64; 2]) -> (f64, f64) {
        let (system, start) = ellipse([length, time]);
        let mut sim = system.adaptive(method, tolerance, start);
        sim.advance_to(20.0 * std::f64::consts::PI * time).expect("steps");
        let State { q, p, .. } = sim.state();
        let momentum = system.m * length / time;
        let off = [q[0] / length - 0.4, q[1] / length, p[0] / momentum, p[1] / momentum - 2.0];
        let error = off.into_iter().map(|x| x * x).sum::<f64>().sqrt();
        (error, (sim.steps() + sim.rejections()) as f64)
    }
    fn check<const S: usize>()
    where
        Gauss<S>: Method<Orbit>,
    {
        for units in [[1.0, 1.0], [3e8, 5e-3]] {
            // Means over several tolerances, because the errors of single runs depend on the ends of their steps.
            let mean = |of: &dyn Fn(f64) -> (f64, f64)| {
                let logarithms = (-2..=2).map(|k| of(10_f64.powf(-9.0 + 0.25 * f64::from(k))));
                logarithms.fold((0.0, 0.0), |sum, (error, steps)| (sum.0 + error.ln() / 5.0, sum.1 + steps.ln() / 5.0))
            };
            let own = mean(&|tolerance| run(Gauss::<S>, tolerance, units));
            let halves = mean(&|tolerance| run(Halves(Gauss::<S>), tolerance, units));
            // A step as a whole and its halves are three. Fewer for larger errors do not count.
            let ratio = (own.1 - halves.1).exp() / 3.0 * ((own.0 - halves.0) / (2 * S) as f64).exp();
            println!("Gauss<{S}>: {ratio:.2} of the equations, {:.1} times the error", (own.0 - halves.0).exp());
            assert!(ratio < 1.0 / 1.3, "Gauss<{S}>: {ratio:.2}");
        }
    }
    check::<3>();
    check::<4>();
}

/// Seven masses between eight springs.
#[hamiltonian]
fn chain(q: [f64; 7], p: [f64; 7], m: f64) -> f64 {
    let mut h = 0.5 * (q[0] * q[0] + q[6] * q[6]);
    for i in 0..7 {
        h += p[i] * p[i] / (2.0 * m);
    }
    for i in 1..7 {
        h += 0.5 * (q[i] - q[i - 1]).powi(2);
    }
    h
}

/// Other methods are compared with half steps. Half steps are cheaper for few stages or many unknowns, and nearer to rounding for five stages. A
/// subsequent correction, or substeps, change the meaning of the defect.
#[test]
fn others_are_compared_with_halves() {
    fn has<S: PhaseSpace + Rates, M: Method<S>>(_: &S, method: M) -> bool {
        method.order_of_estimate().is_some()
    }
    let kepler = Kepler { mass: 1.0, mu: 1.0 };
    assert!(has(&kepler, Gauss::<3>) && has(&kepler, Gauss::<4>));
    assert!(!has(&kepler, Gauss::<5>) && !has(&kepler, Gauss::<6>));
    assert!(!has(&kepler, Gauss::<2>) && !has(&kepler, Gauss::<1>) && !has(&kepler, ImplicitMidpoint));
    assert!(!has(&Chain { m: 1.3 }, Gauss::<3>));
    assert!(!has(&kepler, Projection(Gauss::<3>, Energy)) && !has(&kepler, Relaxation(Gauss::<3>)));
    assert!(!has(&kepler, Suzuki4.of(ImplicitMidpoint)));
}
