//! Tables of pieces, prepared for steps of one length.
//!
//! Let Φ(h) be the flows of all pieces in order, and Φ*(h) the same flows in reverse order. A table is Φ*(β_K h) Φ(α_K h) … Φ*(β₁h) Φ(α₁h). A splitting is the
//! table with K = 1 and α₁ = β₁ = ½. The last flow of Φ and the first one of the following Φ* belong to the last piece, and are one flow.
//!
//! The last flow of Φ* and the first one of the following Φ belong to the first piece. They are merged, and are the outer flows of a step, if there is another piece
//! and this one is a flow that is exact in time. If not, each Φ*Φ is an inner flow.
//!
//! Functions of time that are frozen are evaluated at the time between Φ and Φ*.

use super::flow::{Flows, apply};
use super::splittings::PieceKind;
use super::table::PieceComposition;
use crate::method::flows::driver::{self, Alternation, Outer};
use crate::method::flows::open::Open;
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step};
use crate::scalar::{Real, zero};
use crate::space::{Point, Summation};
use crate::system::{Clock as PieceClock, Pieces, Poles};

/// Coefficients of Φ(αh), then Φ*(βh).
#[derive(Clone, Copy, Debug)]
struct Pair<F, R> {
    /// Φ, with the whole flow of the last piece.
    forth: F,
    /// Φ* without the last piece.
    back: F,
    /// The last flow of Φ*, merged with the first flow of the next Φ, which may belong to the next step. Only its first piece is used.
    joint: F,
    /// The time after the start of the step at which Φ begins.
    start: R,
    /// The time at which Φ ends and Φ* begins.
    middle: R,
}

/// The pairs Φ, Φ* of a step in order of application.
#[derive(Clone)]
pub struct PieceSequence<S: Pieces<M, R>, M, R: Real, const K: usize> {
    pairs: [Pair<S::Flows, R>; K],
    poles: Poles,
}

impl<S: Pieces<M, R>, M: PieceKind, R: Real, const K: usize> PieceSequence<S, M, R, K> {
    /// Prepares a table for steps of length `h`.
    fn prepare(table: &PieceComposition<K, M>, system: &S, h: R) -> Self {
        // Sums are computed in R, whose precision may exceed that of the table.
        let weights = table.weights().map(|pair| pair.map(R::from_f64));
        let flows = |outer: R, last: R| system.prepare_flows(outer * h, last * h);
        let pairs = core::array::from_fn(|i| {
            let [alpha, beta] = weights[i];
            let [next_alpha, _] = weights[(i + 1) % K];
            let before = weights[..i].as_flattened().iter().fold(zero(), |sum: R, weight| sum + *weight);
            Pair {
                forth: flows(alpha, alpha + beta),
                back: flows(beta, beta),
                joint: flows(beta + next_alpha, beta + next_alpha),
                start: before * h,
                middle: (before + alpha) * h,
            }
        });
        PieceSequence { pairs, poles: Poles::of(system) }
    }

    /// Applies the flows of some pieces. They begin at the time `t`, and evaluate frozen functions of time at `frozen_at`.
    #[inline(always)]
    fn apply<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        pieces: impl Iterator<Item = usize>,
        flows: &S::Flows,
        [t, frozen_at]: [R; 2],
        step: &mut Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        let frozen = step.system.freeze(flows, frozen_at);
        apply::<S, M, R, C, P>(pieces, Flows { flows, frozen: &frozen, poles: &self.poles }, step.part([t; 2]))
    }
}

impl<S: Pieces<M, R>, M: PieceKind, R: Real, const K: usize> Alternation<S, R> for PieceSequence<S, M, R, K> {
    const INNER: usize = K;

    /// Flows of the first piece at frozen time are not merged, because the time differs. Solutions of an equation are not flows.
    #[inline(always)]
    fn are_merged(&self) -> bool {
        S::PIECES.len() > 1 && S::PIECES[0].clock == PieceClock::Own && !S::PIECES[0].solved
    }

    #[inline(always)]
    fn shows_middle_of_joint(&self) -> bool {
        false
    }

    #[inline(always)]
    fn outer<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        place: Outer,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        if !self.are_merged() {
            return Ok(());
        }
        let (flows, t) = match place {
            Outer::First => (&self.pairs[0].forth, step.t),
            Outer::Joint(i) => (&self.pairs[i].joint, step.t + self.pairs[i].middle),
            Outer::Last => (&self.pairs[K - 1].back, step.t + self.pairs[K - 1].middle),
        };
        step.probe.visit(t, &step.x.z, &step.x.s);
        self.apply(0..1, flows, [t; 2], &mut step)
    }

    #[inline(always)]
    fn inner<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        i: usize,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        let Pair { forth, back, start, middle, .. } = &self.pairs[i];
        let ([start, middle], all) = ([step.t + *start, step.t + *middle], S::PIECES.len());
        let first = usize::from(self.are_merged());
        if first == 0 {
            step.probe.visit(start, &step.x.z, &step.x.s);
        }
        self.apply(first..all, forth, [start, middle], &mut step)?;
        self.apply((first..all - 1).rev(), back, [middle; 2], &mut step)
    }
}

impl<S: Pieces<M, R>, M: PieceKind, R: Real, const K: usize> Method<S, R> for PieceComposition<K, M> {
    type Proof = <S as Pieces<M, R>>::Proof;
    type Prepared = PieceSequence<S, M, R, K>;
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
        PieceSequence::prepare(self, system, h)
    }

    fn memory(_: &S::Phase) -> Self::Memory {
        Open::unknown()
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        open: &mut Self::Memory,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        driver::step(prepared, open, step)
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
        driver::advance(prepared, open, system, clock, steps, x)
    }
}
