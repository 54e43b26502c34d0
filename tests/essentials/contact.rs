//! Methods for contact systems: orders, and the decay of the energy that friction prescribes.

use crate::claim::{energy, has_order, holds};
use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, Trajectory};

fn start() -> ContactState<f64> {
    ContactState::new(1.1, 0.6, 0.3)
}

macro_rules! orders {
    ($($method:expr, control $control:expr;)*) => {{
        let mut series = DAMPED.taylor(Taylor { tolerance: 1e-16 }, start());
        series.advance_to(2.0).expect("the problem is regular");
        $( has_order(
            stringify!($method),
            Method::<Damped>::claims(&$method).order,
            0.1,
            series.state(),
            |h| DAMPED.integrator($method, h, start()),
            |h| DAMPED.integrator($control, h, start()),
        ); )*
    }};
}

#[test]
fn every_family_has_its_order() {
    orders! {
        BlanesMoan4X, control ContactSplitting;
        Suzuki4.of(ContactSplitting), control ContactSplitting;
        BlanesMoan6, control PositionVerlet;
        Suzuki4.of(ContactLeapfrog), control ContactLeapfrog;
        ContactGauss::<2>, control ContactMidpoint;
        Suzuki4.of(ContactDiscreteGradient), control ContactDiscreteGradient;
    }
}

/// H decays as exp(−γt) along the flow. The discrete gradient takes the same factor in every step; the midpoint rule misses it.
#[test]
fn the_energy_decays_as_friction_says() {
    let decay = |run: &mut dyn Trajectory<State = ContactState<f64>>| {
        let mut largest = 0.0_f64;
        let first = run.energy();
        for step in 1..=400_u32 {
            run.step().expect("the problem is regular");
            let expected = first * (-DAMPED.gamma * 0.05 * f64::from(step)).exp();
            largest = largest.max((run.energy() - expected).abs());
        }
        largest
    };
    let method = DAMPED.integrator(ContactDiscreteGradient, 0.05, start());
    holds("decay of H", 1e-13, decay, method, DAMPED.integrator(ContactMidpoint, 0.05, start()));
}

/// With friction C ∂H/∂p no step of the discrete gradient gains energy, however long it is; an explicit step does.
#[test]
fn damping_never_feeds() {
    let gain = |run: &mut dyn Trajectory<State = State<f64>>| {
        let mut largest = 0.0_f64;
        for _ in 0..50 {
            let before = run.energy();
            if run.step().is_err() {
                return f64::INFINITY;
            }
            largest = largest.max(run.energy() - before);
        }
        largest
    };
    for h in [0.1, 3.0] {
        let start = State::new(1.1, 0.6);
        let method = BRAKED.integrator(DiscreteGradient, h, start);
        holds("gain of energy", 1e-14, gain, method, BRAKED.integrator(ExplicitEuler, 3.0, start));
    }
}

/// Without friction the energy of a contact system is constant.
#[test]
fn without_friction_the_energy_is_kept() {
    let still = Damped { gamma: 0.0, ..DAMPED };
    let method = still.integrator(ContactDiscreteGradient, 0.05, start());
    holds("energy", 1e-13, energy(1000), method, still.integrator(ContactMidpoint, 0.05, start()));
}
