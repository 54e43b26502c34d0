//! Hostile input to every method. The result is an error that keeps the last good state, or a finite state. No method panics.

use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use geoint_tests::methods::Visitor;
use geoint_tests::scene::{Scene, flat, point};
use std::marker::PhantomData;

/// Extreme and invalid numbers.
const ODD: [f64; 9] =
    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -1e300, f64::MIN_POSITIVE, 5e-324, -0.0, 1e16];
/// Extreme and invalid step sizes.
const STEPS: [f64; 8] = [0.0, -0.0, f64::NAN, f64::INFINITY, 1e300, -1e300, 5e-324, 1e8];

/// Tests every method of a list on a scene.
struct Meets<P> {
    h: f64,
    scene: PhantomData<P>,
}

impl<P: Scene> Visitor<P::Over<f64>> for Meets<P> {
    fn visit<M: Method<P::Over<f64>> + 'static>(&mut self, method: M) {
        let (t, x) = P::start();
        let name = format!("{}, {}", P::NAME, method.name());
        let run = |h: f64, t: f64, x: &[f64]| Integrator::new(P::over::<f64>(), method, h, point(t, x));
        for place in 0..=x.len() {
            for odd in ODD {
                let (mut time, mut y) = (t, x.clone());
                *y.get_mut(place).unwrap_or(&mut time) = odd;
                holds(&format!("{name}: {place} is {odd}"), run(self.h, time, &y));
            }
        }
        for h in STEPS {
            holds(&format!("{name}: h = {h}"), run(h, t, &x));
            // A bad step size in the middle of a run. A good step size continues the run afterwards.
            let mut sim = run(self.h, t, &x);
            sim.advance(3).unwrap_or_else(|error| panic!("{name}: {error}"));
            sim.set_step_size(h);
            let sim = holds(&format!("{name}: h = {h} after three steps"), sim);
            if sim.steps() == 3 {
                let mut sim = sim;
                sim.set_step_size(0.5 * self.h);
                sim.step().unwrap_or_else(|error| panic!("{name}, after h = {h}: {error}"));
            }
        }
    }
}

/// Asserts that a step ends in finite numbers, or changes nothing.
fn holds<S: PhaseSpace, M: Method<S>>(name: &str, mut sim: Integrator<S, M>) -> Integrator<S, M> {
    let bits = |sim: &Integrator<S, M>| flat(&sim.state()).iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
    let (before, steps) = (bits(&sim), sim.steps());
    match sim.step() {
        Ok(()) => assert!(flat(&sim.state()).iter().all(|x| x.is_finite()), "{name}: {:?}", sim.state()),
        Err(_) => assert_eq!((bits(&sim), sim.steps()), (before, steps), "{name}"),
    }
    sim
}

geoint_tests::every_kind!(Meets);
