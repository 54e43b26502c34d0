//! Tables for any number of pieces.

use super::driver::{self, Splitting, merges, pass};
use super::splittings::{ContactSplitting, PieceSplitting};
use crate::method::composition::{Composition, SymmetricMap};
use crate::method::open::Open;
use crate::method::splitting::{DriftFirst, Nystrom, delegate};
use crate::method::tables::total::adds_up;
use crate::method::{Claims, Clock, Method, Name, Probe, Refusal, Step, Unwatched};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::{NystromPieces, Pieces, Poles};
use core::marker::PhantomData;

/// A table for any number of pieces: Φ*(β_K h) Φ(α_K h) … Φ*(β₁h) Φ(α₁h), K flows of the last piece a step.
///
/// Of the pieces of a contact system, or by [`of`](PieceComposition::of) of those of another splitting. For three pieces and more these
/// are better than compositions of [`ContactSplitting`]. S. Blanes, F. Casas & A. Murua,
/// arXiv:2006.06317; that tables for two pieces serve for any number: R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceComposition<const K: usize, M = ContactSplitting> {
    name: Name,
    order: u32,
    /// (α, β), in order of application.
    weights: [[f64; 2]; K],
    splitting: PhantomData<M>,
}

impl<const K: usize> PieceComposition<K> {
    /// A palindrome α₁, β₁, α₂, …, β_K given by its first half.
    pub(crate) const fn palindrome(name: &'static str, order: u32, half: [f64; K]) -> Self {
        let mut weights = [[0.0; 2]; K];
        let mut i = 0;
        while i < 2 * K {
            weights[i / 2][i % 2] = half[if i < K { i } else { 2 * K - 1 - i }];
            i += 1;
        }
        assert!(adds_up(weights.as_flattened(), 1.0), "the weights add up to 1");
        PieceComposition { name: Name::new(name), order, weights, splitting: PhantomData }
    }

    /// The same table for the pieces of another splitting.
    pub const fn of<M: Splitting>(self, _: M) -> PieceComposition<K, M> {
        let Self { name, order, weights, .. } = self;
        PieceComposition { name: name.of(Name::new(M::NAME)), order, weights, splitting: PhantomData }
    }
}

impl<const K: usize, M: Splitting> PieceComposition<K, M> {
    /// A composition of steps of order 2.
    pub(super) fn of_steps(composition: &Composition<K>) -> Self {
        let weights = composition.weights().map(|gamma| [0.5 * gamma; 2]);
        let name = composition.name().of(Name::new(M::NAME));
        PieceComposition { name, order: composition.order(), weights, splitting: PhantomData }
    }
}

impl SymmetricMap for PieceSplitting {
    type Composed<const K: usize> = PieceComposition<K, PieceSplitting>;

    fn compose<const K: usize>(self, composition: Composition<K>) -> PieceComposition<K, PieceSplitting> {
        PieceComposition::of_steps(&composition)
    }
}

impl<const K: usize, M> PieceComposition<K, M> {
    /// The order.
    pub const fn order(&self) -> u32 {
        self.order
    }

    /// (α, β), in order of application.
    pub const fn weights(&self) -> &[[f64; 2]; K] {
        &self.weights
    }
}

/// Φ(αh), then Φ*(βh).
#[derive(Clone, Copy, Debug)]
pub struct Pair<F, R> {
    forth: F,
    back: F,
    /// The first piece of Φ together with that of the Φ* before; in the first pair that of the step before.
    joint: F,
    /// Where Φ begins, and where it meets Φ*, after the start of the step; and where the joint piece begins.
    at: [R; 3],
    poles: Poles,
}

impl<S: Pieces<M, R>, M: Splitting, R: Real, const K: usize> Method<S, R> for PieceComposition<K, M> {
    type Proof = <S as Pieces<M, R>>::Proof;
    type Prepared = [Pair<S::Flows, R>; K];
    type Memory = Open<S::Phase, S::Action>;

    fn claims(&self) -> Claims {
        driver::claims::<S, M, R>(self.order, K as u32)
    }

