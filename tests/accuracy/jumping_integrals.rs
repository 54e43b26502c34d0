//! Integrals that jump where no solution leads across, and rounding does: steps are refused, and no correction takes the jump along.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// On the circle r = 1 the integral is 2 or 1, as rounding decides.
#[vector_field(keeps(assume(i = if x[0] * x[0] + x[1] * x[1] > 1.0 { x[0] * x[0] + x[1] * x[1] } else { 2.0 * (x[0] * x[0] + x[1] * x[1]) })))]
fn circle(x: [f64; 2]) -> [f64; 2] {
    [x[1], -x[0]]
}

/// The angle is not defined at x₀ = 0, where the integral jumps by π.
#[vector_field(keeps(assume(i = x[1] - (x[0].powi(2).atan2(x[0]) - x[0].atan()))))]
fn straight(x: [f64; 2]) -> [f64; 2] {
    [1.0, 0.0]
}

/// Returns the distance from the circle with radius `r` after 2000 steps, or after the last step before a refusal.
fn error<M: Method<Circle>>(method: M, h: f64, r: f64) -> (f64, Result<(), StepError>) {
    let mut sim = Circle.integrator(method, h, FlowState::new([r, 0.0]));
    let outcome = sim.advance(2000);
    let [x, y] = sim.state().x;
    ((x.hypot(y) - r).abs(), outcome)
}

#[test]
fn no_correction_leads_across_a_jump() {
    for h in [0.07, 0.3, 1.7] {
        let runs = [
            error(Projection(RK4, Integrals), h, 1.0),
            error(Projection(DOP853, Integrals), h, 1.0),
            error(Relaxation(RK4), h, 1.0),
            error(DiscreteGradient, h, 1.0),
            error(FourthOrder(DiscreteGradient), h, 1.0),
        ];
        assert!(runs.iter().all(|(error, _)| *error < 1e-12), "{h}: {runs:?}");
    }
    let jumps = error(Projection(RK4, Integrals), 1.7, 1.0).1.unwrap_err().to_string();
    assert!(jumps.contains("an integral jumps where a condition changes"), "{jumps}");
    // Control: beside the circle there is no jump.
    for r in [0.8, 1.2] {
        let (error, outcome) = error(Projection(RK4, Integrals), 0.3, r);
        assert!(error < 1e-12 && outcome.is_ok(), "{r}: {error:.1e} {outcome:?}");
    }
}

#[test]
fn angles_are_not_followed_through_where_they_are_not_defined() {
    fn outcome<M: Method<Straight>>(method: M, start: f64) -> (f64, Result<(), StepError>) {
        let mut sim = Straight.integrator(method, 0.1, FlowState::new([start, 0.3]));
        let outcome = sim.advance(20);
        ((sim.state().x[1] - 0.3).abs(), outcome)
    }
    for (error, refused) in [outcome(Projection(RK4, Integrals), -1.0), outcome(Relaxation(RK4), -1.03)] {
        assert!(
            error < 1e-14 && matches!(refused, Err(StepError { failure: Failure::Turned { .. }, .. })),
            "{error:.1e} {refused:?}"
        );
    }
    let mut sim = Straight.taylor(Projection(Taylor::default(), Integrals), FlowState::new([-1.0, 0.3]));
    let refused = sim.advance_to(2.0).unwrap_err();
    let (reason, error) = (refused.to_string(), (sim.state().x[1] - 0.3).abs());
    assert!(reason.contains("passes the point where it is not defined") && error < 1e-14, "{error:.1e} {reason}");
    let (error, passed) = outcome(Projection(RK4, Integrals), 0.1);
    assert!(error < 1e-14 && passed.is_ok(), "{error:.1e} {passed:?}");
}
