//! The stopping criteria of iterations. Newton's loop has a short form of them. ε is the machine epsilon of the scalar.
//!
//! A correction is relative to the size of the unknown that it corrects. An iteration ends if the predicted next correction is below 2⁻²⁰ ε, or if a correction
//! is below 64 ε and above half of the one before. The next correction after c₁ and c₂ is predicted as c₂(c₂/c₁) for linear convergence, and as c₂(c₂/c₁)² for
//! quadratic convergence. No tolerance of the user takes part, because invariants hold at the solution only. Limit: a prediction is no bound.
//!
//! If large terms cancel in a residual, corrections stop shrinking earlier. The residual is then compared with the last digits of the unknowns
//! ([`is_of_last_digits`]), or its rounding is measured ([`noise`](crate::solving::noise)).

use crate::scalar::Real;
use crate::solving::Failure;
use crate::solving::size::Sizes;
use crate::space::{Array, Square};

/// The largest number of iterations. Iterations that converge need far fewer.
pub(crate) const MAX_ITERATIONS: u32 = 100;

/// An iteration ends if the predicted error is at most this number of ε. This error may have one sign in all steps, and then adds up: with 1/1024, the energy
/// drifts visibly in a million steps.
pub(crate) const REMAINDER: f64 = 1.0 / 1_048_576.0;

/// A relative correction that no longer shrinks is rounding if it is at most this many ε. A larger number would accept solutions with visible errors. A smaller
/// number would make more steps measure their rounding.
pub(crate) const ROUNDINGS: f64 = 64.0;

/// The rounding of an unknown in a residual, in ε. It has room for the last digits of positions, distances and forces.
const LAST_DIGITS: f64 = 8.0;

/// A residual larger than this many times the size of its unknown is no rounding, however large its terms are. Terms may exceed the state at points far away,
/// and in steps of many turns. Without the limit, points far away would pass as solutions.
const RESIDUAL_LIMIT: f64 = 1024.0;

/// An iteration is stuck after this many successive corrections that are not smaller. One such correction may be chance.
const STUCK_CORRECTIONS: u32 = 4;
/// A correction is smaller if it is below this part of the smallest one before.
const SMALLER: f64 = 0.75;

/// With quadratic convergence, a correction near the solution is expected below this part of the one before. A larger part is a sign of rounding, or of a wrong
/// derivative.
const SLOW: f64 = 0.25;

/// The least distance of the points at which rounding is measured first, in units of the last correction. Nearer points may share equally rounded terms.
const FIRST_DISTANCE: f64 = 16.0;
/// The growth of this distance from each measurement of an iteration to the next one.
const DISTANCE_GROWTH: f64 = 4.0;

/// The largest number of measurements in an iteration. Each one costs more evaluations than a step. If corrections are stuck after all of them, there is
/// another reason.
const MOST_MEASUREMENTS: u32 = 5;

/// The decision after a correction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// Another correction follows.
    Continue,
    /// This was the last correction.
    Solved,
    /// Corrections have stopped shrinking, but exceed 64 ε. The caller decides whether the residual is rounding. Otherwise corrections may shrink again later.
    Stuck,
}

/// The expected convergence of an iteration near the solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Convergence {
    /// With an approximate derivative.
    Linear,
    /// With the exact derivative.
    Quadratic,
}

/// The corrections of an iteration so far. Each one is relative to the size of the unknown.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corrections {
    convergence: Convergence,
    iterations: u32,
    /// The last correction, or infinity if there is none since the start or the last [`restart`](Self::restart).
    before: f64,
    /// The first correction, then each one that is smaller by the factor [`SMALLER`].
    smallest: f64,
    /// The number of corrections since `smallest`.
    stuck: u32,
    /// See [`slow`](Self::slow).
    slow: bool,
    /// The number of measurements of rounding.
    measurements: u32,
    /// See [`distance`](Self::distance).
    distance: f64,
}

impl Corrections {
    /// Creates the state before the first correction.
    pub(crate) fn of(convergence: Convergence) -> Self {
        Corrections {
            convergence,
            iterations: 0,
            before: f64::INFINITY,
            smallest: f64::INFINITY,
            stuck: 0,
            slow: false,
            measurements: 0,
            distance: FIRST_DISTANCE,
        }
    }

    /// Forgets the corrections of an iteration that is stuck, except for their number, and counts a measurement. The next one uses points farther apart.
    pub(crate) fn restart(&mut self) {
        let (measurements, distance) = (self.measurements + 1, DISTANCE_GROWTH * self.distance);
        *self = Self { before: f64::INFINITY, smallest: f64::INFINITY, stuck: 0, measurements, distance, ..*self };
    }

    /// Returns the least distance of the points of the next measurement of rounding, in units of the last correction.
    pub(crate) fn distance(&self) -> f64 {
        self.distance
    }

    /// Returns whether the last ratio of two corrections was above 1/4. With quadratic convergence the derivative may then be wrong, or corrections consist of
    /// rounding. With linear convergence such ratios are usual.
    #[inline(always)]
    pub(crate) fn slow(&self) -> bool {
        self.slow
    }

    /// Returns the last correction, or infinity if there is none since the start or the last [`restart`](Self::restart).
    #[inline(always)]
    pub(crate) fn last(&self) -> f64 {
        self.before
    }