    fn name(&self) -> Name {
        self.name
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        let poles = Poles::of(system);
        core::array::from_fn(|i| {
            let [alpha, beta] = self.weights[i];
            let joint = self.weights[(i + K - 1) % K][1] + alpha;
            let before: f64 = self.weights[..i].as_flattened().iter().sum();
            let part = |fraction: f64| R::from_f64(fraction) * h;
            let flows = |outer: f64, last: f64| system.prepare_flows(part(outer), part(last));
            Pair {
                forth: flows(alpha, alpha + beta),
                back: flows(beta, beta),
                joint: flows(joint, joint),
                at: [before, before + alpha, before + alpha - joint].map(part),
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
    ) -> Result<(), Refusal> {
        part::<S, M, R, C, P, K>(prepared, open, step, [true; 2])
    }

    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        prepared: &Self::Prepared,
        open: &mut Self::Memory,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Phase, C, S::Action>,
    ) -> Result<(), Refusal> {
        // In a local of this loop numbers stay in registers.
        let mut here = *x;
        for n in 0..steps {
            let [t, end] = [clock.at(n), clock.at(n + 1)];
            let step = Step { system, t, end, x: &mut here, probe: &mut Unwatched };
            part::<S, M, R, C, _, K>(prepared, open, step, [n == 0, n + 1 == steps])?;
        }
        *x = here;
        Ok(())
    }
}

/// A step. One that does not begin a call has for its first flow also the last one of the step before, and one that does not end it
/// leaves its own to the next.
#[inline(always)]
fn part<S: Pieces<M, R>, M: Splitting, R: Real, C: Summation<S::Phase>, P: Probe<S, R>, const K: usize>(
    prepared: &[Pair<S::Flows, R>; K],
    open: &mut Open<S::Phase, S::Action>,
    mut step: Step<'_, S, R, C, P>,
    [begins, ends]: [bool; 2],
) -> Result<(), Refusal> {
    let (all, joined) = (S::PIECES.len(), M::MERGES && merges::<S, M, R>());
    let ([t, end], reopened) = ([step.t, step.end], joined && (!begins || open.return_to(step.t, step.x).is_some()));
    for (i, Pair { forth, back, joint, at, poles }) in prepared.iter().enumerate() {
        let [start, middle, before] = at.map(|after| t + after);
        let frozen = [forth, back].map(|flows| step.system.freeze(flows, middle));
        step.probe.visit(start, &step.x.z, &step.x.s);
        let (first, from) = if joined && i > 0 || reopened { (joint, before) } else { (forth, start) };
        pass::<S, M, R, C, P>(0..1, (first, &frozen[0], poles), step.part([from; 2]))?;
        pass::<S, M, R, C, P>(1..all, (forth, &frozen[0], poles), step.part([start; 2]))?;
        pass::<S, M, R, C, P>((1..all - 1).rev(), (back, &frozen[1], poles), step.part([middle; 2]))?;
        let at_end = ends && i + 1 == K;
        if joined && !at_end {
            continue;
        }
        if joined {
            open.leave(step.x);
        }
        let last = 0..usize::from(all > 1);
        pass::<S, M, R, C, P>(last, (back, &frozen[1], poles), step.part([middle; 2]))?;
    }
    if joined && ends {
        open.end([t, end], step.x);
    }
    Ok(())
}

/// A table of Runge–Kutta–Nyström type for two pieces, A outside and B inside, with {B, {B, {B, A}}} = 0: its order conditions use that.
///
/// Of a drift and a kick with quadratic T it is the table itself. What else there is of that kind is proven, whatever the pieces are: a
/// charge in a field that depends on one coordinate, say, where one of the pieces moves one coordinate, and the other one the others.
/// By [`Nystrom::of`](crate::Nystrom::of).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceNystrom<const K: usize>(PieceComposition<K, PieceSplitting>);

impl<const K: usize> Nystrom<K, DriftFirst> {
    /// The same table for two pieces.
    pub const fn of(self, _: PieceSplitting) -> PieceNystrom<K> {
        let table = self.table();
        let (outer, _, inner) = table.coefficients();
        let (mut weights, mut back, mut i) = ([[0.0; 2]; K], 0.0, 0);
        while i < K {
            let forth = outer[i] - back;
            back = inner[i] - forth;
            weights[i] = [forth, back];
            i += 1;
        }
        let name = table.name().of(Name::new(PieceSplitting::NAME));
        PieceNystrom(PieceComposition { name, order: table.claims().order, weights, splitting: PhantomData })
    }
}

delegate!([const K: usize,] PieceNystrom<K>, NystromPieces, PieceComposition<K, PieceSplitting>, |this| this.0, this.0.name);
