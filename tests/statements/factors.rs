//! The factor of the contact form η = ds − p dq in a step, and the factor of the volume.
//!
//! S14: a contact flow multiplies the volume η∧(dη)ⁿ at the rate −(n + 1) ∂H/∂s, and η at the rate −∂H/∂s. A contact map that multiplies η by λ
//! multiplies the volume by λⁿ⁺¹.

use crate::derivative::Derivative;
use geoint_runtime::method::{Visitor, catalogue};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::methods;
use geoint_tests::scalars::{Double, Dual};
use geoint_tests::scene::Scene;
use geoint_tests::scenes::{Blows, Coolings, Drives, Masses, Stars, Swings};
use std::marker::PhantomData;

/// Step length of the scenes with friction γ = 0.4, so that γh = 0.15.
const STEP: f64 = 0.375;

/// e^(−γh) = e^(−0.15), the factor of every splitting under constant friction.
const SPLITTINGS: f64 = 0.860_707_976_425_057_8;

/// (1 − 0.075)/(1 + 0.075), the factor of leapfrog and of the midpoint rule.
const CAYLEY: f64 = 0.860_465_116_279_069_9;

/// Diagonal Padé values of e^(−0.15), the factors of Gauss' methods with 2 and 3 stages.
const PADE: [f64; 2] = [0.860_708_067_324_434_1, 0.860_707_976_410_455_7];

/// Bounds the rounding of factors and volumes. The longest composition has 35 steps.
const ROUNDING: f64 = 2e-13;

/// Tests that every visited contact map has the expected factor, and that its volume is λⁿ⁺¹.
struct Factors<P> {
    h: f64,
    expected: f64,
    within: f64,
    maps: usize,
    controls: usize,
    scene: PhantomData<P>,
}

impl<P: Scene> Factors<P> {
    fn new(h: f64, expected: f64, within: f64) -> Self {
        Factors { h, expected, within, maps: 0, controls: 0, scene: PhantomData }
    }
}

impl<P: Scene> Visitor<P::Over<Dual>, Dual> for Factors<P> {
    fn visit<M: Method<P::Over<Dual>, Dual> + 'static>(&mut self, method: M) {
        let (name, claims) = (method.name(), method.claims());
        let step = Derivative::of_step::<P, M>(method, self.h);
        let (factor, defect, excess) = (step.factor(), step.defect(), step.excess());
        let seen = format!("{} {name}: factor {factor}, form {defect:.1e}, volume {excess:.1e}", P::NAME);
        if claims.symplectic {
            self.maps += 1;
            assert!((factor - self.expected).abs() <= self.within && defect <= 1e-12 && excess <= ROUNDING, "{seen}");
        } else if claims.order <= 2 {
            // Control: this map keeps no contact form, and its volume is not λⁿ⁺¹.
            self.controls += 1;
            assert!(defect > 1e-4 && excess > 1e-4, "{seen}");
        }
    }
}

#[test]
fn splittings_have_the_factor_of_the_flow() {
    let mut factors = Factors::<Swings>::new(STEP, SPLITTINGS, ROUNDING);
    methods::pieces(&mut factors);
    methods::separable(&mut factors);
    methods::nystrom(&mut factors);
    methods::force_gradient(&mut factors);
    assert_eq!((factors.maps, factors.controls), (47, 0));
    let mut factors = Factors::<Masses>::new(STEP, SPLITTINGS, ROUNDING);
    methods::kinds_of_pieces(&mut factors);
    methods::kinds_of_separable(&mut factors);
    methods::kinds_of_nystrom(&mut factors);
    methods::kinds_of_force_gradient(&mut factors);
    assert_eq!((factors.maps, factors.controls), (12, 0));
}

