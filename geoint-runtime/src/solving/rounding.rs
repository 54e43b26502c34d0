//! Is a correction rounding? The one answer for every iteration.
//!
//! An iteration ends where the next correction is bound to be below the last digit, or where corrections are small and do not shrink
//! any more. Small is what a correction is relative to the size of what it corrects, and that includes the terms which are added up
//! on the way to it: see [`noise`](crate::solving::noise).

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::size::Sizes;
use crate::space::{Array, Square};

/// Reached only where there is no convergence.
pub(crate) const MAX_ITERATIONS: u32 = 100;

/// Bound on the error that an iteration leaves behind, in units of ε. That error has the same sign in every step, and adds up: at
/// ε/1024 a drift of the energy is seen after a million steps.
pub(crate) const REMAINDER: f64 = 1.0 / 1_048_576.0;

/// A relative correction of so many ε that does not shrink any more is rounding.
pub(crate) const ROUNDINGS: f64 = 64.0;

/// The rounding of an unknown in a residual, in ε: positions, distances and forces each lose their last digits.
const LAST_DIGITS: f64 = 8.0;

/// A residual of more than so many times the unknown is no rounding, whatever the digits of its terms are: far from all that a state has been, and
/// in a step of many turns, they may be larger than the state.
const LARGEST: f64 = 1024.0;

/// Iterations without a correction that is smaller than all before, by this factor. Once may be chance, and corrections that turn round one
/// another shrink on the whole.
const MOST_STUCK: u32 = 4;
const SMALLER: f64 = 0.75;

/// Where convergence is quadratic, near a solution a correction is less than this part of the one before.
const SLOW: f64 = 0.25;

/// Rounding by which corrections do not shrink is seen at points that are farther apart than they are large, by this, and by the second
/// factor more each time that it is not seen.
const FARTHER: f64 = 16.0;
const AND_FARTHER: f64 = 4.0;

/// How often rounding is looked for: it costs more evaluations than a step. Where corrections are stuck again they do not shrink for
/// another reason.
const MOST_LOOKS: u32 = 5;

/// What a correction says of the iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// Another one follows.
    Continue,
    /// It was the last one.
    Solved,
    /// Corrections have stopped to shrink, and are larger than rounding of what they correct. They may shrink again later.
    Stuck,
}

/// The corrections of an iteration so far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corrections {
    /// The convergence that the iteration has near the solution: from c₁ to c₂, the next correction is c₂(c₂/c₁)ᵒʳᵈᵉʳ.
    order: i32,
    iterations: u32,
    /// The last one, relative to what it corrects.
    before: f64,
    smallest: f64,
    stuck: u32,
    slow: bool,
    looks: u32,
    /// Of the points at which rounding is looked for, in units of a correction.
    distance: f64,
}

impl Corrections {
    pub(crate) fn of_order(order: i32) -> Self {
        Corrections {
            order,
            iterations: 0,
            before: f64::INFINITY,
            smallest: f64::INFINITY,
            stuck: 0,
            slow: false,
            looks: 0,
            distance: FARTHER,
        }
    }

    /// Corrections that follow are relative to something else.
    pub(crate) fn restart(&mut self) {
        let (looks, distance) = (self.looks + 1, AND_FARTHER * self.distance);
        *self = Self { before: f64::INFINITY, smallest: f64::INFINITY, stuck: 0, looks, distance, ..*self };
    }

    /// At points that are so many times farther apart than the last correction is large, rounding is looked for that keeps corrections from
    /// shrinking.
    pub(crate) fn farther(&self) -> f64 {
        self.distance
    }

    /// Whether the last one is larger than it would be near a solution to which convergence is quadratic: what the iteration takes for the
    /// derivative may be rounding.
    #[inline(always)]
    pub(crate) fn slow(&self) -> bool {
        self.slow
    }

    /// The last one, relative to what it corrects; infinite if there is none.
    #[inline(always)]
    pub(crate) fn last(&self) -> f64 {
        self.before
    }

    /// The verdict on the next correction, `relative` to what it corrects.
    #[inline(always)]
    pub(crate) fn judge<R: Real>(&mut self, relative: f64) -> Verdict {
        let (first, shrunk) = (self.before == f64::INFINITY, relative / self.before);
        self.iterations += 1;
        self.before = relative;
        if first {
            self.smallest = relative;
            return if relative == 0.0 { Verdict::Solved } else { Verdict::Continue };
        }
        let next = relative * if self.order == 2 { shrunk * shrunk } else { shrunk };
        if next <= REMAINDER * R::epsilon() || shrunk > 0.5 && is_rounding::<R>(relative) {
            return Verdict::Solved;
        }
        if relative < SMALLER * self.smallest {
            (self.smallest, self.stuck) = (relative, 0);
        } else {
            self.stuck += 1;
        }
        self.slow = shrunk > SLOW;
        if self.stuck == MOST_STUCK && self.looks < MOST_LOOKS { Verdict::Stuck } else { Verdict::Continue }
    }

    /// The refusal of an iteration that ends here without a solution.
    #[cold]
    pub(crate) fn not_converged(&self) -> Refusal {
        Refusal::NotConverged { iterations: self.iterations, correction: self.before }
    }
}

/// Whether a relative correction that does not shrink is rounding.
#[inline(always)]
pub(crate) fn is_rounding<R: Real>(relative: f64) -> bool {
    relative <= ROUNDINGS * R::epsilon()
}

/// Whether a residual is small enough to be rounding of terms that add up to an unknown of this size.
#[inline(always)]
pub(crate) fn may_be_rounding(residual: f64, size: f64) -> bool {
    residual <= LARGEST * size
}

/// Returns whether changes of the unknowns in their last digits explain a residual with the derivative `matrix`. If large forces cancel, corrections never
/// become smaller than such changes.
///
/// W. Oettli & W. Prager, Numer. Math. 6 (1964) 405.
pub(crate) fn is_of_last_digits<A: Array>(sizes: &Sizes<A>, residual: &A, matrix: &Square<A>) -> bool {
    A::entries_of::<A>(matrix).iter().zip(residual.as_slice()).enumerate().all(|(i, (row, left))| {
        let terms =
            row.as_slice().iter().zip(sizes.as_slice()).map(|(slope, size)| slope.magnitude() * size.magnitude());
        let left = left.magnitude();
        left <= LAST_DIGITS * A::Real::epsilon() * terms.sum::<f64>() && may_be_rounding(left, sizes.of(i))
    })
}

/// Subtracts corrections of coordinates from `x` until nothing but rounding is left. Corrections shrink by a factor.
///
/// `correction` gives the one at a point, and how large it is relative to the terms of what it corrects. Where they are stuck `is_noise` says of
/// the last point and the correction there whether the residual is rounding of larger terms.
pub(crate) fn correct<A: Array>(
    mut x: A,
    mut is_noise: impl FnMut(&A, &A) -> bool,
    mut correction: impl FnMut(&A) -> Result<(A, f64), Refusal>,
) -> Result<A, Refusal> {
    let mut corrections = Corrections::of_order(1);
    for _ in 0..MAX_ITERATIONS {
        let (delta, relative) = correction(&x)?;
        let before = x;
        x.add_scaled(A::Real::from_f64(-1.0), &delta);
        match corrections.judge::<A::Real>(relative) {
            Verdict::Solved => return Ok(x),
            Verdict::Stuck if is_noise(&before, &delta) => return Ok(before),
            Verdict::Stuck => corrections.restart(),
            _ if !relative.is_finite() => break,
            Verdict::Continue => {}
        }
    }
    Err(corrections.not_converged())
}
