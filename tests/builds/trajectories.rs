//! Walking along a trajectory: counts, last times, errors that end it, and the bare loop against single steps.

use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{DiscreteField, SolvedByGauss};
use geoint_runtime::system::Conservative;
use geoint_runtime::{Method, Separable};
use geoint_tests::measure::distance;
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;

/// `advance(n)` merges flows of neighbouring steps, which changes rounding and nothing else.
struct Bulk;

impl Visitor<HenonHeiles, f64> for Bulk {
    fn visit<M: Method<HenonHeiles, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let system = HenonHeiles::system::<f64>();
        for n in [1, 2, 3, 50] {
            let mut bulk = system.integrator(method, 0.05, HenonHeiles::initial(0.0));
            let mut single = bulk.clone();
            bulk.advance(n).unwrap();
            (0..n).for_each(|_| single.step().unwrap());
            let gap = distance(&flat(&bulk.state()), &flat(&single.state()));
            assert!(gap <= 2e-14, "{name}: {n} steps, {gap:.1e}");
            assert_eq!((bulk.time(), bulk.steps()), (single.time(), single.steps()));
        }
    }
}

/// The same where flows depend on time: a merged flow must happen at one time, not at two.
impl Visitor<Breathing, f64> for Bulk {
    fn visit<M: Method<Breathing, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let system = Breathing::system::<f64>();
        let mut bulk = system.integrator(method, 0.05, Breathing::initial(0.4));
        let mut single = bulk.clone();
        bulk.advance(50).unwrap();
        (0..50).for_each(|_| single.step().unwrap());
        let gap = distance(&flat(&bulk.state()), &flat(&single.state()));
        assert!(gap <= 5e-14, "{name}: {gap:.1e}");
    }
}

#[test]
fn advance_is_so_many_steps() {
    fn lists<S>(bulk: &mut Bulk)
    where
        Bulk: Visitor<S, f64>,
        S: DiscreteField + SolvedByGauss + SolvedBy<DiscreteGradient> + Conservative + Separable,
    {
        methods::general::<S, f64>(bulk);
        methods::discrete_gradient::<S, f64>(bulk);
        methods::separable::<S, f64>(bulk);
    }
    lists::<HenonHeiles>(&mut Bulk);
    lists::<Breathing>(&mut Bulk);
    methods::projected::<HenonHeiles, f64>(&mut Bulk);
    methods::relaxed::<HenonHeiles, f64>(&mut Bulk);
    methods::nystrom::<HenonHeiles, f64>(&mut Bulk);
    methods::force_gradient::<HenonHeiles, f64>(&mut Bulk);
}

/// Longer than the stretch after which the driver looks whether numbers are still finite.
#[test]
fn advance_beyond_one_look() {
    let mut bulk = Pendulum::system::<f64>().integrator(StormerVerlet, 0.001, Pendulum::initial(0.0));
    let mut single = bulk.clone();
    bulk.advance(2500).unwrap();
    (0..2500).for_each(|_| single.step().unwrap());
    assert!(distance(&flat(&bulk.state()), &flat(&single.state())) < 1e-12);
    assert_eq!(bulk.steps(), 2500);
}

fn pendulum(h: f64, t: f64) -> geoint_runtime::Integrator<Pendulum, geoint_runtime::Splitting<1>> {
    Pendulum::system::<f64>().integrator(StormerVerlet, h, Pendulum::initial(t))
}

fn times(samples: impl Iterator<Item = Result<State<f64>, StepError>>) -> Vec<f64> {
    samples.map(|state| state.unwrap().t).collect()
}

#[test]
fn until_ends_at_the_last_step_not_after() {
    assert_eq!(times(pendulum(0.1, 0.0).until(1.0)), (1..=10).map(|n| f64::from(n) * 0.1).collect::<Vec<_>>());
    assert_eq!(times(pendulum(0.1, 0.0).until(0.99)).len(), 9);
    assert_eq!(times(pendulum(0.1, 0.0).until(1.04)).len(), 10);
    assert_eq!(times(pendulum(0.25, -1.0).until(1.0)).last(), Some(&1.0));
    assert_eq!(times(pendulum(0.1, 2.0).until(1.0)).len(), 0, "the past is no way ahead");
    assert_eq!(times(pendulum(0.1, 2.0).until(2.0)).len(), 0);
}

