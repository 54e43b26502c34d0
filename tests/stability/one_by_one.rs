//! Single steps, one call, and calls of any lengths give the same bits, with output between the steps or without. The tests cover every method of the
//! lists.

use crate::saved::bits;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::Summation;
use geoint_runtime::{Method, PhaseSpace};
use geoint_tests::methods::Visitor;
use geoint_tests::scene::{Scene, point};
use std::marker::PhantomData;

/// One way to advance a run to its end.
type Walk<'a, Run> = &'a dyn Fn(&mut Run) -> Result<(), StepError>;

/// Asserts that a run gives the same bits in four ways: at once, singly, in parts, and with output.
fn agree<S, M, C>(name: &str, steps: u64, run: impl Fn() -> Integrator<S, M, f64, C>)
where
    S: PhaseSpace,
    M: Method<S>,
    C: Summation<S::Phase>,
{
    // Runs follow one after the other, because some methods have a large memory.
    let ended = |how: &str, walk: Walk<'_, Integrator<S, M, f64, C>>| {
        let mut sim = run();
        walk(&mut sim).unwrap_or_else(|error| panic!("{name}, {how}: {error}"));
        assert_eq!(sim.steps(), steps, "{name}, {how}");
        bits(&sim.state())
    };
    let expected = ended("at once", &|sim| sim.advance(steps));
    let singly = ended("singly", &|sim| (0..steps).try_for_each(|_| sim.step()));
    let in_parts = ended("in parts", &|sim| {
        let parts = [1, 3, 0, 17, 1, 2].into_iter().cycle();
        parts.map_while(|part| (sim.steps() < steps).then(|| sim.advance(part.min(steps - sim.steps())))).collect()
    });
    let seen = ended("with output", &|sim| {
        sim.sampled(4).take(steps as usize / 4).try_for_each(|state| state.map(drop))?;
        sim.advance(steps % 4)
    });
    for (how, other) in [("singly", singly), ("in parts", in_parts), ("with output", seen)] {
        assert_eq!(other, expected, "{name}, {how}");
    }
}

/// Tests every method of a list on a scene.
struct OneByOne<P> {
    h: f64,
    scene: PhantomData<P>,
}

impl<P: Scene> Visitor<P::Over<f64>> for OneByOne<P> {
    fn visit<M: Method<P::Over<f64>> + 'static>(&mut self, method: M) {
        let (t, x) = P::start();
        let run = || Integrator::new(P::over::<f64>(), method, self.h, point(t, &x));
        let name = format!("{}, {}", P::NAME, method.name());
        agree(&name, 42, run);
        agree(&format!("{name}, compensated"), 42, || run().compensated());
    }
}

geoint_tests::every_method!(OneByOne);

/// A pendulum on a support that shakes, under a wind: kicks and drifts read the time.
#[hamiltonian]
fn shaken(q: f64, p: f64, t: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + 0.3 * p * (0.7 * t).cos() - m * (9.81 + (2.0 * t).sin()) * q.cos()
}

/// Springs that harden: a linear part with a rest.
#[hamiltonian(split = "p * p / (2.0 * m) + k * q * q / 2.0 | k * q.powi(4)")]
fn hardening(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0 + k * q.powi(4)
}

/// Friction that grows with time.
#[contact_hamiltonian]
fn dragged(q: f64, p: f64, s: f64, t: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - q.cos() + 0.1 * (1.0 + 0.1 * t) * s
}

/// A jump, so that every step is looked at.
#[hamiltonian]
fn ramp(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + if q > 0.0 { q } else { -2.0 * q }
}

/// Long runs: more steps than the interval after which a run stores its state. The systems depend on time, have linear pieces, or need a check of every
/// step.
#[test]
fn in_long_runs_of_every_form() {
    macro_rules! check {
        ($system:expr, $start:expr => $($method:expr),*) => { $(
            let run = || $system.integrator($method, 0.03, $start);
            agree(stringify!($method), 2501, run);
            agree(concat!(stringify!($method), ", compensated"), 2501, || run().compensated());
        )* };
    }
    check!(Shaken { m: 1.3 }, State { t: 0.4, ..State::new(0.8, 0.1) } => StormerVerlet, PositionVerlet, BlanesMoan4, ForestRuth4, SymplecticEuler);
    check!(Hardening { m: 1.3, k: 0.7 }, State::new(0.8, 0.1) => WisdomHolman, Saba4, Perturbation(SymplecticEuler), Perturbation(SymplecticEulerAdjoint), Chin4A);
    check!(Dragged { m: 1.3 }, ContactState { t: 0.4, ..ContactState::new(0.8, 0.1, 0.2) } => ContactSplitting, Suzuki4.of(ContactSplitting), StormerVerlet);
    check!(Ramp { m: 1.3 }, State::new(0.8, 0.1) => StormerVerlet, PositionVerlet);
}

/// Control: a run that restarts after every step has other last digits, and agrees to rounding.
#[test]
fn a_run_that_begins_anew_differs() {
    let run = || Shaken { m: 1.3 }.integrator(StormerVerlet, 0.03, State::new(0.8, 0.1));
    let (mut singly, mut anew) = (run(), run());
    for _ in 0..200 {
        singly.step().expect("a step");
        anew.step().expect("a step");
        anew.set_state(anew.state());
    }
    assert_ne!(bits(&singly.state()), bits(&anew.state()));
    let [a, b] = [singly.state(), anew.state()];
    assert!((a.q - b.q).abs() < 1e-13 && (a.p - b.p).abs() < 1e-12, "{a:?} {b:?}");
}
