//! The way to a solution from far: corrections are halved until the residual falls.
//!
//! Only where an iteration with whole corrections has failed. From steep walls and in stiff wells an explicit guess may lie beyond the
//! domain of the energy, or so far off that corrections run away, although a solution that is continuous in h exists.

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::equation::{Observer, StepEquation};
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::vector::{moved, scaled};
use crate::space::{Array, Square};

/// A correction of less than this, relative to the state, is small enough for the iteration that follows.
const NEAR: f64 = 1e-3;

/// Corrections that would have to be shortened more than this lead nowhere.
const SHORTEST: f64 = 1e-6;

const MAX_ITERATIONS: u32 = 100;

/// Something near a solution of an equation, if there is one on the way down from where nothing moves: there the energy is defined if it is
/// at the start of the step.
#[cold]
#[inline(never)]
pub(crate) fn approach_solution<A: Array, W: Observer + ?Sized>(
    sizes: &Sizes<A>,
    equation: impl StepEquation<A, W>,
    watch: &mut W,
) -> A {
    approach(&equation.origin(), equation.standstill(), sizes, |x, residual, matrix| {
        *residual = equation.residual(watch, x, matrix);
        Ok(())
    })
}

/// The same for any residual of an increment of `origin`, on the way down from `still` times `origin`.
#[cold]
#[inline(never)]
pub(crate) fn approach<A: Array>(
    origin: &A,
    still: f64,
    sizes: &Sizes<A>,
    mut residual: impl FnMut(&A, &mut A, &mut Square<A>) -> Result<(), Refusal>,
) -> A {
    let mut matrix = A::fill(A::zero());
    let mut evaluate = |x: &A, matrix: &mut Square<A>| {
        let mut r = A::zero();
        residual(x, &mut r, matrix).map(|()| r)
    };
    let mut x = scaled(A::Real::from_f64(still), origin);
    let Ok(mut r) = evaluate(&x, &mut matrix) else { return x };
    // The residual has the units of the unknowns.
    let mut units = *sizes;
    units.include(origin, &x);
    units.include(&A::zero(), &r);
    for _ in 0..MAX_ITERATIONS {
        let mut delta = r;
        if linear::solve(&mut matrix, &mut delta, &units).is_none() {
            break;
        }
        let mut w = 1.0;
        // Not a number is not less.
        let falls = |w: f64, next: &A| units.square(next) < (1.0 - 0.5 * w) * units.square(&r);
        let (next, less) = loop {
            let next = moved(&x, A::Real::from_f64(-w), &delta);
            match evaluate(&next, &mut matrix) {
                Ok(less) if falls(w, &less) => break (next, less),
                _ if w < SHORTEST => return x,
                _ => w *= 0.5,
            }
        };
        (x, r) = (next, less);
        if w == 1.0 && units.square(&delta) <= NEAR * NEAR {
            break;
        }
    }
    x
}
