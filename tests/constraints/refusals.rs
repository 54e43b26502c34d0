//! Refused: states off a constraint, constraints that depend on each other, and steps without an end.

use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

#[test]
fn a_state_off_a_constraint_is_named() -> Result<(), StepError> {
    let start = released();
    let longer = State { q: [start.q[0], start.q[1], start.q[2] + 1e-9, start.q[3]], ..start };
    let away = State { p: [0.0, 1e-9, 0.0, 0.0], ..start };
    macro_rules! refuses {
        ($($method:expr),*) => { $(
            for (state, expected) in [
                (longer, "((q[0] - q[2])² + (q[1] - q[3])² - l[1]²)/2"),
                (away, "the rate of (q[0]² + q[1]² - l[0]²)/2"),
            ] {
                let mut sim = DOUBLE.integrator($method, 0.01, state);
                for outcome in [sim.step(), sim.advance(10)] {
                    assert_eq!(outcome, Err(StepError::new(Failure::OffConstraint { what: expected }, 0.0, 0.01)));
                    assert_eq!(sim.state(), state);
                }
                let text = sim.step().expect_err("off").to_string();
                assert!(text.contains("state_on_constraint"), "{text}");
                // The nearest state on the constraint.
                let near = DOUBLE.state_on_constraint(&state)?;
                assert!(far(&near, &start) < 2e-9, "{near:?}");
                DOUBLE.integrator($method, 0.01, near).step()?;
            }
        )* };
    }
    refuses!(Rattle, DiscreteGradient, Suzuki4.of(Rattle));
    // From far.
    let near = DOUBLE.state_on_constraint(&State::new([0.3, -0.7, 0.9, -1.9], [0.4, 0.1, -0.2, 0.5]))?;
    DOUBLE.integrator(Rattle, 0.01, near).step()?;
    // Refused: a state without a direction that leads to the constraint, and a state of NaN.
    assert!(DOUBLE.state_on_constraint(&State::new([0.0; 4], [0.0; 4])).is_err());
    assert!(DOUBLE.state_on_constraint(&State::new([f64::NAN; 4], [0.0; 4])).is_err());
    Ok(())
}

/// At the tip of a cone a constraint has no gradient: all ways lead on from there.
#[test]
fn a_tip_is_on_a_cone() {
    #[lagrangian(constraint = [(q[0] * q[0] + q[1] * q[1]).sqrt() - q[2]])]
    fn cone(q: [f64; 3], v: [f64; 3]) -> f64 {
        0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - q[2]
    }
    let tip = Cone.at([0.0; 3], [0.0; 3]);
    let expected = |h| StepError::new(Failure::DependentConstraints { what: "√(q[0]² + q[1]²) - q[2]" }, 0.0, h);
    assert_eq!(Cone.integrator(Rattle, 0.1, tip).step(), Err(expected(0.1)));
    assert_eq!(Cone.integrator(DiscreteGradient, 0.1, tip).step(), Err(expected(0.1)));
    assert_eq!(Cone.state_on_constraint(&tip), Err(expected(0.0)));
}

/// A state that rounding has moved is on the constraint, wherever the origin is.
#[test]
fn rounding_is_no_departure() -> Result<(), StepError> {
    #[hamiltonian(constraint = [((q[0] - x).powi(2) + q[1] * q[1] - l * l) / 2.0])]
    fn distant(q: [f64; 2], p: [f64; 2], m: f64, x: f64, l: f64, g: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
    }
    for x in [0.1, 1e3, 1e6] {
        let system = Distant { m: 0.7, x, l: 1.3, g: 9.81 };
        for k in 0..100 {
            let (sin, cos) = (0.03 * f64::from(k)).sin_cos();
            let start = State::new([x + 1.3 * sin, -1.3 * cos], [0.5 * cos, 0.5 * sin]);
            system.integrator(Rattle, 1e-3, start).step()?;
            system.integrator(DiscreteGradient, 1e-3, start).step()?;
        }
    }
    Ok(())
}

/// All bars of a parallelogram lie in one line. The parallelogram may turn into another linkage there, and the constraints depend on each other.
const PARALLELOGRAM: FourBar = FourBar { m: [0.7, 1.1], rocker: 0.4, bars: [1.0, 2.0, 1.0], d: 2.0, g: 0.0 };

fn leaning(angle: f64, rate: f64) -> State<[f64; 4]> {
    let (sin, cos) = angle.sin_cos();
    let v = [-rate * sin, rate * cos];
    State::new([cos, sin, 2.0 + cos, sin], [0.7 * v[0], 0.7 * v[1], 1.5 * v[0], 1.5 * v[1]])
}

