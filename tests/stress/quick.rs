//! A little of each section, in every run of the tests.

use crate::rounding::walks;
use crate::run::{adapting, fixed};
use crate::systems::{comet, eight, pythagorean, spring};
use geoint_runtime::TaylorIntegrator;
use geoint_runtime::prelude::*;

/// Errors of rounding walk at random at worst, so that after 10⁴ steps they are far below N ε.
#[test]
fn rounding_does_not_grow_like_the_number_of_steps() {
    for walk in walks() {
        let points = (walk.compensated)(4, 1);
        let (steps, error) = points[points.len() - 1];
        assert!(error <= 10.0 * f64::EPSILON * steps.sqrt(), "{}: {error:.1e} after {steps:.0}", walk.name);
    }
}
