//! Is a residual that an iteration cannot reduce nothing but rounding?
//!
//! At twice the distance the second difference of a smooth residual is four times as large. Rounding differs: noise does not grow, and rounding that
//! jumps at single points grows once. So second differences are compared at larger and larger distances, until the residual is seen to be curved. What
//! they were before is rounding. They are taken on both sides of a point: beside a bend one side is straight.

use crate::scalar::{Real, zero};
use crate::space::Array;
use crate::space::vector::{moved, sum};

/// Points at the distance 1. Irregular, so that not all are rounded alike.
const POINTS: [f64; 4] = [0.59, 0.73, 0.87, 1.0];

/// The nearest and the farthest distance as powers of 2, in units of the last correction. A correction of an iteration that leads astray may be many
/// lengths over which the residual is curved. Rounding may jump only at points that are many corrections apart: where a factor of the correction is
/// rounded, the residual is as smooth as its other factors.
const NEAREST: i32 = -20;
const FARTHEST: i32 = 10;

/// A second difference that grows by this, and at twice the distance again, is that of a curved residual. It is halfway between 2 for a bend and 4 for
/// a parabola. One that grows by more than the other factor comes from a jump.
const CURVED: f64 = 2.83;
const JUMPS: f64 = 32.0;

/// Curvature by which the residual changes by less than this part of itself does not count.
const VISIBLE: f64 = 1.0 / 64.0;

/// Returns for each entry of a residual how large its rounding is.
///
/// `residual` is evaluated at multiples of the last correction, of either sign. The result is zero if the residual does not exist at one of the points.
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

/// Returns the rounding that is seen on one side of a point at which the residual is `here`.
fn on_side<A: Array>(sign: f64, here: &A, residual: &mut impl FnMut(A::Real) -> Option<A>) -> Option<A> {
    let mut at = |power: i32| {
        let mut residuals = [A::zero(); POINTS.len()];
        for (r, point) in residuals.iter_mut().zip(POINTS) {
            *r = residual(A::Real::from_f64(sign * libm::ldexp(point, power)))?;
        }
        Some(residuals)
    };
    let (mut rounding, mut is_curved) = (A::zero(), A::fill(false));
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
            let grows = |near: f64, far: f64| CURVED * near <= far && far <= JUMPS * near && near > 0.0;
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
