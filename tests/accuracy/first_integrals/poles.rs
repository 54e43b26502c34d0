//! Poles of an integral, or of the energy of a plane, where the field has no pole. Beyond such a pole the function is another one.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A particle that is drawn to zero by the square of its distance, logarithmically.
#[hamiltonian(structure = canonical)]
fn drawn_to_zero(x: [f64; 2], c: f64) -> f64 {
    x[1] * x[1] / 2.0 - c * (x[0] * x[0]).ln()
}

/// S has a pole, and H none.
#[hamiltonian(structure = |_, _| c / x[0])]
fn singular_bracket(x: [f64; 2], c: f64) -> f64 {
    x[0].powi(3) + x[1] * x[1]
}

/// Steps of all sizes from all places to the right of the pole: how many went over it.
macro_rules! crossed {
    ($system:expr, $method:expr) => {{
        let (mut crossed, mut taken) = (0, 0);
        for (x, p, h) in starts() {
            let mut sim = $system.integrator($method, h, FlowState::new([x, p]));
            if sim.step().is_ok() {
                taken += 1;
                crossed += u32::from(sim.state().x[0] <= 0.0);
            }
        }
        assert!(taken > 300, "{taken} steps were taken");
        crossed
    }};
}

fn starts() -> impl Iterator<Item = (f64, f64, f64)> {
    let sizes = [3e-3, 0.03, 0.1, 0.3];
    (0..12).flat_map(move |i| {
        (-8..8).flat_map(move |j| sizes.map(|h| (0.07 + 0.09 * f64::from(i), 1.2 * f64::from(j) + 0.1, h)))
    })
}

#[test]
fn planes_that_are_solved_for_end_at_poles() {
    let (drawn, singular) = (DrawnToZero { c: 0.9 }, SingularBracket { c: 1.1 });
    assert_eq!(crossed!(drawn, PlanarSplitting), 0);
    assert_eq!(crossed!(drawn, PlanarDiscreteGradient), 0);
    assert_eq!(crossed!(drawn, PlanarItohAbePair), 0);
    assert_eq!(crossed!(drawn, Suzuki4.of(PlanarDiscreteGradient)), 0);
    assert_eq!(crossed!(singular, PlanarDiscreteGradient), 0);
    assert_eq!(crossed!(singular, PlanarItohAbe), 0);
    let mut long = drawn.integrator(PlanarSplitting, 0.212_875_898, FlowState::new([0.486_846_721, -9.761_296_905]));
    let refused = long.step();
    assert!(matches!(refused, Err(StepError { t: 0.0, failure: Failure::OutsideDomain { .. }, .. })), "{refused:?}");
}

/// If the equation of a plane has no solution, the error names the plane.
#[test]
fn a_plane_that_was_not_solved_is_named() {
    let mut unsolved = 0;
    for (x, p, h) in starts() {
        let mut sim = SingularBracket { c: 1.1 }.integrator(PlanarDiscreteGradient, h, FlowState::new([x, p]));
        match sim.step() {
            Err(StepError { failure: Failure::Unsolved { plane }, .. }) => {
                assert_eq!(plane, "x[0], x[1]");
                unsolved += 1;
            }
            Err(StepError { failure: Failure::Pole { .. } | Failure::NonFinite, .. }) => panic!("from {x}, {p} by {h}"),
            _ => {}
        }
    }
    assert!(unsolved > 0);
    let error = StepError::new(Failure::Unsolved { plane: "x[0], x[1]" }, 0.5, 0.1);
    assert_eq!(
        error.to_string(),
        "the step from t = 0.5 was not solved in the plane of x[0], x[1]; try a smaller step"
    );
}

/// x moves evenly; the arc of a tangent is another one behind its pole, by π.
#[vector_field(keeps(wound = x[0].tan().atan() - x[0] + x[1]))]
fn winding(x: [f64; 2], w: f64) -> [f64; 2] {
    [w, 0.0]
}

#[test]
fn projected_series_end_at_poles_of_what_they_are_projected_to() {
    let (system, start) = (Winding { w: 1.3 }, FlowState::new([0.3, 0.2]));
    let mut projected = system.taylor(Projection(Taylor::default(), Integrals), start);
    let refused = projected.advance_to(7.0);
    let reached = projected.state();
    assert!(refused.is_err_and(|error| error.is_shortest()), "{refused:?}");
    assert!((reached.x[0] - std::f64::consts::FRAC_PI_2).abs() < 1e-9 && reached.x[1] == 0.2, "{reached:?}");
    // Series alone have no pole there.
    let mut free = system.taylor(Taylor::default(), start);
    free.advance_to(7.0).unwrap_or_else(|error| panic!("{error}"));
    assert!((free.state().x[0] - 9.4).abs() < 1e-14 && free.state().x[1] == 0.2);
}
