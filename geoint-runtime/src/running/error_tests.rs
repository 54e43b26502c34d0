//! Every failure has two texts, and errors are small.

use super::StepError;
use crate::solving::Failure;
use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;
use core::mem::size_of;

/// Returns the failure after this one. A new variant does not compile until it is in this list.
fn next(failure: Option<Failure>) -> Option<Failure> {
    let what = "q";
    Some(match failure {
        None => Failure::InvalidStepSize { h: 0.0 },
        Some(Failure::InvalidStepSize { .. }) => Failure::InvalidParameter { name: "k" },
        Some(Failure::InvalidParameter { .. }) => Failure::InvalidTolerance { tolerance: -1.0 },
        Some(Failure::InvalidTolerance { .. }) => Failure::InvalidBounds { shortest: 2.0, longest: 1.0 },
        Some(Failure::InvalidBounds { .. }) => Failure::InvalidOrder { order: 1 },
        Some(Failure::InvalidOrder { .. }) => Failure::NonFiniteState,
        Some(Failure::NonFiniteState) => Failure::NoMomentum,
        Some(Failure::NoMomentum) => Failure::NotNormalised { length: 2.0 },
        Some(Failure::NotNormalised { .. }) => Failure::OffConstraint { what },
        Some(Failure::OffConstraint { .. }) => Failure::NonFinite,
        Some(Failure::NonFinite) => Failure::OutsideDomain { what },
        Some(Failure::OutsideDomain { .. }) => Failure::Singular,
        Some(Failure::Singular) => Failure::SingularDirection,
        Some(Failure::SingularDirection) => Failure::DependentConstraints { what },
        Some(Failure::DependentConstraints { .. }) => Failure::Turned { what },
        Some(Failure::Turned { .. }) => Failure::Rounded,
        Some(Failure::Rounded) => Failure::LedAstray,
        Some(Failure::LedAstray) => Failure::OutOfRange,
        Some(Failure::OutOfRange) => Failure::Pole { piece: what },
        Some(Failure::Pole { .. }) => Failure::Unsolved { plane: what },
        Some(Failure::Unsolved { .. }) => Failure::NotConverged { iterations: 3, correction: 0.5 },
        Some(Failure::NotConverged { .. }) => Failure::Inaccurate { error: 2.0 },
        Some(Failure::Inaccurate { .. }) => Failure::Diverges,
        Some(Failure::Diverges) => Failure::NoRates,
        Some(Failure::NoRates) => Failure::Sliding,
        Some(Failure::Sliding) => Failure::TimePassed,
        Some(Failure::TimePassed) => Failure::NotInLastStep { from: 2.0, to: 2.5 },
        Some(Failure::NotInLastStep { .. }) => Failure::NoEvent,
        Some(Failure::NoEvent) => Failure::TooManySteps { steps: 7 },
        Some(Failure::TooManySteps { .. }) => return None,
    })
}

fn failures() -> impl Iterator<Item = Failure> {
    core::iter::successors(next(None), |failure| next(Some(*failure)))
}

/// A sentence names the time, unless it is about a setting. A clause does not.
#[test]
fn every_failure_has_a_clause_and_a_sentence() {
    assert_eq!(failures().count(), 29);
    for failure in failures() {
        let error = StepError::new(failure, 0.625, 0.25);
        let [clause, sentence] = [failure.to_string(), error.to_string()];
        assert!(clause.len() > 20 && !clause.contains("0.625"), "{failure:?}: {clause}");
        assert!(sentence.len() > 20, "{failure:?}: {sentence}");
        match error.time() {
            Some(t) => assert!(t == 0.625 && sentence.contains("0.625"), "{failure:?}: {sentence}"),
            None => assert_eq!(sentence, clause),
        }
        assert!(!error.is_shortest());
    }
}

#[test]
fn refused_shortest_steps_have_one_sentence() {
    for failure in failures() {
        let error = StepError::of_shortest(failure, 0.625, 0.25);
        assert_eq!(error.to_string(), format!("from t = 0.625 not even a step of 2.5e-1 can be taken: {failure}"));
        assert!(error.is_shortest() && error != StepError::new(failure, 0.625, 0.25));
    }
}

#[test]
fn settings_have_no_time() {
    let without_time: Vec<_> =
        failures().filter(|failure| StepError::new(*failure, 0.5, 0.1).time().is_none()).collect();
    assert_eq!(without_time, failures().take(5).collect::<Vec<_>>());
}

/// Steps return a `Result<(), Failure>`. It should fit into a few registers.
#[test]
fn errors_are_small() {
    assert_eq!([size_of::<Failure>(), size_of::<Result<(), Failure>>(), size_of::<StepError>()], [24, 24, 48]);
}
