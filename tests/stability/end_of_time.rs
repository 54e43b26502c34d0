//! Runs near the largest finite time end with an error. No time becomes infinite.

use super::time::{every, kinds, number};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Failure, Method};
use geoint_tests::methods::Visitor;
use geoint_tests::problems::*;
use geoint_tests::scalars::Scalar;

/// Runs a system at rest from the time `from` with the step size `h` until the next time would overflow. At rest, only the time can cause an error.
/// Single steps, `advance` and `until` must return the same error.
struct EndOfTime {
    from: f64,
    h: f64,
}

/// Returns the state at rest in the minimum of the potential, at the time `t`.
fn at_rest<R: Scalar>(t: f64) -> State<[R; 2]> {
    let zeros = [R::from_f64(0.0); 2];
    State { t: R::from_f64(t), ..State::new(zeros, zeros) }
}

impl<R: Scalar> Visitor<HenonHeiles<R>, R> for EndOfTime {
    fn visit<M: Method<HenonHeiles<R>, R> + 'static>(&mut self, method: M) {
        let name = format!("{} from {:.1e} by {:.1e}", method.name(), self.from, self.h);
        let run = || HenonHeiles::system::<R>().integrator(method, R::from_f64(self.h), at_rest(self.from));
        let (mut singly, mut at_once, mut towards) = (run(), run(), run());
        let error = (0..2000).find_map(|_| singly.step().err()).unwrap_or_else(|| panic!("{name}: no end"));
        assert_eq!(at_once.advance(2000), Err(error), "{name}");
        let infinity = R::from_f64(f64::INFINITY * self.h.signum());
        assert_eq!(towards.until(infinity).last(), Some(Err(error)), "{name}");
        for sim in [singly, at_once, towards] {
            assert!(sim.time().magnitude() < f64::INFINITY, "{name}");
        }
    }
}

/// No step ends after the largest finite time, in `f64` and in `f32`, forwards and backwards.
#[test]
fn no_step_ends_after_the_largest_time() {
    let largest = f64::from(f32::MAX);
    for (part, step) in [(1.0, 0.01), (0.5, 1e-3), (-0.5, -1e-3)] {
        every::<HenonHeiles, f64, _>(&mut EndOfTime { from: part * f64::MAX, h: step * f64::MAX });
        kinds::<HenonHeiles<f32>, f32, _>(&mut EndOfTime { from: part * largest, h: step * largest });
    }
    // From half of the largest time, about 500 steps of a thousandth of the largest time fit.
    let mut sim = HenonHeiles::system().integrator(StormerVerlet, 1e-3 * f64::MAX, at_rest(0.5 * f64::MAX));
    let error = sim.advance(2000).unwrap_err();
    assert_eq!(error, StepError::new(Failure::NonFinite, sim.time(), 1e-3 * f64::MAX));
    assert!((499..=500).contains(&sim.steps()), "{} steps", sim.steps());
}

/// Adaptive steps of a system at rest become longer without limit. The run ends at a finite time, and repeats the error.
#[test]
fn steps_that_grow_without_end() {
    fn check<R: Scalar, M: Method<HenonHeiles<R>, R>>(method: M, from: f64) {
        let name = format!("{} from {from:.1e}, ε = {:.0e}", method.name(), R::epsilon());
        let mut sim = HenonHeiles::system::<R>().adaptive(method, 1e-8, at_rest(from));
        let error = sim.advance(10_000).expect_err(&name);
        let StepError { failure: Failure::NonFinite, t, .. } = error else { panic!("{name}: {error}") };
        assert_eq!(t, number(sim.time()), "{name}");
        assert!(t.is_finite() && sim.state() == at_rest(t), "{name}: {:?}", sim.state());
        assert_eq!(sim.step(), Err(error), "{name}");
    }
    for from in [0.0, f64::MAX] {
        check::<f64, _>(BlanesMoan4, from);
        check::<f64, _>(DOP853, from);
        check::<f64, _>(Relaxation(RK4), from);
    }
    for from in [0.0, f64::from(f32::MAX)] {
        check::<f32, _>(BlanesMoan4, from);
        check::<f32, _>(DOP853, from);
    }
}
