//! What Runge–Kutta–Nyström tables tell of their errors by the forces of a step.

use geoint_runtime::method::catalogue::quadratic_kinetic;
use geoint_runtime::method::splitting::Nystrom;
use geoint_runtime::method::{Claims, Estimate, Name, Probe, Refusal, Step, Unwatched, Visitor};
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Plain, Point, Snapshot, Summation};
use geoint_runtime::system::{QuadraticKinetic, Rates, StateOf};
use geoint_runtime::{PhaseSpace, Real, Splitting};
use geoint_tests::problems::{DrivenPendulum, HenonHeiles};
use geoint_tests::scalars::Double;
use geoint_tests::scene::{Scene, point};
use geoint_tests::scenes::Heavies;
use std::cell::Cell;

/// The largest entries of both estimates in one step; none where a method has none.
fn estimates<P: Scene, M: Method<P::Over<Double>, Double>>(method: M, h: f64) -> Option<[f64; 2]> {
    let (start, x) = P::start();
    let x: Vec<Double> = x.into_iter().map(Double::from).collect();
    let system = P::over::<Double>();
    let (t, z, s) = point::<StateOf<P::Over<Double>, Double>>(start.into(), &x).parts();
    let mut x: Point<_, Plain, _> = Point::with_action(z, s);
    let prepared = method.prepare(&system, h.into());
    let step = Step { system: &system, t, end: t + Double::from(h), x: &mut x, probe: &mut Unwatched };
    let both = M::estimated(&prepared, &mut M::memory(), step)?.expect("kicks and drifts have results");
    Some(both.map(|e| e.z.as_slice().iter().map(|x| x.magnitude()).fold(0.0, f64::max)))
}

/// The orders of both estimates: those of the conditions that their weights solve, and none of a higher one.
#[test]
fn estimates_have_their_orders() {
    struct Orders<P>(Vec<(String, u32)>, std::marker::PhantomData<P>);
    impl<P: Scene> Visitor<P::Over<Double>, Double> for Orders<P> {
        fn visit<M: Method<P::Over<Double>, Double> + 'static>(&mut self, method: M) {
            let Some(order) = method.order_of_estimate().filter(|_| method.claims().symplectic) else { return };
            let name = method.name().to_string();
            // Much shorter steps show the rounding of the weights.
            let [long, short] = [0.1, 0.05].map(|h| estimates::<P, M>(method, h).expect("an estimate"));
            let [higher, lower] = [0, 1].map(|i| (long[i] / short[i]).log2());
            let is = |observed: f64, power: u32| (observed - f64::from(power)).abs() < 0.25;
            // h⁵; h⁶ and h⁵, h⁷ and h⁵, of which the square over the other is of the order of the error of the method.
            let good = match order {
                4 => is(higher, 5) && long[1] == 0.0,
                _ => is(higher, order / 2 + 3) && is(lower, 5),
            };
            assert!(good, "{}: {name}: h^{higher:.2}, h^{lower:.2}", P::NAME);
            assert_eq!(order, method.claims().order, "{name}");
            self.0.push((name, order));
        }
    }
    fn check<P: Scene>()
    where
        P::Over<Double>: QuadraticKinetic<Double>,
    {
        let mut orders = Orders::<P>(vec![], std::marker::PhantomData);
        quadratic_kinetic(&mut orders);
        let seen: Vec<u32> = orders.0.iter().map(|(_, order)| *order).collect();
        assert_eq!(seen, [4, 6, 6, 8, 8], "{:?}", orders.0);
    }
    check::<HenonHeiles>();
    check::<DrivenPendulum>();
}

