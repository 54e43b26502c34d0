//! Mass matrices that are singular somewhere, under explicit methods: each step over a singular state is refused.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// p = v³ − v and M = 3v² − 1. From rest the solution ends at t = 1.061 with v² = 1/3.
#[lagrangian]
fn quartic(q: f64, v: f64) -> f64 {
    v.powi(4) / 4.0 - v * v / 2.0 - q * q / 2.0
}

/// `quartic` with friction and a force.
#[lagrangian(rayleigh = 0.1 * v * v, force = 0.3 * (3.0 * t).cos())]
fn pushed(q: f64, v: f64, t: f64) -> f64 {
    v.powi(4) / 4.0 - v * v / 2.0 - q * q / 2.0 + 0.0 * t
}

/// `quartic` with an action.
#[lagrangian]
fn braked(q: f64, v: f64, s: f64) -> f64 {
    v.powi(4) / 4.0 - v * v / 2.0 - q * q / 2.0 - 0.1 * s
}

/// p = sin v has infinitely many velocities for each momentum. The solution ends where v = π/2.
#[lagrangian]
fn cosine(q: f64, v: f64) -> f64 {
    -v.cos() - q * q / 2.0 + q
}

/// M = (1 − t)(1 + 3v²) vanishes at t = 1.
#[lagrangian]
fn leaking(q: f64, v: f64, t: f64) -> f64 {
    (1.0 - t) * (v * v / 2.0 + v.powi(4) / 4.0) - q * q / 2.0
}

/// M = q. Its energy is p²/(2q) + q/2.
#[lagrangian]
fn falling(q: f64, v: f64) -> f64 {
    q * v * v / 2.0 - 0.5 * q
}

/// M couples three velocities and is q₀ times a positive definite matrix.
#[lagrangian]
fn coupled(q: [f64; 3], v: [f64; 3]) -> f64 {
    let both = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[2] - q[1]).cos();
    0.5 * q[0] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + 0.4 * both) - 0.5 * q[0]
}

/// Ω = −2q₁.
#[lagrangian]
fn fold(q: [f64; 2], v: [f64; 2]) -> f64 {
    q[1] * q[1] * v[0] - 0.5 * q[0] * q[0] - q[1]
}

/// Takes steps to t = 3 and returns the time of a refusal that names `cause`.
fn refused<S: PhaseSpace, M: Method<S>>(system: S, method: M, h: f64, start: S::State, cause: &str) -> Option<f64>
where
    S::State: Copy,
{
    let mut sim = Integrator::new(system, method, h, start);
    let error = sim.advance((3.0 / h) as u64).err()?;
    assert!(error.to_string().contains(cause), "by {h}: {error}");
    Some(sim.time())
}

const SINGULAR: &str = "the mass matrix ∂²L/∂v² is singular there, or on the way";

macro_rules! refuse {
    ($system:expr, $start:expr, $cause:expr, $end:expr, $($method:expr),*) => { $(
        for h in [0.013, 0.05, 0.3] {
            let time = refused($system, $method, h, $start, $cause);
            assert!(time.is_some_and(|t| t < $end + h), "{} by {h}: {time:?}", stringify!($method));
        }
    )* };
}

#[test]
fn no_explicit_step_leads_over_a_singular_mass_matrix() {
    let start = Quartic.at(0.3, 0.0);
    refuse!(Quartic, start, SINGULAR, 1.07, RK4, DOP853, ExplicitEuler, Projection(RK4, Energy), Relaxation(RK4));
    refuse!(Pushed, Pushed.at(0.3, 0.0), SINGULAR, 1.5, RK4, DOP853);
    refuse!(Braked, Braked.at(0.3, 0.0, 0.0), SINGULAR, 1.12, RK4, DOP853, ExplicitEuler);
    refuse!(Cosine, Cosine.at(0.3, 1.0), SINGULAR, 0.31, RK4, DOP853, ExplicitEuler);
    refuse!(Leaking, Leaking.at(1.0, -1.0), SINGULAR, 1.0, RK4, DOP853, ExplicitEuler);
    refuse!(Coupled, Coupled.at([0.5, 0.2, -0.1], [-1.5, 0.3, 0.2]), SINGULAR, 0.7, RK4, DOP853, ExplicitEuler);
    let pole = "a pole between the ends of the step: q";
    refuse!(Falling, Falling.at(1.0, -1.0), pole, 0.7, RK4, DOP853, ExplicitEuler);
    refuse!(Fold, Fold.at([0.0, 0.5]), "a pole between the ends of the step", 0.7, RK4, DOP853, ExplicitEuler);
}

/// Steps of adapted length end at the time at which the solution ends, with the energy of the start.
#[test]
fn steps_of_adapted_length_end_at_the_singular_state() {
    macro_rules! end {
        ($($method:expr),*) => { $(
            let mut sim = Quartic.adaptive($method, 1e-8, Quartic.at(0.3, 0.0));
            let energy = sim.energy();
            let error = sim.advance_to(2.0).unwrap_err();
            assert!(error.to_string().contains(SINGULAR), "{error}");
            assert!((sim.time() - 1.0614).abs() < 1e-4 && (sim.energy() - energy).abs() < 1e-6, "{}", stringify!($method));
        )* };
    }
    end!(RK4, DOP853);
}

