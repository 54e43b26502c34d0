//! The flow of one piece, applied to a point and checked.

use crate::method::{Failure, Probe, Step, check_way};
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate, Point, Summation};
use crate::system::{Evaluations, Piece, Pieces, Poles};

/// Coefficients of the flows of all pieces.
pub(super) struct Flows<'a, S: Pieces<M, R>, M, R: Real> {
    pub(super) flows: &'a S::Flows,
    /// Values at the frozen time.
    pub(super) frozen: &'a S::Frozen,
    pub(super) poles: &'a Poles,
}

impl<S: Pieces<M, R>, M, R: Real> Clone for Flows<'_, S, M, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Pieces<M, R>, M, R: Real> Copy for Flows<'_, S, M, R> {}

/// Applies the flows of some pieces. Each one begins at the time of `step`.
///
/// # Errors
/// If a flow that solves an equation may have crossed a pole. The probe is told of flows that end early.
#[inline(always)]
pub(super) fn apply<S: Pieces<M, R>, M, R: Real, C: Summation<S::Phase>, P: Probe<S, R>>(
    pieces: impl Iterator<Item = usize>,
    Flows { flows, frozen, poles }: Flows<'_, S, M, R>,
    Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
) -> Result<(), Failure> {
    for i in pieces {
        let piece = S::PIECES[i];
        let solved = const { any_solved(S::PIECES) } && piece.solved;
        let before = (x.z, x.s);
        let reports = P::EFFORT.is_thorough() && piece.may_end && x.is_finite();
        if C::PLAIN {
            // An action that is not followed goes to a copy, so that the optimiser removes its computation.
            let mut unread = x.s;
            let s = if C::ACTION { &mut x.s } else { &mut unread };
            system.flow(i, flows, frozen, t, &mut x.z, s);
        } else {
            let d = system.increments(i, flows, frozen, t, &PerCoordinate::of(x));
            x.add_everywhere(&d);
        }
        if solved && x.z.is_finite() {
            let Point { z, s, needs_recheck, .. } = &mut *x;
            let ends = ([t; 2], [&before.0, &*z], [&before.1, &*s]);
            check_way::<S, R, P>(poles, Evaluations::AtPoints, system, ends, needs_recheck)?;
        } else if solved && reports {
            probe.unsolved(piece.name);
        } else if reports {
            probe.flown(piece.name, || x.is_finite());
        }
    }
    Ok(())
}

/// Returns whether a piece solves an equation in place of a flow. Other pieces need no check.
const fn any_solved(pieces: &[Piece]) -> bool {
    let mut i = 0;
    while i < pieces.len() {
        if pieces[i].solved {
            return true;
        }
        i += 1;
    }
    false
}
