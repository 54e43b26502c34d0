//! Measures the rounding of a residual at a point x.
//!
//! Forces between neighbours cancel, and quotients divide by small numbers. The rounding of a residual may therefore be far larger than the last digits of the
//! unknowns. It becomes visible when the residual is evaluated at neighbouring points: high differences of a smooth function are small, and high differences
//! of rounding are not. J. J. Moré & S. M. Wild, SIAM J. Sci. Comput. 33 (2011) 1292.
//!
//! `points` chooses a line through x. `differences` evaluates the residual at growing distances on this line until it is smooth. Limit: the result is an
//! estimate and no bound. [`measure`] takes up to 515 evaluations, so solvers call it only if corrections are stuck.

mod differences;
mod points;

use crate::scalar::Real;
use crate::solving::rounding::{is_rounding, may_be_rounding};
use crate::solving::size::{Sizes, Units};
use crate::space::Array;
use crate::space::vector::difference;
use differences::{POINTS, SPARE, Workspace};
use points::{Start, first_distance, write_direction};

/// The largest residual that counts as rounding, in units of its noise, the result of [`measure`]. A residual is the sum of several rounding errors, and a few
/// differences determine their deviations only roughly. A smaller limit would refuse solved equations.
const DEVIATIONS: f64 = 16.0;

/// The last correction of an iteration, and the multiple of it at which a measurement starts.
#[derive(Clone, Copy)]
pub(crate) struct LastCorrection<A> {
    pub(crate) delta: A,
    pub(crate) multiple: f64,
}

/// Returns an estimate of the rounding of every entry of a residual near `x`, in the units of the residual. It is a standard deviation, or the change of the
/// residual by the last digits of `x` if this change is larger.
///
/// `residual` returns `None` at points at which no residual exists; farther points are then not evaluated. Unknowns move in proportion to the largest unknown
/// of their kind. Up to two measurements evaluate the residual at growing distances from `x`. Their starts depend on the distance `multiple`·`delta`, which is
/// large for a kind if it exceeds 10⁻³ of the unknowns of this kind:
///
/// - The first measurement starts at this distance. Nearer points may share equally rounded terms, and the residual then looks smooth. A kind with a large
///   distance starts at ε. Otherwise the residual of a small unknown beside large ones would be smooth at all points.
/// - The second measurement takes place only if the distance is large for a kind. All kinds start at this distance. An unknown may be as small as the rounding
///   of the value to which it is added. Its corrections are then as large as the unknown, and the residual is a staircase.
///
/// The digits of the unknowns may not resolve an entry at any distance. The first measurement then counts as 0. The second one counts as 0, too, unless it has
/// resolved at least half of the entries of this kind. It then counts as at most their smallest noise.
#[cold]
#[inline(never)]
pub(crate) fn measure<A: Array>(
    sizes: &Sizes<A>,
    x: &A,
    LastCorrection { delta, multiple }: LastCorrection<A>,
    units: Units,
    mut residual: impl FnMut(&A) -> Option<A>,
) -> A {
    let (mut direction, mut noise) = (A::zero(), A::zero());
    write_direction(sizes.as_slice(), units, direction.as_mut_slice());
    // The last digits of the unknowns also change the residual. This change counts as rounding, like the rounding of the terms.
    let mut largest = last_digits(x, &direction, &mut residual);
    for start in [Start::Near, Start::Corrections] {
        let mut direction = direction;
        let nearest = first_distance(delta.as_slice(), multiple, units, start, direction.as_mut_slice());
        let Some(nearest) = nearest else { break };
        let (mut values, mut marks) = ([A::zero(); POINTS + SPARE], [A::fill(false); 2]);
        let [smooth, resolved] = &mut marks;
        let workspace = Workspace {
            values: A::flatten_mut(&mut values),
            smooth: A::entries(smooth),
            resolved: A::entries(resolved),
            noise: noise.as_mut_slice(),
        };
        workspace.measure(nearest, multiple, start, units, &mut |distance, value| {
            let mut moved = *x;
            moved.add_scaled(distance, &direction);
            match residual(&moved) {
                Some(r) if r.is_finite() => {
                    value.copy_from_slice(r.as_slice());
                    true
                }
                _ => false,
            }
        });
        for (largest, noise) in largest.as_mut_slice().iter_mut().zip(noise.as_slice()) {
            if largest.magnitude() < noise.magnitude() {
                *largest = *noise;
            }
        }
    }
    largest
}

/// Returns the change of a residual if the unknowns move by 2 ε times `direction`: ε to 3 ε times the largest size of their kind. The side with the smaller
/// change counts, because the other side may contain a jump. Zero if the residual does not exist.
fn last_digits<A: Array>(x: &A, direction: &A, residual: &mut impl FnMut(&A) -> Option<A>) -> A {
    let Some(here) = residual(x) else { return A::zero() };
    let mut change = |sign: f64| {
        let mut moved = *x;
        moved.add_scaled(A::Real::from_f64(2.0 * sign * A::Real::epsilon()), direction);
        residual(&moved).map_or(A::zero(), |there| difference(&there, &here))
    };
    let (mut least, other) = (change(1.0), change(-1.0));
    for (least, other) in least.as_mut_slice().iter_mut().zip(other.as_slice()) {
        // NaN does not count on either side.
        let (first, second) = (least.magnitude(), other.magnitude());
        *least = if second < first || first.is_nan() { *other } else { *least };
    }
    least
}

/// Returns whether rounding explains every entry of a residual. An entry is explained if it is at most 64 ε times the size of its unknown. It is also explained
/// if it is at most 16 times its `noise`, and at most 1024 times the size of its unknown.
pub(crate) fn explains<A: Array>(noise: &A, residual: &A, sizes: &Sizes<A>) -> bool {
    (0..A::LEN).all(|i| {
        let left = residual.as_slice()[i].magnitude();
        may_be_rounding(left, sizes.of(i)) && left <= DEVIATIONS * noise.as_slice()[i].magnitude()
            || is_rounding::<A::Real>(left / sizes.of(i))
    })
}

/// Returns the addresses of functions that depend on the scalar only. `private::compiled` names them, and thus compiles them with this crate.
pub(crate) fn compiled<R: Real>() -> [*const (); 2] {
    [Workspace::<R>::measure as *const (), write_direction::<R> as *const ()]
}
