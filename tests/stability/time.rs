//! Time of a run with every method, in `f64` and `f32`: exact to rounding, also if the step size changes; `until` ends at the requested time.

use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{DiscreteField, QuadraticField, SolvedByGauss};
use geoint_runtime::system::Autonomous;
use geoint_runtime::{ForceGradient, Method, Separable};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use geoint_tests::scalars::Scalar;

/// Visits all methods of the lists below.
pub(crate) fn every<S, R: Scalar, V: Visitor<S, R>>(visitor: &mut V)
where
    S: DiscreteField<R>
        + SolvedByGauss<R>
        + SolvedBy<DiscreteGradient, R>
        + Autonomous<R>
        + QuadraticField<R>
        + Separable<R>
        + ForceGradient<R>,
{
    methods::general(visitor);
    methods::discrete_gradient(visitor);
    methods::itoh_abe(visitor);
    methods::itoh_abe_one_way(visitor);
    methods::cubic(visitor);
    methods::projected(visitor);
    methods::relaxed(visitor);
    methods::separable(visitor);
    methods::nystrom(visitor);
    methods::force_gradient(visitor);
}

/// Visits one method of each kind of step. Tests use this list for scalars other than `f64`.
pub(crate) fn kinds<S, R: Scalar, V: Visitor<S, R>>(visitor: &mut V)
where
    S: DiscreteField<R>
        + SolvedByGauss<R>
        + SolvedBy<DiscreteGradient, R>
        + Autonomous<R>
        + QuadraticField<R>
        + Separable<R>
        + ForceGradient<R>,
{
    methods::kinds_of_general(visitor);
    methods::kinds_of_discrete_gradient(visitor);
    methods::kinds_of_itoh_abe(visitor);
    methods::itoh_abe_one_way(visitor);
    methods::kinds_of_cubic(visitor);
    methods::projected(visitor);
    methods::relaxed(visitor);
    methods::kinds_of_separable(visitor);
    methods::kinds_of_nystrom(visitor);
    methods::kinds_of_force_gradient(visitor);
}

/// Returns a scalar of at most 53 bits as `f64`.
pub(crate) fn number(x: impl Scalar) -> f64 {
    if x.any_below(0.0) { -x.magnitude() } else { x.magnitude() }
}

/// Compares `until(to)` with single steps. The last state does not pass `to`. A step that misses `to` by rounding alone counts as a step to `to`.
struct Ends {
    from: f64,
    h: f64,
    to: f64,
}

impl<R: Scalar> Visitor<HenonHeiles<R>, R> for Ends {
    fn visit<M: Method<HenonHeiles<R>, R> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let [from, h, to] = [self.from, self.h, self.to].map(R::from_f64);
        let name = format!("{name} from {} by {} to {}, ε = {:.0e}", self.from, self.h, self.to, R::epsilon());
        let start = State { t: from, ..HenonHeiles::initial(0.0) };
        let sim = HenonHeiles::system::<R>().integrator(method, h, start);
        let beyond = |t: R| number(t - to) * self.h.signum() > 0.0;

        let mut walked = sim.clone();
        let states: Vec<_> =
            walked.until(to).map(|state| state.unwrap_or_else(|error| panic!("{name}: {error}"))).collect();
        assert!(states.iter().all(|state| !beyond(state.t)), "{name}: beyond");
        assert_eq!(walked.steps(), states.len() as u64, "{name}");
        if let Some(last) = states.last() {
            assert_eq!(*last, walked.state(), "{name}");
        }

        let mut single = sim.clone();
        let mut before = single.clone();
        while !beyond(single.time()) && single.steps() <= walked.steps() {
            before = single.clone();
            single.step().unwrap();
        }
        let rounding = R::epsilon() * (2.0 * self.from.abs() + 2.0 * self.to.abs());
        let (steps, missed) = (before.steps(), number(single.time() - to).abs());
        if walked.steps() == steps + 1 {
            assert!(missed <= rounding && walked.time() == to, "{name}: {missed:.1e} beyond is more than rounding");
            before.step().unwrap();
        } else {
            assert_eq!(walked.steps(), steps, "{name}");
            let left = number(before.time() - to).abs();
            assert!(missed > 0.5 * rounding || left <= rounding, "{name}: a whole number of steps, less {missed:.1e}");
        }
        let (walked_to, stepped_to) = (walked.state(), before.state());
        assert!(walked_to.q == stepped_to.q && walked_to.p == stepped_to.p, "{name}: output changes the trajectory");

        let mut bulk = sim;
        bulk.advance_to(to).unwrap();
        assert_eq!(bulk.steps(), walked.steps(), "{name}: advance_to");
        assert!(number(bulk.time() - walked.time()).abs() <= rounding, "{name}: advance_to");
        // The run is at `to`, so `until` yields no further state.
        assert_eq!((walked.until(to).count(), walked.until(from).count()), (0, 0), "{name}: there");
    }
}

