//! Is what a method keeps a number of ordinary size?

use crate::scalar::Real;
use crate::space::Array;
use crate::system::{Invariants, PhaseSpace};

/// Returns whether no invariant underflows or overflows at a point: the products of the coordinates and their slopes, from which it is made, are
/// numbers with all their digits. Methods that compare an invariant with its former value keep nothing otherwise.
#[inline(never)]
pub(crate) fn is_representable<S: PhaseSpace<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    z: &S::Phase,
) -> bool {
    let gradients = invariants.gradients(system, z);
    I::Values::entries_of(&gradients).iter().all(|gradient| has_range(z.as_slice(), gradient.as_slice()))
}

fn has_range<R: Real>(z: &[R], gradient: &[R]) -> bool {
    let smallest = R::smallest();
    let (mut terms, mut underflows) = (0.0_f64, false);
    for (x, slope) in z.iter().zip(gradient) {
        let (x, slope) = (x.magnitude(), slope.magnitude());
        // Factors that are not finite are reported elsewhere. A product with a subnormal factor, or with zero, says nothing.
        if !(x.is_finite() && slope.is_finite()) {
            return true;
        }
        terms += x * slope;
        underflows |= x >= smallest && slope >= smallest && x * slope < smallest;
    }
    !(underflows && terms < smallest) && terms < 1.0 / smallest
}
