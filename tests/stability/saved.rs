//! Saved runs that continue elsewhere have the same bits as uninterrupted runs, with every method of the lists.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::running::{ResumeError, Saved};
use geoint_runtime::space::Summation;
use geoint_runtime::system::StateOf;
use geoint_runtime::{Method, PhaseSpace};
use geoint_tests::methods::Visitor;
use geoint_tests::problems::*;
use geoint_tests::scene::{Scene, point};
use geoint_tests::scenes::*;
use std::marker::PhantomData;

/// Writes a saved run as a text, like a program that saves to a file, and reads it.
fn written(saved: &Saved) -> Saved {
    let text = serde_json::to_string(saved).expect("numbers and a name");
    let read = serde_json::from_str(&text).expect("what was written");
    assert_eq!(*saved, read);
    read
}

pub(crate) fn bits<T: geoint_runtime::space::Snapshot<Real = f64>>(state: &T) -> Vec<u64> {
    flat(state).iter().chain([&state.time()]).map(|x| x.to_bits()).collect()
}

/// Saves a run in its middle, resumes it in another run, and follows both. The other run started elsewhere with another step.
fn goes_on<S, M, C>(name: &str, mut sim: Integrator<S, M, f64, C>, mut other: Integrator<S, M, f64, C>)
where
    S: PhaseSpace,
    M: Method<S>,
    C: Summation<S::Phase>,
{
    sim.advance(13).and_then(|()| sim.step()).unwrap_or_else(|error| panic!("{name}: {error}"));
    other.resume(&written(&sim.saved())).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_eq!((bits(&sim.state()), sim.steps()), (bits(&other.state()), other.steps()), "{name}");
    for _ in 0..3 {
        sim.step().expect("a step");
        other.step().expect("a step");
        assert_eq!(bits(&sim.state()), bits(&other.state()), "{name}: a step");
    }
    sim.advance(20).expect("steps");
    other.advance(20).expect("steps");
    assert_eq!((bits(&sim.state()), sim.steps()), (bits(&other.state()), other.steps()), "{name}: steps");
    assert_eq!(sim.saved(), other.saved(), "{name}");
}

/// Tests every method of a list on a scene.
struct GoOn<P> {
    h: f64,
    scene: PhantomData<P>,
}

impl<P: Scene> Visitor<P::Over<f64>> for GoOn<P> {
    fn visit<M: Method<P::Over<f64>> + 'static>(&mut self, method: M) {
        let (t, x) = P::start();
        let run = |t: f64, h: f64| Integrator::new(P::over::<f64>(), method, h, point(t, &x));
        let name = format!("{}, {}", P::NAME, method.name());
        goes_on(&name, run(t, self.h), run(t + 1.0, 0.7 * self.h));
        goes_on(&name, run(t, self.h).compensated(), run(t, -self.h).compensated());
    }
}

geoint_tests::every_kind!(GoOn);

/// Three angles of an arm, solved for their velocities.
#[lagrangian]
fn arm(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
    let coupled = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos();
    m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + coupled) + q[0].cos() + q[2].cos()
}

#[test]
fn velocities() {
    let system = Arm { m: 0.7 };
    let [here, there] = [system.at([0.3, -0.2, 0.5], [0.1, 0.0, -0.4]), system.at([0.1, 0.4, 0.2], [0.0, 0.3, 0.0])];
    macro_rules! check {
        ($($method:expr),*) => { $(
            goes_on(stringify!($method), system.integrator($method, 0.05, here), system.integrator($method, 0.03, there));
        )* };
    }
    check!(ImplicitMidpoint, Gauss::<3>, DiscreteGradient, Suzuki4.of(DiscreteGradient));
}

#[test]
fn without_an_action() {
    let (t, x) = Charges::start();
    let run = |h: f64| Charges::over::<f64>().integrator(ContactSplitting, h, point(t, &x)).without_action();
    let (mut sim, mut other) = (run(0.05), run(0.07));
    sim.advance(10).expect("steps");
    other.resume(&written(&sim.saved())).expect("the same kind");
    sim.advance(10).expect("steps");
    other.advance(10).expect("steps");
    assert_eq!(bits(&sim.state())[..4], bits(&other.state())[..4]);
}

#[test]
fn single_precision() {
    let run = |h: f32| ShortPendulum { m: 1.3, l: 0.7, g: 9.81 }.integrator(DiscreteGradient, h, State::new(0.8, 0.1));
    let (mut sim, mut other) = (run(0.05), run(0.02));
    sim.advance(30).expect("steps");
    other.resume(&written(&sim.saved())).expect("the same kind");
    sim.advance(30).expect("steps");
    other.advance(30).expect("steps");
    assert_eq!(sim.state(), other.state());
    let long = Pendulum::system::<f64>().integrator(DiscreteGradient, 0.05, State::new(0.8, 0.1));
    assert_eq!(run(0.02).resume(&long.saved()), Err(ResumeError::Scalar(64)));
}