#[test]
fn until_goes_backwards_with_a_negative_step() {
    assert_eq!(times(pendulum(-0.25, 1.0).until(-0.4)), [0.75, 0.5, 0.25, 0.0, -0.25]);
    assert_eq!(times(pendulum(-0.1, 0.0).until(1.0)).len(), 0);
}

/// Every whole number of steps, from every step on: no time is skipped because a quotient rounds down.
#[test]
fn until_reaches_every_step() {
    for h in [0.1, 0.01, 0.3, 1.0 / 3.0, 0.7] {
        for n in 1..1000_u64 {
            let t = n as f64 * h;
            assert_eq!(pendulum(h, 0.0).until(t).count() as u64, n, "h = {h}, t = {t}");
            if n > 200 {
                break;
            }
        }
        let mut sim = pendulum(h, 0.0);
        for n in 1..=3000_u64 {
            let count = sim.until(n as f64 * h).count();
            assert_eq!(count, 1, "h = {h}: from step {} to the time of step {n}", n - 1);
        }
    }
}

/// The same in a shorter type.
#[test]
fn until_reaches_every_step_of_short_numbers() {
    let system = ShortPendulum { m: 1.3, l: 0.7, g: 9.81 };
    for h in [0.1_f32, 0.01, 0.3, 1.0 / 3.0, 0.7] {
        for n in 1..=300_u64 {
            let mut sim = system.integrator(StormerVerlet, h, State::new(0.1, 0.0));
            let t = (n as f64 * f64::from(h)) as f32;
            assert_eq!(sim.until(t).count() as u64, n, "h = {h}, t = {t}");
        }
    }
}

#[test]
fn until_with_unusable_input() {
    for h in [0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut sim = pendulum(h, 0.0);
        let outcome: Vec<_> = sim.until(1.0).collect();
        assert!(
            matches!(outcome[..], [Err(StepError { failure: Failure::InvalidStepSize { .. }, .. })]),
            "h = {h}: {outcome:?}"
        );
    }
    // A step of zero is unusable whichever way time should go.
    let outcome: Vec<_> = pendulum(0.0, 2.0).until(1.0).collect();
    assert!(matches!(outcome[..], [Err(StepError { failure: Failure::InvalidStepSize { .. }, .. })]), "{outcome:?}");
}

#[test]
fn samples_are_strided_and_agree_with_advance() {
    let mut sim = pendulum(0.05, 0.3);
    let samples: Vec<_> = sim.sampled(7).take(4).map(Result::unwrap).collect();
    assert_eq!(sim.steps(), 28);
    let mut other = pendulum(0.05, 0.3);
    for sample in samples {
        other.advance(7).unwrap();
        assert_eq!(sample, other.state());
    }
    assert_eq!(times(pendulum(0.5, 0.0).sampled(0).take(2)), [0.5, 1.0], "a stride of 0 counts as 1");
    let mut untouched = pendulum(0.5, 0.0);
    let _ = untouched.sampled(3);
    assert_eq!(untouched.steps(), 0, "an iterator does nothing until it is asked");
}

/// An error is the last item, and the integrator is at the last good state.
#[test]
fn an_error_ends_the_walk() {
    #[hamiltonian]
    fn rim(q: f64, p: f64, m: f64) -> f64 {
        p * p / (2.0 * m) - (1.0 - q * q).sqrt()
    }
    let mut sim = Rim { m: 1.4 }.integrator(StormerVerlet, 0.1, State::new(0.2, 2.0));
    let outcome: Vec<_> = sim.until(100.0).collect();
    let (last, good) = outcome.split_last().unwrap();
    assert!(!good.is_empty() && good.iter().all(Result::is_ok));
    assert!(last.is_err());
    assert_eq!(sim.steps(), good.len() as u64);
    assert_eq!(Ok(sim.state()), *good.last().unwrap());
    let mut samples = sim.sampled(1);
    assert!(samples.next().unwrap().is_err());
    assert!(samples.next().is_none() && samples.next().is_none());
}