/// Compositions multiply the factors of their substeps. Those of leapfrog and midpoint rule differ from e^(−γh) by at most the error of one step.
#[test]
fn variational_steps_have_rational_factors() {
    fn is<P: Scene, M: Method<P::Over<Dual>, Dual>>(method: M, expected: f64) {
        let name = method.name();
        let step = Derivative::of_step::<P, M>(method, STEP);
        let off = step.factor() - expected;
        assert!(off.abs() <= ROUNDING && step.excess() <= ROUNDING, "{} {name}: {off:e}", P::NAME);
    }
    let suzuki = |x: f64| {
        let w = 1.0 / (4.0 - 4.0_f64.cbrt());
        let cayley = |x: f64| (1.0 - x / 2.0) / (1.0 + x / 2.0);
        cayley(w * x).powi(4) * cayley((1.0 - 4.0 * w) * x)
    };
    is::<Swings, _>(ContactLeapfrog, CAYLEY);
    is::<Masses, _>(ContactLeapfrog, CAYLEY);
    is::<Swings, _>(ContactMidpoint, CAYLEY);
    is::<Masses, _>(ContactMidpoint, CAYLEY);
    is::<Swings, _>(ContactGauss::<1>, CAYLEY);
    is::<Swings, _>(ContactGauss::<2>, PADE[0]);
    is::<Masses, _>(ContactGauss::<2>, PADE[0]);
    is::<Swings, _>(ContactGauss::<3>, PADE[1]);
    is::<Swings, _>(Suzuki4.of(ContactLeapfrog), suzuki(0.15));
    is::<Swings, _>(Suzuki4.of(ContactMidpoint), suzuki(0.15));

    let mut factors = Factors::<Swings>::new(STEP, SPLITTINGS, SPLITTINGS - CAYLEY + ROUNDING);
    catalogue::mechanical(&mut factors);
    catalogue::contact(&mut factors);
    assert_eq!((factors.maps, factors.controls), (22, 1));
}

/// Friction g(t)s: λ = exp(−∫g) if the flow is exact in time, and e^(−hg) with g in the middle of the step if time is frozen.
#[test]
fn friction_that_changes_has_the_factor_of_its_integral() {
    fn have<P: Scene>(expected: f64, list: impl Fn(&mut Factors<P>)) {
        let mut factors = Factors::<P>::new(STEP, expected, ROUNDING);
        list(&mut factors);
        assert!(factors.maps > 0);
    }
    let since = |start: f64| start / (start + STEP);
    have::<Stars>(since(0.6).powi(2), methods::kinds_of_pieces);
    have::<Stars>(since(0.6).powi(2), methods::kinds_of_nystrom);
    have::<Coolings>(since(0.6).powf(1.7), methods::kinds_of_pieces);
    // A wind in the drift: its flow is not known in closed form with the friction, so time is frozen.
    have::<Blows>((-STEP * 1.7 / (0.6 + STEP / 2.0)).exp(), |factors| factors.visit(ContactSplitting));
    let friction = |t: f64| 0.6 * (0.7 + (1.3 * t).sin());
    have::<Drives>((-STEP * friction(0.2 + STEP / 2.0)).exp(), |factors| factors.visit(ContactSplitting));
    let cayley = (1.0 - STEP * friction(0.2) / 2.0) / (1.0 + STEP * friction(0.2 + STEP) / 2.0);
    have::<Drives>(cayley, |factors| factors.visit(ContactLeapfrog));
}

/// The numbers of this file are values of the exponential function and of its Padé approximations.
#[test]
fn expected_factors_are_values_of_their_formulas() {
    let z = Double::from(-0.15);
    let two = (1.0 + z / 2.0 + z * z / 12.0) / (1.0 - z / 2.0 + z * z / 12.0);
    let three = (1.0 + z / 2.0 + z * z / 10.0 + z * z * z / 120.0) / (1.0 - z / 2.0 + z * z / 10.0 - z * z * z / 120.0);
    for (noted, formula) in [(SPLITTINGS, z.exp()), (PADE[0], two), (PADE[1], three)] {
        assert!((noted - formula.value()).abs() < 2e-16, "{noted}");
    }
}