/// The centre is a mass, so that momenta are no velocities.
#[hamiltonian]
fn orbit(q: [f64; 2], p: [f64; 2], m: f64, mu: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - m * mu / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// A tolerance leads to no larger errors than comparing with halves does, and the same error takes fewer forces.
#[test]
fn steps_cost_less_than_halves() {
    fn run<M: Method<Orbit>>(method: M, tolerance: f64, [length, time]: [f64; 2]) -> (f64, f64) {
        // An ellipse with e = 0.6, ten times.
        let (m, mu) = (1.3, length.powi(3) / (time * time));
        let start = State::new([0.4 * length, 0.0], [0.0, 2.0 * m * length / time]);
        let mut sim = Orbit { m, mu }.adaptive(method, tolerance, start);
        sim.advance_to(20.0 * std::f64::consts::PI * time).expect("steps");
        let State { q, p, .. } = sim.state();
        let off = [q[0] / length - 0.4, q[1] / length, p[0] * time / (m * length), p[1] * time / (m * length) - 2.0];
        let error = off.into_iter().map(|x| x * x).sum::<f64>().sqrt();
        (error, (sim.steps() + sim.rejections()) as f64)
    }
    fn check<const K: usize, O: Copy>(method: Nystrom<K, O>, exponent: f64)
    where
        Nystrom<K, O>: Method<Orbit>,
        Splitting<K, O>: Method<Orbit>,
    {
        for units in [[1.0, 1.0], [3e8, 5e-3]] {
            // From errors of several tolerances, since those of single runs depend on where steps end.
            let mean = |of: &dyn Fn(f64) -> (f64, f64)| {
                let logarithms = (-2..=2).map(|k| of(10_f64.powf(-9.0 + 0.25 * f64::from(k))));
                logarithms.fold((0.0, 0.0), |sum, (error, steps)| (sum.0 + error.ln() / 5.0, sum.1 + steps.ln() / 5.0))
            };
            let own = mean(&|tolerance| run(method, tolerance, units));
            let halves = mean(&|tolerance| run(*method.table(), tolerance, units));
            // A step as a whole and its halves are three. Fewer forces for larger errors do not count.
            let ratio = (own.1 - halves.1).exp() / 3.0 * ((own.0 - halves.0) / exponent).exp();
            println!(
                "{}: {:.2} of the forces, {:.1} times the error",
                method.table().name(),
                ratio,
                (own.0 - halves.0).exp()
            );
            assert!(ratio < 1.0 / 1.3, "{}: {ratio:.2}", method.table().name());
            assert!(own.0 < halves.0, "{}", method.table().name());
        }
    }
    check(BlanesMoanSrkn6b, 4.0);
    check(BlanesMoanSrkn11b, 6.0);
    check(BlanesMoanSrkn14a, 6.0);
    check(BceRkn17_8, 8.0);
    check(BceRkn19_8, 8.0);
}

/// Where drifts turn momenta, or damp them, what kicks add is not a force of one frame: there halves are compared.
#[test]
fn where_momenta_do_not_stay_there_is_no_estimate() {
    fn has<S: PhaseSpace + Rates, M: Method<S>>(_: &S, method: M) -> bool {
        method.order_of_estimate().is_some()
    }
    #[contact_hamiltonian]
    fn damped(q: f64, p: f64, s: f64, c: f64) -> f64 {
        p * p / 2.0 - q.cos() + c * s
    }
    assert!(!has(&Damped { c: 0.1 }, BlanesMoanSrkn14a));
    assert!(!has(&Heavies::over::<f64>(), BlanesMoanSrkn14a));
    assert!(has(&Orbit { m: 1.0, mu: 1.0 }, BlanesMoanSrkn14a));
    assert!(!has(&Orbit { m: 1.0, mu: 1.0 }, *BlanesMoanSrkn14a.table()));
    assert!(has(&Orbit { m: 1.0, mu: 1.0 }, DOP853));
}

/// A method that counts how often coefficients are prepared.
#[derive(Clone, Copy, Debug)]
struct Counted<M>(M);

std::thread_local! {
    static PREPARED: Cell<u32> = const { Cell::new(0) };
}

impl<S: PhaseSpace, M: Method<S>> Method<S> for Counted<M> {
    passed_on!();

    fn name(&self) -> Name {
        self.0.name()
    }
    fn prepare(&self, system: &S, h: f64) -> Self::Prepared {
        PREPARED.set(PREPARED.get() + 1);
        self.0.prepare(system, h)
    }
    fn order_of_estimate(&self) -> Option<u32> {
        self.0.order_of_estimate()
    }
    fn estimated<C: Summation<S::Phase>, P: Probe<S, f64>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, S, f64, C, P>,
    ) -> Option<Result<Estimate<S, f64>, Refusal>> {
        M::estimated(prepared, memory, step)
    }
}

