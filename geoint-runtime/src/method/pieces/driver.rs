//! The driver of pieces: one step, and many steps, of every table.
//!
//! Let Φ(h) be the flows of all pieces in order, and Φ*(h) the same flows in reverse order. A table is Φ*(β_K h) Φ(α_K h) … Φ*(β₁h) Φ(α₁h). A splitting is the table
//! with K = 1 and α₁ = β₁ = ½. The last flow of Φ and the first one of the following Φ* belong to the last piece, and are one flow. The last flow of Φ* and the first
//! one of the following Φ belong to the first piece. They are one flow, too, if this flow is exact in time: also between steps.
//!
//! Frozen time is constant between Φ and Φ*: it moves before all flows of Φ, and after all flows of Φ*.

use super::splittings::Splitting;
use super::table::PieceComposition;
use crate::method::open::Open;
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step, Unwatched, check_way};
use crate::scalar::{Real, zero};
use crate::space::{Array, PerCoordinate, Point, Summation};
use crate::system::{Clock as PieceClock, Evaluations, Piece, Pieces, Poles};

/// Coefficients of Φ(αh), then Φ*(βh).
#[derive(Clone, Copy, Debug)]
pub struct Pair<F, R> {
    /// Φ, with the whole flow of the last piece.
    forth: F,
    /// Φ* without the last piece.
    back: F,
    /// The first flow of Φ, merged with the last flow of the Φ* before. In the first pair this is the Φ* of the step before.
    joint: F,
    /// The time after the start of the step at which Φ begins.
    start: R,
    /// The time at which Φ ends and Φ* begins.
    middle: R,
    /// The time at which the merged flow begins.
    joint_start: R,
    poles: Poles,
}

/// The place of a step in a call. Flows between the steps of a call are merged.
#[derive(Clone, Copy, Debug)]
struct Place {
    is_first: bool,
    is_last: bool,
}

impl<S: Pieces<M, R>, M: Splitting, R: Real, const K: usize> Method<S, R> for PieceComposition<K, M> {
    type Proof = <S as Pieces<M, R>>::Proof;
    type Prepared = [Pair<S::Flows, R>; K];
    type Memory = Open<S::Phase, S::Action>;

    fn claims(&self) -> Claims {
        Claims {
            order: self.order(),
            symmetric: true,
            symplectic: S::SYMPLECTIC,
            conserves_energy: S::CONSERVES_ENERGY,
            perturbed: &[],
            forces: Some(K as u32),
        }
    }

    fn name(&self) -> Name {
        self.table_name()
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        let (weights, poles) = (self.weights().map(|pair| pair.map(R::from_f64)), Poles::of(system));
        core::array::from_fn(|i| {
            // Sums are computed in R, whose precision may exceed that of the table.
            let [alpha, beta] = weights[i];
            let [_, beta_before] = weights[(i + K - 1) % K];
            let joint = beta_before + alpha;
            let before = weights[..i].as_flattened().iter().fold(zero(), |sum: R, weight| sum + *weight);
            let flows = |outer: R, last: R| system.prepare_flows(outer * h, last * h);
            Pair {
                forth: flows(alpha, alpha + beta),
                back: flows(beta, beta),
                joint: flows(joint, joint),
                start: before * h,
                middle: (before + alpha) * h,
                joint_start: (before + alpha - joint) * h,
                poles,
            }
        })
    }

    fn memory() -> Self::Memory {
        Open::unknown()
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        open: &mut Self::Memory,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        take::<S, M, R, C, P>(prepared, open, step, Place { is_first: true, is_last: true })
    }

    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        prepared: &Self::Prepared,
        open: &mut Self::Memory,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Phase, C, S::Action>,
    ) -> Result<(), Failure> {
        // A local point of this loop stays in registers.
        let mut here = *x;
        for n in 0..steps {
            let [t, end] = [clock.at(n), clock.at(n + 1)];
            let step = Step { system, t, end, x: &mut here, probe: &mut Unwatched };
            take::<S, M, R, C, _>(prepared, open, step, Place { is_first: n == 0, is_last: n + 1 == steps })?;
        }
        *x = here;
        Ok(())
    }
}

/// Takes one step.
#[inline(always)]
fn take<S: Pieces<M, R>, M, R: Real, C: Summation<S::Phase>, P: Probe<S, R>>(
    pairs: &[Pair<S::Flows, R>],
    open: &mut Open<S::Phase, S::Action>,
    mut step: Step<'_, S, R, C, P>,
    Place { is_first, is_last }: Place,
) -> Result<(), Failure> {
    let (all, merges, [t, end]) = (S::PIECES.len(), merges::<S, M, R>(), [step.t, step.end]);
    let continues = merges && (!is_first || open.return_to(t, step.x).is_some());
    for (i, Pair { forth, back, joint, start, middle, joint_start, poles }) in pairs.iter().enumerate() {
        let [start, middle, joint_start] = [*start, *middle, *joint_start].map(|after| t + after);
        let frozen = [forth, back].map(|flows| step.system.freeze(flows, middle));
        step.probe.visit(start, &step.x.z, &step.x.s);
        let (first, from) = if merges && i > 0 || continues { (joint, joint_start) } else { (forth, start) };
        apply::<S, M, R, C, P>(0..1, Flows { flows: first, frozen: &frozen[0], poles }, step.part([from; 2]))?;
        apply::<S, M, R, C, P>(1..all, Flows { flows: forth, frozen: &frozen[0], poles }, step.part([start; 2]))?;
        let back = Flows { flows: back, frozen: &frozen[1], poles };
        apply::<S, M, R, C, P>((1..all - 1).rev(), back, step.part([middle; 2]))?;
        let is_end = is_last && i + 1 == pairs.len();
        if merges && !is_end {
            continue;
        }
        if merges {
            open.leave(step.x);
        }
        // The only piece of a system is the last one.
        apply::<S, M, R, C, P>(0..usize::from(all > 1), back, step.part([middle; 2]))?;
    }
    if merges && is_last {
        open.end([t, end], step.x);
    }
    Ok(())
}

/// Returns whether two successive flows of the first piece are one. Flows at frozen time are not, because the time differs. Solutions of an equation are not flows.
fn merges<S: Pieces<M, R>, M, R: Real>() -> bool {
    S::PIECES.len() > 1 && S::PIECES[0].clock == PieceClock::Own && !S::PIECES[0].solved
}

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
