//! Checks that invariants neither underflow nor overflow.

use crate::scalar::Real;
use crate::space::Array;
use crate::system::{Invariants, PhaseSpace};

/// Returns whether the terms zᵢ ∂I/∂zᵢ of every invariant I neither underflow nor overflow at a point. Otherwise changes of I have no digits, and a method cannot
/// keep it. Returns `true` if a factor is not finite, which other checks report. Limit: intermediate results of I are not seen.
#[inline(never)]
pub(crate) fn is_representable<S: PhaseSpace<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    z: &S::Phase,
) -> bool {
    let gradients = invariants.gradients(system, z);
    I::Values::entries_of(&gradients).iter().all(|gradient| terms_are_representable(z.as_slice(), gradient.as_slice()))
}

fn terms_are_representable<R: Real>(z: &[R], gradient: &[R]) -> bool {
    let smallest = R::smallest();
    let (mut terms, mut underflows) = (0.0_f64, false);
    for (x, slope) in z.iter().zip(gradient) {
        let (x, slope) = (x.magnitude(), slope.magnitude());
        // Factors that are not finite are reported elsewhere. A product with a zero or subnormal factor is no underflow of the invariant.
        if !(x.is_finite() && slope.is_finite()) {
            return true;
        }
        terms += x * slope;
        underflows |= x >= smallest && slope >= smallest && x * slope < smallest;
    }
    // A term that vanishes matters only if no larger one remains.
    !(underflows && terms < smallest) && terms < 1.0 / smallest
}
