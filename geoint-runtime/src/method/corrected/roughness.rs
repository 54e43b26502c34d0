//! Measures the rounding of a residual r from its values near a point at which an iteration is stuck.
//!
//! Let r(δ) be the residual at the distance δ from the point, in units of the last correction. The method compares second differences at distances δ that
//! double, d(δ) = r(0) − 2 r(δ) + r(2δ):
//!
//! - For a smooth residual, d grows by 4 from each δ to the next. At a bend, d grows by 2.
//! - For noise, d does not grow.
//! - A single jump by rounding makes d grow once, where δ reaches the jump.
//!
//! The rounding is the largest d before growth shows over three successive distances. The first two of them still count as rounding, because a jump could
//! explain them. Both sides of the point are examined, and the smaller result counts. A bend on one side is therefore not taken for rounding. The method
//! fails in some cases, for instance if bends lie on both sides, so callers bound the result.
//!
//! The points lie along the last correction. This suits invariants, because all coordinates take part in their correction. In equations of implicit
//! steps, some unknowns may have tiny corrections and large rounding. For these equations, [`noise`](crate::solving::noise) moves every unknown. One
//! measurement here takes 329 evaluations of the residual, so callers measure only if an iteration is stuck.

use crate::scalar::{Real, zero};
use crate::space::Array;
use crate::space::vector::{moved, sum};

/// The points at which the residual is evaluated, as parts of a distance. d is the largest over the points. Irregular parts keep the points from being
/// rounded alike.
const POINTS: [f64; 4] = [0.59, 0.73, 0.87, 1.0];

/// The nearest and the farthest distance as powers of 2, in units of the last correction.
///
/// A wild correction may be much longer than the scale on which the residual is curved, so the nearest points lie far within the correction. Jumps by
/// rounding may be many corrections apart, so the farthest points lie far beyond it.
const NEAREST: i32 = -30;
const FARTHEST: i32 = 10;

/// The least growth of d to the next distance that counts as curvature. It is the geometric mean of 2, for a bend, and 4, for a parabola.
const CURVED: f64 = 2.83;

/// The largest growth of d to the next distance that counts as curvature. Larger growth contains a jump by rounding. For a residual r = δ⁵, d grows by
/// exactly this factor.
const JUMP: f64 = 32.0;

/// The least d that counts as curvature, as a part of the residual r(0). Between two jumps by rounding, the residual may be a smooth curve of a smaller
/// height, which must not end the measurement.
const VISIBLE: f64 = 1.0 / 64.0;

/// Returns the size of the rounding of each entry of a residual.
///
/// `residual` takes a multiple of the last correction, of either sign, and returns the residual there, or `None` if it does not exist. The result is then
/// zero.
#[cold]
#[inline(never)]
pub(crate) fn rounding<A: Array>(mut residual: impl FnMut(A::Real) -> Option<A>) -> A {
    let Some(here) = residual(zero()) else { return A::zero() };
    let mut sides = [A::zero(); 2];
    for (side, sign) in sides.iter_mut().zip([1.0, -1.0]) {
        let Some(rounding) = on_side(sign, &here, &mut residual) else { return A::zero() };
        *side = rounding;
    }
    let [mut least, other] = sides;
    for (least, other) in least.as_mut_slice().iter_mut().zip(other.as_slice()) {
        *least = A::Real::from_f64(least.magnitude().min(other.magnitude()));
    }
    least
}

/// Returns the rounding on one side of the point, at which the residual is `here`. `sign` is the side. Returns `None` if the residual does not exist at one
/// of the points.
fn on_side<A: Array>(sign: f64, here: &A, residual: &mut impl FnMut(A::Real) -> Option<A>) -> Option<A> {
    let mut at = |power: i32| {
        let mut residuals = [A::zero(); POINTS.len()];
        for (r, point) in residuals.iter_mut().zip(POINTS) {
            *r = residual(A::Real::from_f64(sign * libm::ldexp(point, power)))?;
        }
        Some(residuals)
    };
    let (mut rounding, mut is_curved) = (A::zero(), A::fill(false));
    // `before` holds d at the last two distances.
    let (mut near, mut before) = (at(NEAREST)?, [A::zero(); 2]);
    for power in NEAREST + 1..=FARTHEST {
        let far = at(power)?;
        let mut difference = A::zero();
        for (near, far) in near.iter().zip(&far) {
            let second = moved(&sum(here, far), A::Real::from_f64(-2.0), near);
            for (difference, second) in difference.as_mut_slice().iter_mut().zip(second.as_slice()) {
                *difference = A::Real::from_f64(difference.magnitude().max(second.magnitude()));
            }
        }
        for (i, is_curved) in A::entries(&mut is_curved).iter_mut().enumerate() {
            let [first, second, third] =
                [&before[0], &before[1], &difference].map(|difference| difference.as_slice()[i].magnitude());
            let grows = |near: f64, far: f64| CURVED * near <= far && far <= JUMP * near && near > 0.0;
            *is_curved |=
                grows(first, second) && grows(second, third) && third >= VISIBLE * here.as_slice()[i].magnitude();
            let rounding = &mut rounding.as_mut_slice()[i];
            if !*is_curved && rounding.magnitude() < third {
                *rounding = A::Real::from_f64(third);
            }
        }
        (near, before) = (far, [before[1], difference]);
    }
    Some(rounding)
}
