//! Every attribute: two forms of one system move alike, and another parameter, the control, moves elsewhere.

use crate::claim::{distance_from, holds};
use crate::systems::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{BodyState, ContactState, FlowState};
use nalgebra::{UnitQuaternion, Vector3};

/// Rounding of a Taylor series over the time of a test.
const ROUNDING: f64 = 1e-12;
const SERIES: Taylor = Taylor { tolerance: 1e-15 };

/// Claim: a Lagrangian moves as its Hamiltonian, whose potential is a function under `#[energy_function]`.
#[test]
fn lagrangian_and_hamiltonian() {
    let (q, v) = (1.2, 0.7);
    let start = SWINGING.at(q, v);
    assert_eq!(start.p, SWINGING.m * SWINGING.l * SWINGING.l * v);
    let mut known = PENDULUM.taylor(SERIES, start);
    known.advance_to(3.0).expect("the problem is regular");
    let other = Swinging { l: 0.71, ..SWINGING };
    holds(
        "#[lagrangian]",
        ROUNDING,
        distance_from(known.state()),
        SWINGING.taylor(SERIES, start),
        other.taylor(SERIES, start),
    );
}

/// Claim: the principle of Herglotz gives the contact system with the same friction.
#[test]
fn herglotz_and_contact_hamiltonian() {
    let start = ContactState::new(1.1, 0.6, 0.3);
    let mut known = DAMPED.taylor(SERIES, start);
    known.advance_to(3.0).expect("the problem is regular");
    let other = Herglotz { gamma: 0.41, ..HERGLOTZ };
    holds(
        "#[contact_hamiltonian]",
        ROUNDING,
        distance_from(known.state()),
        HERGLOTZ.taylor(SERIES, start),
        other.taylor(SERIES, start),
    );
}

/// Claim: contact friction −γp is the friction of a Rayleigh function, which `damping = C` adds: C ∂H/∂p = γp for C = γm.
#[test]
fn damping_and_contact_hamiltonian() {
    let mut known = DAMPED.taylor(SERIES, ContactState::new(1.1, 0.6, 0.3));
    known.advance_to(3.0).expect("the problem is regular");
    let ContactState { q, p, .. } = known.state();
    let start = State::new(1.1, 0.6);
    let braked = |c| Braked { c, ..BRAKED }.taylor(SERIES, start);
    let known = State::at(3.0, q, p);
    let c = DAMPED.gamma * DAMPED.m;
    holds("damping = C", ROUNDING, distance_from(known), braked(c), braked(1.01 * c));
}

/// Claim: a Lagrangian that is linear in the velocities gives the field of the same animals.
#[test]
fn first_order_lagrangian_and_vector_field() {
    let start = FlowState::new([1.0, 1.5]);
    let mut known = ANIMALS.taylor(SERIES, start);
    known.advance_to(3.0).expect("the problem is regular");
    let other = Animals { a: 1.01, ..ANIMALS };
    holds(
        "#[vector_field]",
        ROUNDING,
        distance_from(known.state()),
        ANIMALS.integrator(Gauss::<6>, 0.05, start),
        other.integrator(Gauss::<6>, 0.05, start),
    );
    let mut linear = LINEAR.integrator(DiscreteGradient, 0.01, LINEAR.at([1.0, 1.5]));
    linear.advance_to(3.0).expect("the problem is regular");
    let ([x, y], FlowState { x: known, .. }) = (linear.state().x, known.state());
    let distance = f64::max((x - known[0]).abs(), (y - known[1]).abs());
    assert!(distance < 1e-4, "{distance:.1e}");
}

/// Claim: a Lagrangian without a short inverse of its mass matrix keeps its energy, with velocities as unknowns.
#[test]
fn lagrangian_by_velocities() {
    let start = ARM.at([0.3, -0.2, 0.5], [0.1, 0.0, -0.4]);
    holds(
        "energy of an arm",
        1e-13,
        crate::claim::energy(500),
        ARM.integrator(DiscreteGradient, 0.05, start),
        ARM.integrator(ImplicitMidpoint, 0.05, start),
    );
}

/// Claim: a free body that turns by its attitude, exactly in one step, has the momenta of Euler's equations, which `structure = …` states.
#[test]
fn attitude_and_structure() {
    let free = Heavy { inertia: FREE_BODY.inertia, c: Vector3::zeros() };
    let turned = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.6, 1.1, -0.5));
    let mut known = free.integrator(StormerVerlet, 1.0, turned);
    known.advance(3).expect("the problem is regular");
    let m = known.state().m;
    let known = FlowState { t: 3.0, x: [m[0], m[1], m[2]] };
    let start = FlowState::new([0.6, 1.1, -0.5]);
    let other = FreeBody { inertia: [1.31, 2.1, 3.0] };
    holds(
        "structure = …",
        ROUNDING,
        distance_from(known),
        FREE_BODY.taylor(SERIES, start),
        other.taylor(SERIES, start),
    );
}

/// Reports name the structure that was proven.
#[test]
fn reports() {
    let report = HenonHeiles::<f64>::REPORT;
    assert!(report.contains("T is quadratic in p") && !report.contains("not separable"), "{report}");
    let report = Shears::<f64>::REPORT;
    assert!(report.contains("not separable"), "{report}");
}
