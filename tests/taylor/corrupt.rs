//! Saved runs may be corrupt. A state that no step has produced is examined, whatever the saved number of steps is.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::running::Saved;

/// Not defined for q ≤ 0, where a drift alone comes to no harm.
#[hamiltonian]
fn logarithm(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - q.ln()
}

const SYSTEM: Logarithm = Logarithm { m: 1.3 };

/// Returns the saved run with another position and, on request, with another number of steps.
fn corrupt(saved: &Saved, [from, to]: [f64; 2], taken: Option<[u64; 2]>) -> Saved {
    let mut words = saved.words.clone();
    *words.iter_mut().find(|word| **word == from.to_bits()).expect("the position") = to.to_bits();
    if let Some([from, to]) = taken {
        *words.iter_mut().find(|word| **word == from).expect("the number of steps") = to;
    }
    Saved { words, ..saved.clone() }
}

macro_rules! is_examined {
    ($run:expr) => {{
        let mut sim = $run;
        for _ in 0..5 {
            sim.step().unwrap();
        }
        let (saved, q) = (sim.saved(), sim.state().q);
        for taken in [None, Some([5, 6]), Some([5, u64::MAX])] {
            let mut other = $run;
            other.resume(&corrupt(&saved, [q, -0.01], taken)).expect("numbers as there have to be");
            let before = other.state();
            for _ in 0..2 {
                let error = other.step().unwrap_err();
                assert!(matches!(error, StepError { failure: Failure::OutsideDomain { .. }, .. }), "{error}");
                assert_eq!((other.state(), before.q), (before, -0.01));
            }
            assert!(other.advance_to(before.t + 1.0).is_err() && other.state() == before);
            other.set_state(State::new(1.0, 0.5));
            other.step().unwrap();
        }
        for q_is in [f64::NAN, f64::INFINITY] {
            assert!($run.resume(&corrupt(&saved, [q, q_is], None)).is_err());
        }
    }};
}

#[test]
fn a_state_outside_of_the_domain() {
    let start = State::new(1.0, 0.5);
    is_examined!(SYSTEM.integrator(StormerVerlet, 0.05, start));
    is_examined!(SYSTEM.integrator(PositionVerlet, 0.05, start));
    is_examined!(SYSTEM.integrator(Gauss::<2>, 0.05, start).compensated());
    is_examined!(SYSTEM.integrator(Projection(RK4, Energy), 0.05, start));
    is_examined!(SYSTEM.adaptive(DOP853, 1e-9, start));
    is_examined!(SYSTEM.taylor(Taylor::default(), start));
    is_examined!(SYSTEM.taylor(TaylorFixed::<8> { h: 0.05 }, start));
    is_examined!(SYSTEM.taylor(Projection(Taylor::default(), Energy), start));
}

/// A run that resumes the state of another run keeps its own tolerance.
#[test]
fn a_tolerance_that_is_none() {
    let start = State::new(1.0, 0.5);
    let mut sim = SYSTEM.taylor(Taylor::default(), start);
    sim.advance(3).unwrap();
    for tolerance in [0.0, -1e-9, f64::NAN, 1.0] {
        let mut other = SYSTEM.taylor(Taylor { tolerance }, start);
        other.resume(&sim.saved()).expect("the same kind");
        assert!(matches!(other.step(), Err(StepError { failure: Failure::InvalidTolerance { .. }, .. })));
        assert_eq!(other.state(), sim.state());
    }
}