/// Of steps that nobody takes in halves nothing is prepared for halves.
#[test]
fn halves_are_prepared_where_they_are_taken() {
    fn count<M: Method<Orbit>>(method: M) -> u32 {
        PREPARED.set(0);
        let mut sim = Orbit { m: 1.3, mu: 1.0 }
            .adaptive(Counted(method), 0.1, State::new([0.4, 0.0], [0.0, 2.6]))
            .steps_between(1.0 / 64.0, 1.0 / 64.0);
        sim.advance(10).expect("steps");
        assert_eq!(sim.rejections(), 0);
        PREPARED.get()
    }
    // Where the run begins, and for the only length that steps have.
    assert_eq!([count(DOP853), count(BlanesMoanSrkn14a)], [2, 2]);
    assert_eq!(count(StormerVerlet), 4);
}

/// A sample within a step takes a step of the remaining length. This step prepares the method once.
#[test]
fn samples_within_a_step_prepare_once() {
    fn count<M: Method<Orbit>>(method: M) -> [u32; 3] {
        let start = || {
            let run = Orbit { m: 1.3, mu: 1.0 }.integrator(Counted(method), 0.1, State::new([0.4, 0.0], [0.0, 2.6]));
            PREPARED.set(0);
            run
        };
        let times: Vec<f64> = (0..8).map(|i| 0.04 * f64::from(i)).collect();
        let mut run = start();
        let every: Vec<_> = run.sampled_every(0.04).take(8).map(|state| state.expect("a state")).collect();
        let of_every = PREPARED.get();
        let mut run = start();
        let at: Vec<_> = run.sampled_at(times.clone()).map(|state| state.expect("a state")).collect();
        let of_at = PREPARED.get();
        assert_eq!(every, at);
        // The same states as from runs that end at these times, and keep their step size.
        for (state, t) in every.iter().zip(times) {
            let mut run = start();
            run.advance_to(t).expect("steps");
            run.end_at(t).expect("a step");
            assert_eq!((run.state(), run.step_size()), (*state, 0.1));
        }
        let run = start();
        run.at(0.04).expect("within a step");
        [of_every, of_at, PREPARED.get()]
    }
    // 0.04, 0.08, 0.12, 0.16, 0.24 and 0.28 lie within steps, 0 and 0.2 at their ends.
    assert_eq!(count(StormerVerlet), [6, 6, 1]);
    assert_eq!(count(Gauss::<2>), [6, 6, 1]);
}

/// A method that tells an order of its estimate, and gives none.
#[derive(Clone, Copy, Debug)]
struct Promising<M>(M);

impl<S: PhaseSpace, M: Method<S>> Method<S> for Promising<M> {
    passed_on!();

    fn name(&self) -> Name {
        self.0.name()
    }
    fn prepare(&self, system: &S, h: f64) -> Self::Prepared {
        self.0.prepare(system, h)
    }
    fn order_of_estimate(&self) -> Option<u32> {
        Some(self.0.claims().order)
    }
}

#[test]
fn a_method_that_gives_no_estimate_is_judged_by_halves() {
    fn end<M: Method<Orbit>>(method: M) -> ([f64; 2], u64) {
        let mut sim = Orbit { m: 1.3, mu: 1.0 }.adaptive(method, 1e-6, State::new([0.4, 0.0], [0.0, 2.6]));
        sim.advance(50).expect("steps");
        (sim.state().q, sim.rejections())
    }
    assert_eq!(end(Promising(StormerVerlet)), end(StormerVerlet));
}

/// The first kick of a step is the last one of the step before, and saved runs know it.
#[test]
fn saved_runs_go_on() {
    fn check<M: Method<Orbit>>(method: M) {
        let start = State::new([0.4, 0.0], [0.0, 2.6]);
        let run = || Orbit { m: 1.3, mu: 1.0 }.adaptive(method, 1e-8, start);
        let (mut sim, mut other) = (run(), run());
        sim.advance(40).expect("steps");
        other.advance(3).expect("steps");
        other.resume(&sim.saved()).expect("the same kind");
        for sim in [&mut sim, &mut other] {
            sim.advance_to(30.0).expect("steps");
        }
        assert_eq!(sim.state(), other.state());
        assert_eq!((sim.steps(), sim.rejections()), (other.steps(), other.rejections()));
    }
    check(BlanesMoanSrkn6b);
    check(BlanesMoanSrkn11b);
    check(BlanesMoanSrkn14a);
}
