//! Methods for rigid bodies, for x' = S(x) ∇H, and for fields with first integrals.

use crate::claim::{change, energy, has_order, holds};
use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{
    FlowState, PlanarDiscreteGradient, PlanarItohAbe, PlanarItohAbePair, PlanarSplitting, PoissonSplitting,
};
use nalgebra::{UnitQuaternion, Vector3};

const STEPS: u64 = 1000;

fn momentum() -> FlowState<[f64; 3]> {
    FlowState::new([0.6, 1.1, -0.5])
}

/// The square of the angular momentum is a Casimir of the structure: no energy changes it.
fn casimir(state: &FlowState<[f64; 3]>) -> f64 {
    state.x.iter().map(|x| x * x).sum()
}

#[test]
fn casimirs() {
    let control = || FREE_BODY.integrator(RK4, 0.1, momentum());
    let kept = || change(STEPS, casimir);
    holds("PoissonSplitting", 1e-13, kept(), FREE_BODY.integrator(PoissonSplitting, 0.1, momentum()), control());
    holds("DiscreteGradient", 1e-13, kept(), FREE_BODY.integrator(DiscreteGradient, 0.1, momentum()), control());
    // The energy: exact flows of its terms do not keep their sum.
    let splitting = FREE_BODY.integrator(PoissonSplitting, 0.1, momentum());
    holds("energy", 1e-13, energy(STEPS), FREE_BODY.integrator(DiscreteGradient, 0.1, momentum()), splitting);
}

#[test]
fn splittings_by_terms() {
    let mut series = FREE_BODY.taylor(Taylor { tolerance: 1e-16 }, momentum());
    series.advance_to(2.0).expect("the problem is regular");
    let run = |h| FREE_BODY.integrator(BlanesMoan4X.of(PoissonSplitting), h, momentum());
    has_order("PoissonSplitting", 4, 0.1, series.state(), run, |h| {
        FREE_BODY.integrator(PoissonSplitting, h, momentum())
    });
}

/// Volterra's integral by discrete gradients, in whole steps and in planes.
#[test]
fn integrals_of_fields() {
    let start = FlowState::new([1.0, 1.5]);
    let integral = |state: &FlowState<[f64; 2]>| {
        let ([x, y], Animals { a, b, c }) = (state.x, ANIMALS);
        b * x - c * x.ln() + b * y - a * y.ln()
    };
    macro_rules! keep {
        ($($method:expr),*) => { $(
            let method = ANIMALS.integrator($method, 0.05, start);
            holds(stringify!($method), 1e-13, change(STEPS, integral), method, ANIMALS.integrator(RK4, 0.05, start));
        )* };
    }
    keep!(DiscreteGradient, FourthOrder(DiscreteGradient), Projection(RK4, Integrals));
    keep!(PlanarDiscreteGradient, PlanarItohAbe, PlanarItohAbePair);
}

/// Planar parts with exact flows.
#[test]
fn splittings_by_planes() {
    let mut series = FREE_BODY.taylor(Taylor { tolerance: 1e-16 }, momentum());
    series.advance_to(2.0).expect("the problem is regular");
    let run = |h| FREE_BODY.integrator(PlanarSplitting, h, momentum());
    has_order("PlanarSplitting", 2, 0.1, series.state(), run, |h| FREE_BODY.integrator(ExplicitEuler, h, momentum()));
}

/// A heavy body: its attitude stays a unit quaternion and its momentum about the vertical stays; each method has its order.
#[test]
fn rigid_bodies() {
    let start = BodyState::new(UnitQuaternion::from_euler_angles(0.3, -0.4, 0.2), Vector3::new(0.5, 1.6, -1.2));
    let system = heavy_body();
    let vertical = |x: &BodyState<UnitQuaternion<f64>>| (x.r * x.m)[2];
    let kept = change(STEPS, vertical)(&mut system.integrator(StormerVerlet, 0.05, start));
    assert!(kept < 1e-13, "{kept:.1e}");
    let mut fine = system.integrator(KahanLi8_17a.of(StormerVerlet), 0.02, start);
    fine.advance(50).expect("the problem is regular");
    has_order(
        "BlanesMoan4",
        4,
        0.1,
        fine.state(),
        |h| system.integrator(BlanesMoan4, h, start),
        |h| system.integrator(StormerVerlet, h, start),
    );
    has_order(
        "FiveRotations",
        2,
        0.1,
        fine.state(),
        |h| system.integrator(FiveRotations, h, start),
        |h| system.integrator(SymplecticEuler, h, start),
    );
}