/// Single precision, backwards in time, between steps, and from another state.
#[test]
fn every_kind_of_run_is_refused_there() -> Result<(), StepError> {
    #[lagrangian]
    fn single(q: f32, v: f32) -> f32 {
        v.powi(4) / 4.0 - v * v / 2.0 - q * q / 2.0
    }
    let mut sim = Single.integrator(RK4, 0.05, Single.at(0.3, 0.0));
    let error = sim.advance(40).unwrap_err();
    assert!(error.to_string().contains(SINGULAR) && sim.time() < 1.07, "{error}");

    let mut back = Quartic.integrator(RK4, -0.05, Quartic.at(0.3, 0.0));
    assert!(back.advance(40).is_err() && back.time() > -1.07);

    let mut sim = Quartic.integrator(RK4, 0.05, Quartic.at(0.3, 0.0));
    let mut last = 0.0;
    let outcome = sim.sampled_every(0.02).take(100).try_for_each(|sample| sample.map(|state| last = state.t));
    assert!(outcome.is_err() && last < 1.07, "{last}");

    let mut sim = Quartic.integrator(RK4, 0.05, Quartic.at(0.3, 0.0));
    sim.advance(5)?;
    sim.set_state(Quartic.at(0.5, 0.5));
    assert!(sim.advance(40).is_err());
    Ok(())
}

/// Controls: M is singular at other velocities, or indefinite, or negative. All steps lead on, and with the order of the method.
#[test]
fn other_states_are_no_obstacle() -> Result<(), StepError> {
    // Within the well of −M the motion is slow enough.
    let mut sim = Quartic.integrator(RK4, 0.01, Quartic.at(0.05, 0.1));
    let energy = sim.energy();
    sim.advance(100)?;
    assert!((sim.energy() - energy).abs() < 1e-9);
    // Beyond v = 1/√3 M is positive.
    let mut sim = Quartic.integrator(DOP853, 0.01, Quartic.at(0.3, 1.5));
    let energy = sim.energy();
    sim.advance(50)?;
    assert!((sim.energy() - energy).abs() < 1e-12 && (energy - 2.7168).abs() < 1e-3, "{energy}");

    #[lagrangian]
    fn mixed(q: [f64; 3], v: [f64; 3]) -> f64 {
        let turned = v[2] + 0.3 * v[0] * q[1].cos();
        0.7 * v[0] * v[1] + 0.5 * turned * turned - q[0] * q[1] - 0.5 * q[2] * q[2]
    }
    let mut sim = Mixed.integrator(RK4, 0.01, Mixed.at([0.3, 0.2, -0.1], [-0.4, 0.5, 0.3]));
    let energy = sim.energy();
    sim.advance(1000)?;
    assert!((sim.energy() - energy).abs() < 1e-8);
    // M = q, thrown away from its zero.
    let mut sim = Falling.integrator(RK4, 0.01, Falling.at(1.0, 0.5));
    sim.advance(100)
}

/// Several velocities have the same momentum. A state yields only one of these velocities, and the others are refused.
#[test]
fn a_velocity_that_is_not_that_of_its_momentum_is_refused() {
    let refused = |error: StepError| {
        assert!(matches!(error, StepError { t: 0.0, failure: Failure::NoMomentum, .. }), "{error:?}");
        assert!(error.to_string().contains("another velocity has the same momenta"), "{error}");
    };
    // 0.176 has the momentum of 0.9.
    let state = Quartic.at(0.3, 0.9);
    assert!(Quartic.velocity(&state).is_nan());
    assert!((Quartic.momentum(0.0, 0.3, 0.9) + 0.171).abs() < 1e-12);
    refused(Quartic.integrator(RK4, 0.05, state).step().unwrap_err());
    refused(Quartic.integrator(Gauss::<2>, 0.05, state).step().unwrap_err());
    refused(Quartic.adaptive(DOP853, 1e-6, state).step().unwrap_err());
    refused(Braked.integrator(ContactGauss::<2>, 0.05, Braked.at(0.3, 0.9, 0.0)).step().unwrap_err());
    refused(Cosine.integrator(RK4, 0.05, Cosine.at(0.3, 3.0)).step().unwrap_err());
    // Controls.
    for v in [0.0, 0.2, -0.55, 1.5, -3.0, 1e6] {
        let found = Quartic.velocity(&Quartic.at(0.3, v));
        assert!((found - v).abs() <= 1e-7 * v.abs(), "{v}: {found}");
    }
    let start = Cosine.at(0.3, 1.5);
    assert!((Cosine.velocity(&start) - 1.5).abs() < 1e-12);
}