#[test]
fn no_step_leads_over_a_position_with_two_ways_on() {
    macro_rules! refuses {
        ($($method:expr),*) => { $(
            for h in [0.01, 0.037, 0.2] {
                let mut sim = PARALLELOGRAM.integrator($method, h, leaning(1.0, -1.0));
                let mut refused = None;
                for _ in 0..300 {
                    let before = sim.state();
                    if let Err(error) = sim.step() {
                        assert_eq!(sim.state(), before);
                        refused = Some(error);
                        break;
                    }
                    let q = sim.state().q;
                    assert!(q[1] > 0.0 && q[3] > 0.0, "{q:?} by {h}");
                }
                assert!(
                    matches!(refused, Some(StepError { failure: Failure::DependentConstraints { .. } | Failure::Singular | Failure::NotConverged { .. }, .. })),
                    "{refused:?} by {h}"
                );
            }
        )* };
    }
    refuses!(Rattle, DiscreteGradient);
    // At such a position.
    for rate in [0.0, 1.0] {
        let outcome = PARALLELOGRAM.integrator(Rattle, 0.01, leaning(0.0, rate)).step();
        assert!(matches!(outcome, Err(StepError { failure: Failure::DependentConstraints { .. }, .. })), "{outcome:?}");
        let text = outcome.expect_err("two ways").to_string();
        assert!(text.contains("more than one way leads on"), "{text}");
    }
}

/// A step is refused if a rod would have to turn farther than a step can. Lengths of 0 and NaN are refused, too.
#[test]
fn steps_that_are_too_long() {
    let fast = DoublePendulum { g: 0.0, ..DOUBLE };
    let start = State { p: [40.0, 0.0, 0.6 * 40.0, 0.0], ..released() };
    for outcome in [
        fast.integrator(Rattle, 1.0, start).step(),
        fast.integrator(DiscreteGradient, f64::NAN, start).step(),
        fast.integrator(Rattle, 0.0, start).step(),
    ] {
        assert!(outcome.is_err());
    }
}

/// A ladder between a wall and the floor: two coordinates stay zero.
#[hamiltonian(constraint = [((q[0] - q[2]).powi(2) + (q[1] - q[3]).powi(2) - l * l) / 2.0, q[0], q[3]])]
fn ladder(q: [f64; 4], p: [f64; 4], m: [f64; 2], l: f64, g: f64) -> f64 {
    let kinetic = (p[0] * p[0] + p[1] * p[1]) / (2.0 * m[0]) + (p[2] * p[2] + p[3] * p[3]) / (2.0 * m[1]);
    kinetic + g * (m[0] * q[1] + m[1] * q[3])
}

/// A run continues from the states that another run returns. A state off the constraint by 10⁻¹² is refused.
#[test]
fn states_of_a_run_are_starts() -> Result<(), StepError> {
    let system = Ladder { m: [1.3, 0.7], l: 1.0, g: 9.81 };
    let mut state = State::new([0.0, 0.8, 0.6, 0.0], [0.0; 4]);
    for _ in 0..30 {
        let mut sim = system.integrator(Rattle, 0.01, state);
        sim.advance(1)?;
        let mut gradient = system.integrator(DiscreteGradient, 0.01, sim.state());
        gradient.advance(1)?;
        state = gradient.state_on_constraint()?;
    }
    let off = State { q: [1e-12, state.q[1], state.q[2], state.q[3]], ..state };
    let outcome = system.integrator(Rattle, 0.01, off).step();
    assert!(matches!(outcome, Err(StepError { failure: Failure::OffConstraint { .. }, .. })), "{outcome:?}");
    Ok(())
}

/// Neither the centre of a sphere nor NaN has a nearest state on the sphere.
#[test]
fn no_state_is_nearest() {
    let sphere = SphericalPendulum { m: 0.7, l: 1.3, g: 9.81 };
    let centre = sphere.state_on_constraint(&State::new([0.0; 3], [0.0; 3]));
    assert!(matches!(centre, Err(StepError { failure: Failure::DependentConstraints { .. }, .. })), "{centre:?}");
    let nowhere = sphere.state_on_constraint(&State::new([f64::NAN, 0.0, 1.0], [0.0; 3]));
    assert!(matches!(nowhere, Err(StepError { failure: Failure::NonFiniteState, .. })), "{nowhere:?}");
}

/// Steps are so long that the rounding of h ∂H/∂p is visible in positions. Positions stay on the constraint, or the step is refused.
#[test]
fn huge_steps_stay_on_the_constraint() -> Result<(), StepError> {
    /// A charge on a sphere.
    #[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - 1.0) / 2.0])]
    fn charge(q: [f64; 3], p: [f64; 3], b: f64) -> f64 {
        let u = [p[0] + 0.5 * b * q[1], p[1] - 0.5 * b * q[0], p[2]];
        0.5 * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]) + 9.81 * q[2]
    }
    let system = Charge { b: 2.0 };
    let start = system.state_on_constraint(&State::new([0.6, 0.0, -0.8], [0.3, 1.0, 0.2]))?;
    macro_rules! stays {
        ($($method:expr),*) => { $(
            for h in [1.0, 1e3, 1e5, 1e6, 1e8, 1e12] {
                let mut sim = system.integrator($method, h, start);
                for _ in 0..100 {
                    if sim.step().is_err() {
                        break;
                    }
                    let q = sim.state().q;
                    assert!((q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - 1.0).abs() < 1e-13, "{q:?} by {h}");
                }
            }
        )* };
    }
    stays!(Rattle, DiscreteGradient, Suzuki4.of(DiscreteGradient));
    Ok(())
}
