//! Number of times that a run prepares the coefficients of a method. Coefficients depend on the step size, so each new step size needs a preparation.

use geoint_runtime::method::{Claims, Estimate, Failure, Name, Probe, Step};
use geoint_runtime::prelude::*;
use geoint_runtime::space::Summation;
use geoint_runtime::{Method, PhaseSpace};
use geoint_tests::problems::Kepler;
use std::cell::Cell;

const SYSTEM: Kepler = Kepler { mass: 1.3, mu: 1.3 };

/// The pericentre of an ellipse with e = 0.6.
fn start() -> State<[f64; 2]> {
    State::new([0.4, 0.0], [0.0, 2.6])
}

/// A method that counts its preparations in `PREPARATIONS`.
#[derive(Clone, Copy, Debug)]
struct Counted<M>(M);

std::thread_local! {
    /// Number of preparations in this thread, and therefore in this test, since the last reset.
    static PREPARATIONS: Cell<u32> = const { Cell::new(0) };
}

impl<S: PhaseSpace, M: Method<S>> Method<S> for Counted<M> {
    delegate_step!();

    fn name(&self) -> Name {
        self.0.name()
    }
    fn prepare(&self, system: &S, h: f64) -> Self::Prepared {
        PREPARATIONS.set(PREPARATIONS.get() + 1);
        self.0.prepare(system, h)
    }
    fn order_of_estimate(&self) -> Option<u32> {
        self.0.order_of_estimate()
    }
    fn estimated<C: Summation<S::Phase>, P: Probe<S, f64>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, S, f64, C, P>,
    ) -> Option<Result<Estimate<S, f64>, Failure>> {
        M::estimated(prepared, memory, step)
    }
}

/// An adaptive run prepares half steps only if the method has no error estimate.
#[test]
fn half_steps_are_prepared_without_an_estimate_only() {
    fn count<M: Method<Kepler>>(method: M) -> u32 {
        PREPARATIONS.set(0);
        let mut sim = SYSTEM.adaptive(Counted(method), 0.1, start()).steps_between(1.0 / 64.0, 1.0 / 64.0);
        sim.advance(10).expect("steps");
        assert_eq!(sim.rejections(), 0);
        PREPARATIONS.get()
    }
    // One preparation at the start of the run, one for the only allowed step size.
    assert_eq!([count(DOP853), count(BlanesMoanSrkn14a)], [2, 2]);
    // Half steps need two preparations of their own.
    assert_eq!(count(StormerVerlet), 4);
}

/// A sample inside of a step takes one step of the remaining length, and so prepares the method once. A sample at the end of a step needs no
/// preparation.
#[test]
fn samples_within_a_step_prepare_once() {
    /// Returns the numbers of preparations by `sampled_every` and by `sampled_at` for eight samples, and by `at` for one sample.
    fn count<M: Method<Kepler>>(method: M) -> [u32; 3] {
        let new_run = || {
            let run = SYSTEM.integrator(Counted(method), 0.1, start());
            PREPARATIONS.set(0);
            run
        };
        let times: Vec<f64> = (0..8).map(|i| 0.04 * f64::from(i)).collect();
        let mut run = new_run();
        let every: Vec<_> = run.sampled_every(0.04).take(8).map(|state| state.expect("a state")).collect();
        let prepared_every = PREPARATIONS.get();
        let mut run = new_run();
        let at: Vec<_> = run.sampled_at(times.clone()).map(|state| state.expect("a state")).collect();
        let prepared_at = PREPARATIONS.get();
        assert_eq!(every, at);
        // `end_at` ends a run at a sample time with the same state, and keeps the step size of the run.
        for (state, t) in every.iter().zip(times) {
            let mut run = new_run();
            run.advance_to(t).expect("steps");
            run.end_at(t).expect("a step");
            assert_eq!((run.state(), run.step_size()), (*state, 0.1));
        }
        let mut run = new_run();
        run.step().expect("a step");
        PREPARATIONS.set(0);
        run.at(0.04).expect("within a step");
        [prepared_every, prepared_at, PREPARATIONS.get()]
    }
    // Steps end at multiples of 0.1. The samples at 0.04, 0.08, 0.12, 0.16, 0.24 and 0.28 are inside of steps, the samples at 0 and 0.2 at ends.
    assert_eq!(count(StormerVerlet), [6, 6, 1]);
    assert_eq!(count(Gauss::<2>), [6, 6, 1]);
}