#[test]
fn steps_that_adapt() {
    fn check<M: Method<DoublePendulum>>(method: M) {
        let run =
            |tolerance: f64| DoublePendulum::system::<f64>().adaptive(method, tolerance, DoublePendulum::initial(0.2));
        let (mut sim, mut other) = (run(1e-8), run(1e-8));
        other.advance_to(1.0).expect("steps");
        sim.advance_to(3.0).expect("steps");
        other.resume(&written(&sim.saved())).expect("the same kind");
        sim.advance_to(5.0).expect("steps");
        other.advance_to(5.0).expect("steps");
        assert_eq!(bits(&sim.state()), bits(&other.state()), "{}", method.name());
        assert_eq!((sim.steps(), sim.rejections()), (other.steps(), other.rejections()));
        assert_eq!(sim.saved(), other.saved());
    }
    check(DOP853);
    check(DiscreteGradient);
    check(Gauss::<3>);
    check(Projection(RK4, Energy));
}

#[test]
fn taylor_series() {
    let run = || DoublePendulum::system::<f64>().taylor(Taylor::default(), DoublePendulum::initial(0.2));
    let (mut sim, mut other) = (run(), run());
    sim.advance(17).expect("steps");
    other.resume(&written(&sim.saved())).expect("the same kind");
    sim.advance(17).expect("steps");
    other.advance(17).expect("steps");
    assert_eq!((bits(&sim.state()), sim.steps()), (bits(&other.state()), other.steps()));
}

/// A root: what moves comes to its end, and is refused there.
#[hamiltonian]
fn down_to_the_edge(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.sqrt()
}

/// A method restarts after a refused step. The memory and the saved run are then the same for single steps and for one long call.
#[test]
fn at_a_step_that_is_refused() {
    fn check<M: Method<DownToTheEdge>>(method: M) {
        let run = || DownToTheEdge { m: 1.3 }.integrator(method, 0.07, State::new(1.0, 0.2));
        let (mut singly, mut at_once) = (run(), run());
        let refused = (0..10_000).find_map(|_| singly.step().err()).expect("the edge is reached");
        assert_eq!(at_once.advance(10_000), Err(refused), "{}", method.name());
        assert!(singly.steps() > 10, "{}", method.name());
        assert_eq!(singly.saved(), at_once.saved(), "{}", method.name());
    }
    check(ImplicitMidpoint);
    check(DiscreteGradient);
    check(FourthOrder(DiscreteGradient));
    check(Gauss::<3>);
    check(Suzuki4.of(DiscreteGradient));
    check(Projection(RK4, Energy));
    check(BlanesMoan4);
}

/// A state from the user that no step has examined is examined after a resume, whatever the resuming run did before. A state that a step produced need not
/// fulfil the conditions for states of users.
#[test]
fn a_state_that_no_step_has_seen() {
    macro_rules! check {
        ($($run:expr),* $(,)?) => { $(
            let run = $run;
            // The start is bad, or the user sets a bad state later.
            let mut given = run(State::new(1.0, 0.2));
            given.advance(3).expect("steps");
            given.set_state(State::new(-1.0, 0.0));
            for bad in [run(State::new(-1.0, 0.0)), given] {
                let mut other = run(State::new(1.0, 0.2));
                other.advance(5).expect("steps");
                other.set_state(State::new(1.1, 0.0));
                let mut fresh = run(State::new(1.0, 0.2));
                for other in [&mut other, &mut fresh] {
                    other.resume(&written(&bad.saved())).expect("the same kind");
                    let outcome = other.step();
                    assert!(matches!(outcome, Err(StepError { failure: Failure::OutsideDomain { .. }, .. })), "{outcome:?}: {}", stringify!($run));
                }
            }
        )* };
    }
    let system = DownToTheEdge { m: 1.3 };
    check!(
        |start| system.integrator(StormerVerlet, 0.01, start),
        |start| system.integrator(DiscreteGradient, 0.01, start),
        |start| system.adaptive(DOP853, 1e-8, start),
        |start| system.taylor(Taylor::default(), start),
    );
    // A step from a state off its constraint would continue from the projected state.
    let bob = Bob { m: 0.7, g: 9.81, l: 1.2 };
    let mut other = bob.integrator(Rattle, 0.01, State::new([1.2, 0.0], [0.0, 0.0]));
    other.advance(5).expect("steps");
    other.set_state(State::new([0.0, 1.2], [0.0, 0.0]));
    let off = bob.integrator(Rattle, 0.01, State::new([1.201, 0.0], [0.0, 0.0]));
    other.resume(&written(&off.saved())).expect("the same kind");
    let outcome = other.step();
    assert!(matches!(outcome, Err(StepError { failure: Failure::OffConstraint { .. }, .. })), "{outcome:?}");
    // At an event within a step, momenta are tangent to a constraint up to the rounding of positions divided by h.
    let run = || bob.integrator(DiscreteGradient, 0.01, State::new([1.2, 0.0], [0.0, 0.0]));
    let mut sim = run();
    for _ in 0..9 {
        sim.until_event(1e3, Direction::Any, |state| state.q[0]).expect("steps").expect("it swings");
        let mut other = run();
        other.resume(&written(&sim.saved())).expect("the same kind");
        let outcome = other.advance(20);
        assert!(outcome.is_ok(), "{outcome:?}");
    }
}

