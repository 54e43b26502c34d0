//! Error estimates of Runge–Kutta–Nyström tables, and adaptive runs with these estimates.
//!
//! A table with an estimate computes two estimates of the error of a step: weighted sums of the forces that the step has evaluated. The error of the
//! step is taken as e₁²/√(e₁² + e₂²/100), where e₁ is the estimate of the higher order in h and e₂ the estimate of the lower order. A method without
//! an estimate compares a step with two half steps instead.
//!
//! The tests check the orders of both estimates, their cost, the systems that have no estimate, the fallback to half steps, and saved runs.

use geoint_runtime::method::catalogue::quadratic_kinetic;
use geoint_runtime::method::flows::Nystrom;
use geoint_runtime::method::{Claims, Failure, Name, Probe, Step, Unwatched, Visitor};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Plain, Point, Snapshot, Summation};
use geoint_runtime::system::{QuadraticKinetic, Rates, StateOf};
use geoint_runtime::{PhaseSpace, Real, Splitting};
use geoint_tests::problems::{DrivenPendulum, HenonHeiles};
use geoint_tests::scalars::Double;
use geoint_tests::scene::{Scene, point};
use geoint_tests::scenes::Heavies;

/// Returns the largest entry of each estimate after one step of length `h`: the estimate of the higher order, then of the lower order. Returns `None`
/// if the method has no estimate.
fn estimates<P: Scene, M: Method<P::Over<Double>, Double>>(method: M, h: f64) -> Option<[f64; 2]> {
    let (time, x) = P::start();
    let x: Vec<Double> = x.into_iter().map(Double::from).collect();
    let system = P::over::<Double>();
    let (t, z, s) = point::<StateOf<P::Over<Double>, Double>>(time.into(), &x).parts();
    let mut x: Point<_, Plain, _> = Point::with_action(z, s);
    let (prepared, mut memory) = (method.prepare(&system, h.into()), M::memory(&z));
    let step = Step { system: &system, t, end: t + Double::from(h), x: &mut x, probe: &mut Unwatched };
    let both = M::estimated(&prepared, &mut memory, step)?.expect("an explicit step succeeds");
    Some(both.map(|e| e.z.as_slice().iter().map(|x| x.magnitude()).fold(0.0, f64::max)))
}

