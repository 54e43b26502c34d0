//! Every kind of run is saved in its middle and resumed in another run, bit for bit; the control is a run that was not saved at the same place.

use crate::systems::*;
use geoint_runtime::Trajectory;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::running::{ResumeError, Saved};

/// Saves `run` after some steps, resumes `other` from a text of it, and follows both.
fn goes_on<T: Resumable + Trajectory>(mut run: T, mut other: T)
where
    T::State: PartialEq + std::fmt::Debug,
{
    run.advance(17).expect("the problem is regular");
    other.advance(5).expect("the problem is regular");
    assert_ne!(run.state(), other.state(), "the control: the runs differ before");
    let text = serde_json::to_string(&run.saved()).expect("numbers and a name");
    let saved: Saved = serde_json::from_str(&text).expect("the text of a saved run");
    other.resume(&saved).expect("a run of the same kind");
    for steps in [1, 1, 20] {
        run.advance(steps).expect("the problem is regular");
        other.advance(steps).expect("the problem is regular");
        assert_eq!((run.state(), run.steps()), (other.state(), other.steps()));
    }
    assert_eq!(run.saved(), other.saved());
}

#[test]
fn every_kind_of_run_is_resumed() {
    let start = State::new([0.3, -0.2], [0.2, 0.4]);
    macro_rules! each {
        ($($run:expr;)*) => { $( goes_on($run, $run); )* };
    }
    each! {
        HENON_HEILES.integrator(StormerVerlet, 0.1, start);
        HENON_HEILES.integrator(BlanesMoan4, 0.1, start).compensated();
        HENON_HEILES.integrator(DiscreteGradient, 0.1, start);
        HENON_HEILES.integrator(Gauss::<3>, 0.1, start);
        HENON_HEILES.integrator(WisdomHolmanProcessed, 0.1, start);
        HENON_HEILES.integrator(Projection(RK4, Energy), 0.1, start);
        HENON_HEILES.adaptive(DOP853, 1e-9, start);
        HENON_HEILES.adaptive(DiscreteGradient, 1e-6, start);
        HENON_HEILES.taylor(Taylor::default(), start);
        HENON_HEILES.taylor(TaylorFixed::<8> { h: 0.1 }, start);
        DAMPED.integrator(ContactSplitting, 0.1, ContactState::new(1.1, 0.6, 0.3));
        ON_A_SPHERE.integrator(Rattle, 0.02, State::new([1.0, -1.0, -0.5], [0.7, 0.4, 0.6]));
        FREE_BODY.integrator(PoissonSplitting, 0.1, FlowState::new([0.6, 1.1, -0.5]));
    }
}

/// A run of another method, scalar or system is refused, and changes nothing.
#[test]
fn runs_of_another_kind_are_refused() {
    let start = State::new([0.3, -0.2], [0.2, 0.4]);
    let mut run = HENON_HEILES.integrator(DiscreteGradient, 0.1, start);
    let other = HENON_HEILES.integrator(RK4, 0.1, start).saved();
    assert!(matches!(run.resume(&other), Err(ResumeError::Method(_))));
    let other = PENDULUM.integrator(DiscreteGradient, 0.1, State::new(0.3, 0.2)).saved();
    assert!(matches!(run.resume(&other), Err(ResumeError::Words { .. })));
    let single = HenonHeiles::<f32> { m: [1.3, 0.8], a: 0.9 };
    let other = single.integrator(DiscreteGradient, 0.1, State::new([0.3, -0.2], [0.2, 0.4])).saved();
    assert_eq!(run.resume(&other), Err(ResumeError::Scalar(32)));
    assert_eq!(run.state(), start);
}
