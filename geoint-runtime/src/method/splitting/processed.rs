//! Tables with a processor: χ⁻¹ ∘ K ∘ … ∘ K ∘ χ. The kernel K is cheap. The processor χ is applied before the first step, and its inverse after the last.

use super::flows::Order;
use super::kicks::Weight;
use super::moving::{Moving, Times};
use super::sequence::Sequence;
use super::steps_of;
use super::table::Splitting;
use crate::method::tables::total::adds_up;
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step};
use crate::scalar::{Real, zero};
use crate::space::{Plain, Point, Summation};
use crate::system::{PhaseSpace, Separable};

/// A table with a processor of `P` pairs of flows, outer and inner, that is applied before the first step of a run.
///
/// The order is that of the processed method. A state is computed by the inverse processor on a copy of the moving point. Reading a state does not change
/// the run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProcessedSplitting<const K: usize, const P: usize, O> {
    table: Splitting<K, O>,
    order: u32,
    /// Pairs of the processor: fractions of h for the outer and the inner flow, and the fraction of h³ for the force gradient of the inner flow.
    processor: [[f64; 3]; P],
}

impl<const K: usize, const P: usize, O> ProcessedSplitting<K, P, O> {
    /// Returns a table with a processor. The fractions of the processor must add up to 0, so that it does not change the time.
    pub(in crate::method) const fn new(order: u32, table: Splitting<K, O>, processor: [[f64; 3]; P]) -> Self {
        let (mut outer, mut inner, mut i) = ([0.0; P], [0.0; P], 0);
        while i < P {
            (outer[i], inner[i]) = (processor[i][0], processor[i][1]);
            i += 1;
        }
        assert!(adds_up(&outer, 0.0) && adds_up(&inner, 0.0), "the fractions of a way add up to 0");
        ProcessedSplitting { table, order, processor }
    }
}

/// Coefficients of one pair of the processor. Entry 0 of the flows belongs to the processor, entry 1 to its inverse.
#[derive(Clone, Debug)]
struct Pair<A, B, R> {
    outer: [A; 2],
    inner: [B; 2],
    /// The clock of the outer flows before and after the outer flow of this pair.
    outer_at: [R; 2],
    /// The clock of the inner flows before and after the inner flow of this pair.
    inner_at: [R; 2],
}

/// Coefficients of the kernel and of the processor.
#[derive(Clone, Debug)]
pub struct Prepared<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize, const P: usize> {
    steps: Sequence<S, R, O, K>,
    processor: [Pair<O::Outer, O::Inner, R>; P],
}

impl<S, R, O, const K: usize, const P: usize> Prepared<S, R, O, K, P>
where
    S: Separable<R> + PhaseSpace<R, Action = ()>,
    R: Real,
    O: Order<S, R>,
{
    /// Applies the outer flow of the i-th pair of the processor (`back` = 0) or of its inverse (`back` = 1).
    fn outer(&self, i: usize, back: usize, system: &S, t: R, [q, p]: &mut S::Phase) {
        let Pair { outer, outer_at, inner_at, .. } = &self.processor[i];
        let at = Times { own: t + outer_at[back], other: t + inner_at[0] };
        O::outer::<Plain>(
            &outer[back],
            at,
            Moving { system, q, p, s: &mut (), sums: &mut Plain, compensation: &mut () },
        );
    }

    /// Applies the inner flow of the i-th pair of the processor (`back` = 0) or of its inverse (`back` = 1).
    fn inner(&self, i: usize, back: usize, system: &S, t: R, [q, p]: &mut S::Phase) {
        let Pair { inner, outer_at, inner_at, .. } = &self.processor[i];
        let at = Times { own: t + inner_at[back], other: t + outer_at[1] };
        O::inner::<Plain>(
            &inner[back],
            at,
            Moving { system, q, p, s: &mut (), sums: &mut Plain, compensation: &mut () },
        );
    }
}

impl<S, R, O, const K: usize, const P: usize> Method<S, R> for ProcessedSplitting<K, P, O>
where
    S: Separable<R> + PhaseSpace<R, Action = ()>,
    R: Real,
    O: Order<S, R>,
{
    type Proof = O::Proof;
    type Prepared = Prepared<S, R, O, K, P>;
    type Memory = <Splitting<K, O> as Method<S, R>>::Memory;
    const SINGLY: bool = true;
    const INNER: bool = true;

    fn claims(&self) -> Claims {
        Claims { order: self.order, symmetric: false, ..self.table.claims() }
    }

    fn name(&self) -> Name {
        self.table.name()
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        let part = |fraction: f64| R::from_f64(fraction) * h;
        let cube = h * h * h;
        let weight = |fraction: f64, gradient: f64| Weight {
            h: part(fraction),
            gradient: (gradient != 0.0).then(|| R::from_f64(gradient) * cube),
        };
        let outer = |a| O::prepare_outer(system, weight(a, 0.0));
        let inner = |b, g| O::prepare_inner(system, weight(b, g));
        let reached = |i: usize, which: usize| part(self.processor[..i].iter().map(|pair| pair[which]).sum());
        let pair = |i: usize| {
            let [a, b, g] = self.processor[i];
            let at = |which: usize| [reached(i, which), if i + 1 < P { reached(i + 1, which) } else { zero() }];
            Pair { outer: [outer(a), outer(-a)], inner: [inner(b, g), inner(-b, -g)], outer_at: at(0), inner_at: at(1) }
        };
        Prepared { steps: self.table.prepare(system, h), processor: core::array::from_fn(pair) }
    }

    fn memory() -> Self::Memory {
        Splitting::<K, O>::memory()
    }

    fn enter(prepared: &Self::Prepared, system: &S, t: R, z: &mut S::Phase) {
        for i in 0..P {
            prepared.outer(i, 0, system, t, z);
            prepared.inner(i, 0, system, t, z);
        }
    }

    fn leave(prepared: &Self::Prepared, system: &S, t: R, z: &mut S::Phase) {
        for i in (0..P).rev() {
            prepared.inner(i, 1, system, t, z);
            prepared.outer(i, 1, system, t, z);
        }
    }

    steps_of!(Splitting<K, O>, |prepared| &prepared.steps);
}