/// `until` ends at the last step that does not pass the requested time.
#[test]
fn until_ends_at_the_last_step_that_is_not_beyond() {
    let cases = [
        (0.0, 0.05, 1.0),
        (0.0, 0.05, 0.99),
        (0.0, 0.1, 0.3),
        (0.0, 0.1, 0.7),
        (0.3, 0.1, 0.6),
        (0.2, -0.1, -0.7),
        (-0.4, 0.07, 0.3),
        // In `f32`, neighbouring steps differ in a few units of the last place of the time.
        (1000.0, 0.001, 1000.02),
        (4000.0, 0.001, 4000.01),
        (-1000.0, -0.001, -1000.02),
    ];
    for (from, h, to) in cases {
        every::<HenonHeiles, f64, _>(&mut Ends { from, h, to });
        kinds::<HenonHeiles<f32>, f32, _>(&mut Ends { from, h, to });
    }
}

/// Long runs in `f32` take the exact number of steps.
#[test]
fn until_after_a_million_short_steps() {
    let system = ShortPendulum { m: 1.3, l: 0.7, g: 9.81 };
    let mut sim = system.integrator(StormerVerlet, 1.0 / 1024.0, State::new(0.1_f32, 0.0));
    for t in [1024.0_f32, 1500.0, 2048.0, 3000.0, 4096.0] {
        sim.advance_to(t).unwrap();
        assert_eq!((sim.steps(), sim.time()), (1024 * t as u64, t));
        assert_eq!(sim.until(t).count(), 0);
    }
    // The `f32` nearest to 0.001 is larger than 0.001.
    let h = 0.001_f32;
    let mut sim = system.integrator(StormerVerlet, h, State::new(0.1_f32, 0.0));
    for t in [1000.0_f32, 2000.0, 2500.0] {
        let last = sim.until(t).last().unwrap().unwrap();
        let exact = sim.steps() as f64 * f64::from(h);
        assert!(last.t <= t && (exact - f64::from(t)).abs() < f64::from(h), "{} {exact}", last.t);
    }
}

/// `Relaxation` scales each step to conserve the energy. No scaled step passes the requested time, and none is missing.
#[test]
fn scaled_steps_do_not_pass() {
    let system = Kepler { mass: 1.6, mu: 2.3 };
    for (h, to) in [(0.1, 100.0), (0.3, 100.0), (0.5, 37.0), (-0.3, -40.0)] {
        let mut sim = system.integrator(Relaxation(RK4), h, State::new([1.3, 0.0], [0.0, 2.3]));
        let mut all = sim.clone();
        let states: Vec<_> = sim.until(to).map(Result::unwrap).collect();
        assert!(states.iter().all(|state| (state.t - to) * h <= 0.0), "h = {h}");
        for state in &states {
            all.step().unwrap();
            assert_eq!(all.state(), *state, "output changes nothing");
        }
        let next = sim.clone().sampled(1).next().unwrap().unwrap();
        assert!((next.t - to) * h > 0.0, "h = {h}: {} is not beyond", next.t);
        assert_ne!(next.t, sim.time() + h, "steps are scaled");
        all.step().unwrap();
        assert_eq!(all.state(), next, "what was tried and not taken leaves nothing behind");
    }
}

/// Adaptive runs with scaled steps end exactly at the requested time. The run then continues in its direction.
#[test]
fn scaled_steps_that_adapt_do_not_pass() {
    let system = Kepler { mass: 1.6, mu: 2.3 };
    let run = || system.adaptive(Relaxation(RK4), 1e-6, State::new([1.3, 0.0], [0.0, 2.3]));
    for dt in [0.37, -0.37] {
        let mut sim = run();
        for n in 1..=100 {
            let (start, to) = (sim.time(), f64::from(n) * dt);
            let times: Vec<f64> = sim.until(to).map(|state| state.unwrap().t).collect();
            assert!(times.iter().all(|t| (t - start) * dt > 0.0 && (t - to) * dt <= 0.0), "to {to}: {times:?}");
            assert_eq!(times.last(), Some(&to));
            assert!(sim.step_size() * dt > 0.0 && sim.steps_backwards() == (dt < 0.0), "to {to}");
        }
        let now = sim.time();
        sim.step().unwrap();
        assert!((sim.time() - now) * dt > 0.0, "from {now} to {}", sim.time());
        // A search for an event that does not occur ends at the requested time, too.
        for n in 1..=100 {
            let (mut sim, to) = (run(), f64::from(n) * dt);
            assert!(sim.until_event(to, Direction::Any, |_| 1.0).unwrap().is_none());
            assert_eq!(sim.time(), to);
        }
    }
}

/// Asserts that `until` and `advance_to` refuse unusable times and step sizes, and that `until` accepts ±∞ as open ends.
struct Unusable;