    /// Adds a correction, which is `relative` to the size of the unknown, and returns the decision. NaN is never solved, but may be stuck, so callers check it.
    #[inline(always)]
    pub(crate) fn judge<R: Real>(&mut self, relative: f64) -> Verdict {
        let (first, shrunk) = (self.before == f64::INFINITY, relative / self.before);
        self.iterations += 1;
        self.before = relative;
        if first {
            self.smallest = relative;
            return if relative == 0.0 { Verdict::Solved } else { Verdict::Continue };
        }
        let next = match self.convergence {
            Convergence::Linear => relative * shrunk,
            Convergence::Quadratic => relative * shrunk * shrunk,
        };
        if relative == 0.0 || next <= REMAINDER * R::epsilon() || shrunk > 0.5 && is_rounding::<R>(relative) {
            return Verdict::Solved;
        }
        if relative < SMALLER * self.smallest {
            (self.smallest, self.stuck) = (relative, 0);
        } else {
            self.stuck += 1;
        }
        self.slow = shrunk > SLOW;
        if self.stuck == STUCK_CORRECTIONS && self.measurements < MOST_MEASUREMENTS {
            Verdict::Stuck
        } else {
            Verdict::Continue
        }
    }

    /// Returns the refusal of an iteration that ends without a solution. It contains [`last`](Self::last).
    #[cold]
    pub(crate) fn not_converged(&self) -> Failure {
        Failure::NotConverged { iterations: self.iterations, correction: self.before }
    }
}

/// Returns whether a relative correction is at most 64 ε. Precondition: corrections do not shrink, otherwise it may be a true correction.
#[inline(always)]
pub(crate) fn is_rounding<R: Real>(relative: f64) -> bool {
    relative <= ROUNDINGS * R::epsilon()
}

/// Returns whether a residual is at most 1024 times the size of its unknown. A larger residual is no rounding. A smaller one needs further tests.
#[inline(always)]
pub(crate) fn may_be_rounding(residual: f64, size: f64) -> bool {
    residual <= RESIDUAL_LIMIT * size
}

/// Returns whether changes of the unknowns in their last digits explain a residual r with the derivative J = `matrix`: |rᵢ| ≤ 8 ε Σⱼ |Jᵢⱼ| sⱼ and
/// |rᵢ| ≤ 1024 sᵢ, with the sizes s. If large forces cancel, corrections never become smaller than such changes. Limit: rounding within the formula of r is not
/// part of the bound. W. Oettli & W. Prager, Numer. Math. 6 (1964) 405.
pub(crate) fn is_of_last_digits<A: Array>(sizes: &Sizes<A>, residual: &A, matrix: &Square<A>) -> bool {
    A::entries_of::<A>(matrix).iter().zip(residual.as_slice()).enumerate().all(|(i, (row, left))| {
        let terms =
            row.as_slice().iter().zip(sizes.as_slice()).map(|(slope, size)| slope.magnitude() * size.magnitude());
        let left = left.magnitude();
        left <= LAST_DIGITS * A::Real::epsilon() * terms.sum::<f64>() && may_be_rounding(left, sizes.of(i))
    })
}

/// A correction at a point, and its largest entry relative to the size of the unknown.
pub(crate) struct Correction<A> {
    pub(crate) delta: A,
    pub(crate) relative: f64,
}

/// The last two points of an iteration that is stuck, and the correction between them: after = before − delta.
pub(crate) struct Stuck<'a, A> {
    pub(crate) before: &'a A,
    pub(crate) delta: &'a A,
    pub(crate) after: &'a A,
}

/// Subtracts corrections from `start` until only rounding is left. Small equations beside the equation of a step use it, such as projections.
///
/// `corrections` is the state before the first correction. `correction` returns the correction at a point. If corrections are stuck, `accept` returns the
/// solution, or `None` if the iteration has to continue. The last correction may be NaN then.
///
/// # Errors
/// If `correction` returns an error, if a correction is not finite, or after [`MAX_ITERATIONS`] corrections.
#[inline(always)]
pub(crate) fn correct<A: Array>(
    start: A,
    mut corrections: Corrections,
    mut accept: impl FnMut(Stuck<'_, A>) -> Option<A>,
    mut correction: impl FnMut(&A) -> Result<Correction<A>, Failure>,
) -> Result<A, Failure> {
    let mut x = start;
    for _ in 0..MAX_ITERATIONS {
        let Correction { delta, relative } = correction(&x)?;
        let before = x;
        x.add_scaled(A::Real::from_f64(-1.0), &delta);
        let verdict = corrections.judge::<A::Real>(relative);
        if !relative.is_finite() {
            break;
        }
        match verdict {
            Verdict::Solved => return Ok(x),
            Verdict::Stuck => match accept(Stuck { before: &before, delta: &delta, after: &x }) {
                Some(solution) => return Ok(solution),
                None => corrections.restart(),
            },
            Verdict::Continue => {}
        }
    }
    Err(corrections.not_converged())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_correction_that_is_not_a_number_is_never_accepted() {
        // The fourth correction that is not smaller than the first one is stuck, and callers accept such points.
        for last in [1.0, f64::NAN, f64::INFINITY] {
            let mut sequence = [1.0, 1.0, 1.0, 1.0, last].into_iter();
            let result = correct(
                [0.0],
                Corrections::of(Convergence::Quadratic),
                |Stuck { after, .. }| Some(*after),
                |_| {
                    let delta = sequence.next().ok_or(Failure::Singular)?;
                    Ok(Correction { delta: [delta], relative: delta })
                },
            );
            match last {
                1.0 => assert_eq!(result, Ok([-5.0])),
                _ => assert!(matches!(result, Err(Failure::NotConverged { iterations: 5, .. })), "{last}: {result:?}"),
            }
        }
    }
}