#[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - l * l])]
fn bob(q: [f64; 2], p: [f64; 2], m: f64, g: f64, l: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
}

/// A saved run of another kind is refused, and changes nothing.
#[test]
fn what_is_of_another_run_is_refused() {
    let start: StateOf<Pendulum, f64> = State::new(0.8, 0.1);
    let mut sim = Pendulum::system::<f64>().integrator(DiscreteGradient, 0.05, start);
    sim.advance(20).expect("steps");
    let good = sim.saved();
    let position = sim.state().q.to_bits();
    let mut refuses = |bad: Saved, expected: fn(&ResumeError) -> bool| {
        let error = sim.resume(&bad).expect_err("another kind");
        assert!(expected(&error) && !error.to_string().is_empty(), "{error:?}");
        assert_eq!(sim.saved(), good);
    };
    refuses(Saved { format: 6, ..good.clone() }, |error| *error == ResumeError::Format(6));
    refuses(Saved { method: "RK4".into(), ..good.clone() }, |error| matches!(error, ResumeError::Method(_)));
    let other = HenonHeiles::system::<f64>().integrator(DiscreteGradient, 0.05, HenonHeiles::initial(0.0)).saved();
    refuses(other, |error| matches!(error, ResumeError::Words { .. }));
    for n in 0..good.words.len() {
        let words = good.words[..n].to_vec();
        refuses(Saved { words, ..good.clone() }, |error| matches!(error, ResumeError::Words { .. }));
    }
    let place = good.words.iter().position(|word| *word == position).expect("a word is the position");
    let mut words = good.words.clone();
    words[place] = f64::NAN.to_bits();
    refuses(Saved { words, ..good.clone() }, |error| *error == ResumeError::NonFinite);
}

/// Saved runs with one arbitrary word, in every kind of run. The result is an error, or a run whose next steps return errors or finite numbers at a finite
/// time. Nothing panics, no loop is endless, and no invalid number is accepted.
#[test]
fn words_that_are_anything() {
    let odd = [0, 1, u64::MAX, u64::MAX / 2, 1 << 63].into_iter();
    let odd = odd.chain([f64::NAN, f64::INFINITY, -f64::INFINITY, f64::MAX, f64::MIN_POSITIVE].map(f64::to_bits));
    let is_number = |word: u64| f64::from_bits(word).is_finite();
    macro_rules! check {
        ($($run:expr),* $(,)?) => { $(
            let start = $run;
            let mut sim = start.clone();
            sim.advance(19).expect("steps");
            let before = sim.time();
            sim.step().expect("a step");
            // An exact end time, set by the user.
            sim.step_towards(sim.time() + (sim.time() - before)).expect("a step");
            let good = sim.saved();
            for (place, word) in (0..good.words.len()).flat_map(|place| odd.clone().map(move |word| (place, word))) {
                let mut words = good.words.clone();
                words[place] = word;
                let name = format!("{}: word {place} is {word:x}", stringify!($run));
                let mut other = start.clone();
                if other.resume(&Saved { words, ..good.clone() }).is_err() {
                    assert_eq!(other.saved(), start.saved(), "{name}");
                    continue;
                }
                assert!(is_number(word) || other.saved().words[place] != word, "{name}");
                let outcome = other.advance(3);
                let state = other.state();
                assert!(state.t.is_finite() && flat(&state).iter().all(|x| x.is_finite()), "{name}: {outcome:?}, {state:?}");
            }
        )* };
    }
    let (system, start) = (Pendulum::system::<f64>(), Pendulum::initial(0.0));
    check!(
        system.integrator(DiscreteGradient, 0.05, start),
        system.integrator(BlanesMoan4, 0.05, start).compensated(),
        system.integrator(Relaxation(RK4), 0.05, start),
        system.integrator(Projection(Gauss::<2>, Energy), 0.05, start),
        system.adaptive(DOP853, 1e-8, start),
        system.adaptive(DiscreteGradient, 1e-6, start),
        system.adaptive(Relaxation(RK4), 1e-6, start),
        system.taylor(Taylor::default(), start),
        system.taylor(TaylorFixed::<8> { h: 0.05 }, start),
        system.taylor(Projection(Taylor { tolerance: 1e-8 }, Energy), start),
    );
}