/// The estimates of a table of order p scale with these powers of h. The construction of their weights fixes the powers.
///
/// | p | higher | lower |
/// |---|---|---|
/// | 4 | h⁵ | 0 |
/// | 6 | h⁶ | h⁵ |
/// | 8 | h⁷ | h⁵ |
///
/// For small h the combined error is about 10 e₁²/e₂, or e₁ if e₂ = 0. It is of the order hᵖ⁺¹ in all rows: the order of the error of a step.
#[test]
fn estimates_have_their_orders() {
    struct Orders<P>(Vec<(String, u32)>, std::marker::PhantomData<P>);
    impl<P: Scene> Visitor<P::Over<Double>, Double> for Orders<P> {
        fn visit<M: Method<P::Over<Double>, Double> + 'static>(&mut self, method: M) {
            let Some(order) = method.order_of_estimate() else { return };
            let name = method.name().to_string();
            // In much shorter steps the rounding of the weights to `f64` dominates.
            let [long, short] = [0.1, 0.05].map(|h| estimates::<P, M>(method, h).expect("an estimate"));
            let [higher, lower] = [0, 1].map(|i| (long[i] / short[i]).log2());
            let is = |observed: f64, power: u32| (observed - f64::from(power)).abs() < 0.25;
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

/// Kepler's problem for a body of mass m with the parameter μ of the centre. The mass makes momenta differ from velocities.
#[hamiltonian]
fn orbit(q: [f64; 2], p: [f64; 2], m: f64, mu: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - m * mu / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// Steps with an estimate are compared with steps in two halves, at the same tolerances. They lead to smaller errors, and need at most
/// 1/1.3 of the forces for the same error.
#[test]
fn steps_cost_less_than_halves() {
    /// Logarithms of the final error and of the number of steps, rejected steps included.
    #[derive(Clone, Copy, Default)]
    struct Cost {
        log_error: f64,
        log_steps: f64,
    }
    /// Runs ten revolutions of an ellipse with e = 0.6, semi-major axis `length` and period 2π `time`.
    fn run<M: Method<Orbit>>(method: M, tolerance: f64, [length, time]: [f64; 2]) -> Cost {
        let (m, mu) = (1.3, length.powi(3) / (time * time));
        let start = State::new([0.4 * length, 0.0], [0.0, 2.0 * m * length / time]);
        let mut sim = Orbit { m, mu }.adaptive(method, tolerance, start);
        sim.advance_to(20.0 * std::f64::consts::PI * time).expect("steps");
        let State { q, p, .. } = sim.state();
        let off = [q[0] / length - 0.4, q[1] / length, p[0] * time / (m * length), p[1] * time / (m * length) - 2.0];
        let error = off.into_iter().map(|x| x * x).sum::<f64>().sqrt();
        Cost { log_error: error.ln(), log_steps: ((sim.steps() + sim.rejections()) as f64).ln() }
    }
    /// Returns the mean over five tolerances near 10⁻⁹. The error of a single run depends on where its steps end.
    fn mean<M: Method<Orbit>>(method: M, units: [f64; 2]) -> Cost {
        (-2..=2).fold(Cost::default(), |sum, k| {
            let cost = run(method, 10_f64.powf(-9.0 + 0.25 * f64::from(k)), units);
            Cost { log_error: sum.log_error + cost.log_error / 5.0, log_steps: sum.log_steps + cost.log_steps / 5.0 }
        })
    }
    fn check<const K: usize, O: Copy>(method: Nystrom<K, O>, order: f64)
    where
        Nystrom<K, O>: Method<Orbit>,
        Splitting<K>: Method<Orbit>,
    {
        let name = method.table().name();
        // Units of length and time: the result must not depend on them.
        for units in [[1.0, 1.0], [3e8, 5e-3]] {
            let estimated = mean(method, units);
            // The plain table has no estimate, so the run compares a step with two half steps.
            let halved = mean(*method.table(), units);
            let log_error_ratio = estimated.log_error - halved.log_error;
            let step_ratio = (estimated.log_steps - halved.log_steps).exp();
            // `steps` counts a step with its two halves once, but it takes the forces of three steps. The error is proportional to
            // (number of forces)⁻ᵖ for the order p, so the exponential converts the ratio to equal errors.
            let force_ratio = step_ratio / 3.0 * (log_error_ratio / order).exp();
            println!("{name}: {force_ratio:.2} of the forces, {:.1} times the error", log_error_ratio.exp());
            assert!(force_ratio < 1.0 / 1.3, "{name}: {force_ratio:.2}");
            assert!(log_error_ratio < 0.0, "{name}");
        }
    }
    check(BlanesMoanSrkn6b, 4.0);
    check(BlanesMoanSrkn11b, 6.0);
    check(BlanesMoanSrkn14a, 6.0);
    check(BceRkn17_8, 8.0);
    check(BceRkn19_8, 8.0);
}

/// An estimate sums the increments of the momenta by the kicks of a step. This sum is meaningful only if drifts leave the momenta unchanged. Drifts
/// of contact systems with damping damp the momenta, and drifts of rigid bodies (`Heavies`) rotate them. Steps are then compared with half steps.
#[test]
fn no_estimate_if_drifts_change_momenta() {
    fn has_estimate<S: PhaseSpace + Rates, M: Method<S>>(_: &S, method: M) -> bool {
        method.order_of_estimate().is_some()
    }
    #[contact_hamiltonian]
    fn damped(q: f64, p: f64, s: f64, c: f64) -> f64 {
        p * p / 2.0 - q.cos() + c * s
    }
    assert!(!has_estimate(&Damped { c: 0.1 }, BlanesMoanSrkn14a));
    assert!(!has_estimate(&Heavies::over::<f64>(), BlanesMoanSrkn14a));
    assert!(has_estimate(&Orbit { m: 1.0, mu: 1.0 }, BlanesMoanSrkn14a));
    // The plain splitting table has no weights of an estimate.
    assert!(!has_estimate(&Orbit { m: 1.0, mu: 1.0 }, *BlanesMoanSrkn14a.table()));
    // An explicit Runge–Kutta method has an estimate of another kind.
    assert!(has_estimate(&Orbit { m: 1.0, mu: 1.0 }, DOP853));
}

/// A method that reports an order of its estimate, but computes no estimate: `estimated` is the default of the trait.
#[derive(Clone, Copy, Debug)]
struct Promising<M>(M);

impl<S: PhaseSpace, M: Method<S>> Method<S> for Promising<M> {
    delegate_step!();

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

/// A run compares steps with half steps if the method reports an order of its estimate, but computes no estimate.
#[test]
fn half_steps_replace_a_missing_estimate() {
    fn end<M: Method<Orbit>>(method: M) -> ([f64; 2], u64) {
        let mut sim = Orbit { m: 1.3, mu: 1.0 }.adaptive(method, 1e-6, State::new([0.4, 0.0], [0.0, 2.6]));
        sim.advance(50).expect("steps");
        (sim.state().q, sim.rejections())
    }
    assert_eq!(end(Promising(StormerVerlet)), end(StormerVerlet));
}

/// A resumed run ends at the same bits as the original run. A saved run holds the last kick, because the next step reuses its force if the table
/// begins and ends with a kick.
#[test]
fn saved_runs_continue_bit_for_bit() {
    fn check<M: Method<Orbit>>(method: M) {
        let start = State::new([0.4, 0.0], [0.0, 2.6]);
        let run = || Orbit { m: 1.3, mu: 1.0 }.adaptive(method, 1e-8, start);
        let (mut sim, mut other) = (run(), run());
        sim.advance(40).expect("steps");
        // `resume` replaces this progress.
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