impl<R: Scalar> Visitor<HenonHeiles<R>, R> for Unusable {
    fn visit<M: Method<HenonHeiles<R>, R> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let start = State { t: R::from_f64(0.2), ..HenonHeiles::initial(0.0) };
        let sim = |h: f64| HenonHeiles::system::<R>().integrator(method, R::from_f64(h), start);
        let refused = |outcome: Vec<Result<State<[R; 2]>, StepError>>| {
            assert!(
                matches!(outcome[..], [Err(StepError { failure: Failure::InvalidStepSize { .. }, .. })]),
                "{name}: {outcome:?}"
            );
        };
        refused(sim(0.1).until(R::from_f64(f64::NAN)).collect());
        for h in [0.0, f64::NAN, f64::INFINITY] {
            for t in [0.2, 1.0, -1.0] {
                refused(sim(h).until(R::from_f64(t)).collect());
            }
        }
        for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut sim = sim(0.1);
            assert!(
                matches!(
                    sim.advance_to(R::from_f64(t)),
                    Err(StepError { failure: Failure::InvalidStepSize { .. }, .. })
                ),
                "{name}: {t}"
            );
            assert_eq!(sim.state(), start, "{name}");
        }
        assert_eq!(sim(0.1).until(R::from_f64(f64::NEG_INFINITY)).count(), 0, "{name}");
        assert_eq!(sim(0.1).until(R::from_f64(f64::INFINITY)).take(3).filter(Result::is_ok).count(), 3, "{name}");
        assert_eq!(sim(-0.1).until(R::from_f64(f64::INFINITY)).count(), 0, "{name}");
        assert_eq!(sim(-0.1).until(R::from_f64(0.2)).count(), 0, "{name}");
    }
}

#[test]
fn unusable_times() {
    every::<HenonHeiles, f64, _>(&mut Unusable);
    kinds::<HenonHeiles<f32>, f32, _>(&mut Unusable);
}

/// An exact sum of scalars, as a multiple of 2^−UNIT.
#[derive(Clone, Copy)]
struct Exact(i128);

const UNIT: i32 = 110;

impl Exact {
    fn add(&mut self, x: f64) {
        let scaled = x.abs() * 2_f64.powi(UNIT - 60) * 2_f64.powi(60);
        assert!(scaled < 1e38 && scaled.fract() == 0.0, "{x} is a multiple of the unit");
        self.0 += if x < 0.0 { -(scaled as i128) } else { scaled as i128 };
    }

    /// Returns the sum minus a number.
    fn error(mut self, x: f64) -> f64 {
        self.add(-x);
        self.0 as f64 * 2_f64.powi(-60) * 2_f64.powi(60 - UNIT)
    }
}

/// The time is the exact sum of the step sizes, to one ε. The step size changes before every step, or before every seventh step.
#[test]
fn time_is_exact_through_changes_of_the_step_size() {
    fn check<R: Scalar>(system: HenonHeiles<R>) {
        for (t0, steps) in [(0.0, 1), (0.1, 7), (1e4, 1), (-300.0, 7)] {
            let t0 = R::from_f64(t0);
            let start = State { t: t0, ..HenonHeiles::initial(0.0) };
            let mut sim = system.integrator(StormerVerlet, R::from_f64(0.1), start);
            let mut exact = Exact(0);
            exact.add(number(t0));
            let mut worst = 0.0_f64;
            for i in 0..1000_u32 {
                // Step sizes of both signs with all digits.
                let h =
                    R::from_f64(if i % 5 == 4 { -0.3 } else { 1.0 } / (f64::from(i) + 1.3 * f64::from(i % 7) + 7.0));
                sim.set_step_size(h);
                sim.advance(steps).unwrap();
                (0..steps).for_each(|_| exact.add(number(h)));
                let t = number(sim.time());
                worst = worst.max(exact.error(t).abs() / (R::epsilon() * t.abs()));
            }
            println!("worst error of time: {worst:.2} ε");
            assert!(worst <= 1.0, "from {}: {worst:.1} ε", number(t0));
        }
    }
    check(HenonHeiles::system::<f64>());
    check(HenonHeiles::system::<f32>());
}

/// The time of an adaptive run is the sum of its steps to one ε. Control: a plain `f32` sum of the steps has an error above 10 ε.
#[test]
fn sums_of_time_do_not_drift() {
    let system = ShortPendulum { m: 1.3, l: 0.7, g: 9.81 };
    let mut sim = system.adaptive(StormerVerlet, 1e-3, State::new(0.1_f32, 0.0)).steps_between(0.01, 0.01);
    let (mut exact, mut control) = (0.0_f64, 0.0_f32);
    for _ in 0..20_000 {
        let h = sim.step_size() as f32;
        sim.step().unwrap();
        (exact, control) = (exact + f64::from(h), control + h);
    }
    let error = |t: f32| (f64::from(t) - exact).abs() / f64::from(f32::EPSILON) / exact;
    assert!(error(sim.time()) <= 1.0, "{} ε", error(sim.time()));
    assert!(error(control) > 10.0, "a running sum: {} ε", error(control));
}
